// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <barrier>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <future>
#include <limits>
#include <memory>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/block_work.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/problem/with.hpp>

// A distributed problem without MPI: two threads, each with a part of the state, and a barrier between them.
namespace two_parts {

namespace sc = stagecraft;

using Eigen::MatrixXd;
using Eigen::VectorXd;

// What the two threads share. Every exchange is entered by both.
class meeting {
  public:
    // The parts of both, in order.
    VectorXd gather(int rank, const VectorXd& part) {
        board_[rank] = part;
        barrier_.arrive_and_wait();
        VectorXd both(board_[0].size() + board_[1].size());
        both << board_[0], board_[1];
        barrier_.arrive_and_wait();
        return both;
    }
    void add_up(int rank, double* x, int k) {
        const VectorXd both = gather(rank, Eigen::Map<const VectorXd>(x, k));
        for (int i = 0; i < k; ++i) x[i] = both[i] + both[i + k];
        ++sums[rank];
    }
    std::array<long, 2> sums{};

  private:
    std::barrier<> barrier_{2};
    std::array<VectorXd, 2> board_;
};

// Rows first, ..., first + rows - 1 of a matrix that both threads hold whole.
struct shared_matrix {
    MatrixXd whole;
    int rank, first, part;
    meeting* with;
    Eigen::Index rows() const { return part; }
    Eigen::Index cols() const { return part; }
    VectorXd gather(const double* x) const { return with->gather(rank, Eigen::Map<const VectorXd>(x, part)); }
    void add_times(double factor, const double* x, double* r) const {
        const VectorXd product = whole * gather(x);
        Eigen::Map<VectorXd>(r, part) += factor * product.segment(first, part);
    }
};

inline MatrixXd mass_of(const stagecraft::identity_mass&, Eigen::Index n) { return MatrixXd::Identity(n, n); }
inline MatrixXd mass_of(const stagecraft::mass_by_products<shared_matrix>& m, Eigen::Index) {
    return m.get().whole;
}

inline MatrixXd mass_of(const stagecraft::entry_mass<double>& mass, Eigen::Index n) {
    MatrixXd M = MatrixXd::Zero(n, n);
    for (const auto& e : mass.entries()) M(e.row, e.column) = e.value;
    return M;
}

// The problem that is not cut, in the same terms.
struct whole_matrix {
    const MatrixXd& whole;
    Eigen::Index part = whole.rows(), first = 0;
    explicit whole_matrix(const MatrixXd& J) : whole(J) {}
    VectorXd gather(const double* x) const { return Eigen::Map<const VectorXd>(x, part); }
};

// The whole system, factored by each thread for itself with Eigen's LU. The cost is constant per stage, as an iterative
// solver would say.
template <class Matrix, class Shared>
struct eigen_blocks {
    static stagecraft::block_work<double> work(int) { return {0, 100}; }

    template <class Number>
    class solver {
      public:
        explicit solver(int) {}

      protected:
        template <class Mass>
        bool factor(const Mass& mass, const Matrix& J, Number shift) {
            J_ = std::make_unique<Shared>(J);
            const Eigen::Index n = J_->whole.rows();
            lu_.compute(shift * mass_of(mass, n).template cast<Number>() - J_->whole.template cast<Number>());
            return true;
        }
        std::unique_ptr<Shared> J_;
        Eigen::PartialPivLU<Eigen::Matrix<Number, -1, -1>> lu_;
    };
    struct real : solver<double> {
        using solver<double>::solver;
        template <class Mass>
        bool factor_shifted(const Mass& mass, const Matrix& J, double shift) {
            return this->factor(mass, J, shift);
        }
        void solve(double* x) {
            const VectorXd solution = this->lu_.solve(this->J_->gather(x));
            Eigen::Map<VectorXd>(x, this->J_->part) = solution.segment(this->J_->first, this->J_->part);
        }
    };
    struct complex : solver<std::complex<double>> {
        using solver<std::complex<double>>::solver;
        template <class Mass>
        bool factor_shifted(const Mass& mass, const Matrix& J, double re, double im) {
            return this->factor(mass, J, {re, im});
        }
        void solve(double* x, double* y) {
            Eigen::VectorXcd r(this->J_->whole.rows());
            r.real() = this->J_->gather(x);
            r.imag() = this->J_->gather(y);
            const Eigen::VectorXcd all = this->lu_.solve(r),
                                   mine = all.segment(this->J_->first, this->J_->part);
            Eigen::Map<VectorXd>(x, this->J_->part) = mine.real();
            Eigen::Map<VectorXd>(y, this->J_->part) = mine.imag();
        }
    };
};
using gathered_blocks = eigen_blocks<shared_matrix, shared_matrix>;
using whole_blocks = eigen_blocks<MatrixXd, whole_matrix>;

// One of two parts of the problem Whole (f, jacobian, both dense).
template <class Whole>
struct part_of {
    using linear_solver = gathered_blocks;
    const Whole* whole;
    int rank, first, count;
    meeting* with;

    void add_up(double* x, int k) const { with->add_up(rank, x, k); }
    shared_matrix matrix() const { return {MatrixXd(), rank, first, count, with}; }
    void operator()(double t, const VectorXd& y, VectorXd& f) const {
        const VectorXd all = with->gather(rank, y);
        VectorXd out(all.size());
        (*whole)(t, all, out);
        f = out.segment(first, count);
        whole->complain(t, rank);
    }
    void jacobian(double t, const VectorXd& y, shared_matrix& J) const {
        const VectorXd all = with->gather(rank, y);
        J.whole.setZero(all.size(), all.size());
        whole->jacobian(t, all, J.whole);
    }
};
template <class Whole>
struct part_with_mass : part_of<Whole> {
    shared_matrix mass() const {
        return {this->whole->mass(), this->rank, this->first, this->count, this->with};
    }
    Eigen::VectorXi index() const { return this->whole->index().segment(this->first, this->count); }
};

// run(part, y0) in two threads, the state cut before component `cut`; their results in order. Fails where they have
// not ended within a time that a hundred runs would need.
template <template <class> class Part, class Whole, class Run>
auto in_two_threads(const Whole& whole, const VectorXd& y0, int cut, Run run, meeting& with) {
    const int n = static_cast<int>(y0.size());
    const auto start = [&](int rank) {
        const int first = rank == 0 ? 0 : cut, count = rank == 0 ? cut : n - cut;
        return std::async(std::launch::async, [=, &whole, &y0, &with] {
            Part<Whole> part{};
            part.whole = &whole;
            part.rank = rank;
            part.first = first;
            part.count = count;
            part.with = &with;
            return run(part, VectorXd(y0.segment(first, count)));
        });
    };
    auto one = start(0), two = start(1);
    for (auto* end : {&one, &two})
        if (end->wait_for(std::chrono::seconds(60)) != std::future_status::ready)
            std::abort();  // else it waits
    return std::array{one.get(), two.get()};
}

// What is to happen on part 1 from some time on.
struct mishap {
    double from = std::numeric_limits<double>::infinity();
    void complain(double t, int rank) const {
        if (rank == 1 && t > from) throw std::runtime_error("a mishap");
    }
};

// The one-dimensional Brusselator with k points (Hairer-Wanner II.IV.10): u and v of a point beside each other.
struct brusselator : mishap {
    int k = 8;
    double diffusion() const { return 0.02 * (k + 1) * (k + 1); }
    void operator()(double, const VectorXd& y, VectorXd& f) const {
        for (int i = 0; i < k; ++i) {
            const double u = y[2 * i], v = y[2 * i + 1];
            const auto at = [&](int j, int c, double edge) { return j < 0 || j >= k ? edge : y[2 * j + c]; };
            f[2 * i] = 1 + u * u * v - 4 * u + diffusion() * (at(i - 1, 0, 1) - 2 * u + at(i + 1, 0, 1));
            f[2 * i + 1] = 3 * u - u * u * v + diffusion() * (at(i - 1, 1, 3) - 2 * v + at(i + 1, 1, 3));
        }
    }
    void jacobian(double, const VectorXd& y, MatrixXd& J) const {
        for (int i = 0; i < k; ++i) {
            const double u = y[2 * i], v = y[2 * i + 1];
            J(2 * i, 2 * i) = 2 * u * v - 4 - 2 * diffusion();
            J(2 * i, 2 * i + 1) = u * u;
            J(2 * i + 1, 2 * i) = 3 - 2 * u * v;
            J(2 * i + 1, 2 * i + 1) = -u * u - 2 * diffusion();
            for (int c = 0; c < 2; ++c) {
                if (i > 0) J(2 * i + c, 2 * i + c - 2) = diffusion();
                if (i < k - 1) J(2 * i + c, 2 * i + c + 2) = diffusion();
            }
        }
    }
    VectorXd start() const {
        VectorXd y(2 * k);
        for (int i = 0; i < k; ++i) {
            y[2 * i] = 1 + std::sin(2 * M_PI * (i + 1) / (k + 1));
            y[2 * i + 1] = 3;
        }
        return y;
    }
};

// Index 1: Robertson's reaction with its conservation law as third equation. Index 2: the pendulum with the constraint
// on its velocity, x y u v lambda.
struct algebraic : mishap {
    int largest = 1;
    void operator()(double, const VectorXd& y, VectorXd& f) const {
        if (largest == 1) {
            const double slow = 0.04 * y[0], fast = 3e7 * y[1] * y[1], middle = 1e4 * y[1] * y[2];
            f << -slow + middle, slow - middle - fast, y[0] + y[1] + y[2] - 1;
        } else {
            f << y[2], y[3], -y[4] * y[0], -y[4] * y[1] - 1, y[0] * y[2] + y[1] * y[3];
        }
    }
    void jacobian(double, const VectorXd& y, MatrixXd& J) const {
        if (largest == 1) {
            J << -0.04, 1e4 * y[2], 1e4 * y[1], 0.04, -1e4 * y[2] - 6e7 * y[1], -1e4 * y[1], 1, 1, 1;
        } else {
            J << 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, -y[4], 0, 0, 0, -y[0], 0, -y[4], 0, 0, -y[1], y[2], y[3], y[0],
                y[1], 0;
        }
    }
    MatrixXd mass() const {
        const VectorXd d = largest == 1 ? VectorXd{{1, 1, 0}} : VectorXd{{1, 1, 1, 1, 0}};
        return d.asDiagonal();
    }
    Eigen::VectorXi index() const {
        return largest == 1 ? Eigen::VectorXi{{1, 1, 1}} : Eigen::VectorXi{{1, 1, 1, 1, 2}};
    }
    VectorXd start() const { return largest == 1 ? VectorXd{{1, 0, 0}} : VectorXd{{1, 0, 0, 0, 0}}; }
};

// The whole problem and its two parts take the same steps, to the same state but for the rounding of sums; the parts
// agree in every bit of what they decide.
template <template <class> class Part, class Whole, class Method>
inline std::array<long, 2> same_steps(const Method& method, const Whole& problem, double t1, int cut,
                                      const sc::options<double>& o) {
    const VectorXd y0 = problem.start();
    const auto whole = sc::integrate(method, sc::with_linear_solver<whole_blocks>(problem), y0, 0.0, t1, o);
    meeting with;
    const auto parts = in_two_threads<Part>(
        problem, y0, cut,
        [&](const auto& part, const VectorXd& y) { return sc::integrate(method, part, y, 0.0, t1, o); },
        with);
    BOOST_TEST(whole.ok());
    VectorXd both(y0.size());
    both << parts[0].y, parts[1].y;
    for (const auto& part : parts) {
        BOOST_TEST(part.ok());
        BOOST_TEST(part.report.steps == whole.report.steps);
        BOOST_TEST(part.report.rejected() == whole.report.rejected());
        BOOST_TEST(part.report.solves == whole.report.solves);
        BOOST_TEST(part.report.jacobians == whole.report.jacobians);
        BOOST_TEST(part.report.largest_step == parts[0].report.largest_step);
        BOOST_TEST(part.report.found.has(sc::capability::add_up));
        BOOST_TEST(part.report.found.has(sc::capability::matrix));
    }
    for (int i = 0; i < both.size(); ++i)
        BOOST_TEST(std::abs(both[i] - whole.y[i]) <= 1e-3 * (o.atol + o.rtol * std::abs(whole.y[i])));
    BOOST_TEST(with.sums[0] == with.sums[1]);
    return {whole.report.steps, with.sums[0]};
}

inline const sc::options<double> usual{.rtol = 1e-6, .atol = 1e-8};

}  // namespace two_parts
