// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <stdexcept>
#include <vector>

#include <stagecraft/break_points.hpp>
#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/jacobian/coloured.hpp>
#include <stagecraft/jacobian/finite_difference.hpp>
#include <stagecraft/linear/linear_solve.hpp>
#include <stagecraft/problem/capabilities.hpp>
#include <stagecraft/problem/distributed.hpp>
#include <stagecraft/problem/domain_border.hpp>
#include <stagecraft/problem/jacobian_matrix.hpp>
#include <stagecraft/problem/make_mass.hpp>
#include <stagecraft/problem/unwritten.hpp>
#include <stagecraft/refuse/problem/checked_capabilities.hpp>
#include <stagecraft/refuse/problem/checked_values.hpp>
#include <stagecraft/report.hpp>

namespace stagecraft {

/// A component of index 2 or 3 and the power of h by which its error counts, 1 or 2.
struct raised_component {
    int component, power;
};

namespace detail {

/// Lives as long as the run does, and measures it if the problem asks for it.
template <class Problem>
struct run_time {
    explicit run_time(Problem&) {}
};
template <has_stopwatch Problem>
struct run_time<Problem> {
    decltype(std::declval<Problem&>().measure(work::run)) lap;
    explicit run_time(Problem& problem) : lap(problem.measure(work::run)) {}
};

/// The optional members that the problem has, but for its Jacobian.
template <class Problem, class Vector>
constexpr found_capabilities found_in() {
    found_capabilities all;
    const auto add = [&](bool there, capability c) {
        if (there) all.add(c);
    };
    add(has_mass<Problem>, capability::mass);
    add(has_index<Problem>, capability::index);
    add(has_constant_jacobian<Problem>, capability::constant_jacobian);
    add(has_second_order_components<Problem>, capability::second_order_components);
    add(has_bandwidth<Problem>, capability::bandwidth);
    add(has_sparsity<Problem>, capability::sparsity);
    add(has_matrix<Problem>, capability::matrix);
    add(has_linear_solver<Problem>, capability::linear_solver);
    add(has_add_up<Problem, typename Vector::Scalar>, capability::add_up);
    add(has_stopwatch<Problem>, capability::measure);
    add(has_break_points<Problem>, capability::break_points);
    add(has_domain<Problem, Vector>, capability::domain);
    return all;
}

}  // namespace detail

/// A problem as the steppers see it: counted evaluations, the best Jacobian it can give (its own member, else
/// automatic differentiation, else finite differences), the mass matrix, the index flags.
template <class Problem, class Vector>
class system
    : checked_capabilities<Problem, Vector,
                           decltype(detail::make_jacobian<Problem, Vector>(std::declval<Problem&>(), 0))>,
      detail::checked_distribution<
          Problem, typename Vector::Scalar,
          has_jacobian<Problem, Vector,
                       decltype(detail::make_jacobian<Problem, Vector>(std::declval<Problem&>(), 0))>> {
  public:
    using scalar = typename Vector::Scalar;
    using problem_type = Problem;
    static constexpr int size_at_compile_time = Vector::RowsAtCompileTime;
    using matrix = decltype(detail::make_jacobian<Problem, Vector>(std::declval<Problem&>(), 0));
    using blocks = typename detail::blocks_for<std::remove_const_t<Problem>, matrix>::type;
    using mass_type = decltype(make_mass<scalar>(std::declval<Problem&>(), 0));
    using sums_type = decltype(sums_over<scalar>(std::declval<Problem&>()));
    using border_type = std::conditional_t<sums_type::complete, domain_border<Vector>, no_domain_border>;
    /// The entries of the Jacobian cannot be looked at.
    static constexpr bool opaque = has_matrix<Problem>;
    static constexpr bool structured = opaque || has_bandwidth<Problem> || has_sparsity<Problem>;
    static constexpr bool analytic = has_jacobian<Problem, Vector, matrix>;
    static constexpr bool automatic =
        !analytic && !structured && automatically_differentiable<Problem, scalar, size_at_compile_time>;
    static constexpr bool finite_difference = !analytic && !automatic;
    /// There is an explicit_part(); everything else here is about the implicit one.
    static constexpr bool has_explicit_part = in_parts<Problem>;
    static_assert(linear_solver<blocks, mass_type, matrix, scalar>,
                  "Problem::linear_solver: its types real and complex need a constructor from int, "
                  "factor_shifted(M, J, "
                  "shift) and solve(x), factor_shifted(M, J, re, im) and solve(re, im) "
                  "(linear/linear_solver.hpp); bool is what factor_shifted returns");

    system(Problem& problem, const Vector& y0, report<scalar>& r)
        : problem_(problem),
          run_time_(problem),
          report_(r),
          n_(static_cast<int>(y0.size())),
          mass_(make_mass<scalar>(problem, n_)),
          engine_(size_at_compile_time == Eigen::Dynamic ? 0 : n_),
          J_(detail::make_jacobian<Problem, Vector>(problem, n_)) {
        report_.found = detail::found_in<Problem, Vector>();
        static_assert(has_entries<mass_type> || has_linear_solver<Problem>,
                      "problem.mass() with add_times needs a linear_solver of the problem's own");
        detail::demand_mass_fits<Problem>(mass_, J_, n_);
        if constexpr (has_index<Problem>) {
            detail::demand_index_flags(problem.index(), n_, mass_type::identity);
            for (int i = 0; i < n_; ++i) {
                const int index = problem.index()[i];
                if (index > 1) raised_.push_back({i, index - 1});
                if (index > largest_index_) largest_index_ = index;
            }
        }
    }

    Problem& problem() { return problem_; }
    int size() const { return n_; }
    /// What the norms of states take.
    sums_type sums() const { return sums_over<scalar>(problem_); }
    /// What is known of the state here, and later what all processes know.
    joint_state extent() const { return {largest_index_, all_}; }
    void set_extent(const joint_state& all) {
        largest_index_ = all.largest_index;
        all_ = all.size;
    }
    /// Number of components on all processes.
    int total_size() const { return all_; }
    /// True if a call has thrown on another process. What a call has thrown here leaves now. One sum; free in runs
    /// that are not distributed, where it has left already.
    bool failed_elsewhere() { return failure_.anywhere(sums()); }
    const mass_type& mass() const { return mass_; }
    const matrix& jacobian() const { return J_; }
    /// A matrix of zeros in the structure of the Jacobian.
    matrix zeros() const {
        static_assert(!opaque, "the entries of problem.matrix() are not known");
        if constexpr (structured) {
            matrix zero = J_;
            zero.setZero();
            return zero;
        } else {
            return matrix::Zero(n_, n_);
        }
    }

    /// Allocates all that evaluate_jacobian() needs, n x n numbers if J is dense. To be called once before
    /// it; runs of explicit methods never do.
    void take_jacobian() {
        report_.found.jacobian = analytic    ? jacobian_source::member
                                 : automatic ? jacobian_source::automatic_differentiation
                                             : jacobian_source::differences;
        if constexpr (size_at_compile_time == Eigen::Dynamic) engine_ = engine(n_);
        if constexpr (!structured) J_.setZero(n_, n_);
        if constexpr (structured && finite_difference) engine_.group(J_);
    }

    /// Does what `f` does. What it throws is kept in a distributed run: this process takes part in what follows.
    template <class F>
    void keep(F&& f) const {
        failure_.keep(f);
    }
    /// True if f() is, on every process. Where it throws on one process it is false.
    template <class F>
    bool succeeds(F&& f) const {
        scalar failed(1);
        keep([&] { failed = scalar(f() ? 0 : 1); });
        sums()(&failed, 1);
        return failed == scalar(0);
    }
    /// Whether y is finite on every process, and nothing has been thrown that not all know of.
    bool finite(const Vector& y) const {
        if (!failure_.here()) return all_finite(y, n_, sums());
        scalar failed = std::numeric_limits<scalar>::quiet_NaN();
        sums()(&failed, 1);
        return false;
    }

    /// Does what `f` does, timed if the problem asks for it.
    template <class F>
    decltype(auto) measure([[maybe_unused]] work kind, F&& f) const {
        if constexpr (has_stopwatch<Problem>) {
            [[maybe_unused]] const auto lap = problem_.measure(kind);
            return f();
        } else {
            return f();
        }
    }

    /// Takes in what a linear solver tells of its last solve, and the calls of f that products with J have taken.
    void took(const linear_solve& solve) const {
        report_.linear_iterations += solve.iterations;
        if (solve.failed()) {
            ++report_.linear_failures;
            report_.linear_trouble =
                solve.end == linear_end::bad_preconditioner ? unsolved_because::bad_preconditioner
                : solve.end == linear_end::zero_diagonal    ? unsolved_because::zero_diagonal
                                                            : unsolved_because::slow;
        }
        count_products();
    }

    /// f(t, y), counted; continued beyond the border of its domain where that is watched.
    [[gnu::always_inline]] void operator()(const scalar& t, const Vector& y, Vector& f) {
        call(t, y, f);
        if constexpr (sums_type::complete)
            if (border_.watched()) [[unlikely]]
                border_.extend(*this, t, y, f);
    }
    /// The same, for what is done once a step: the machine code of f stands here once for all.
    [[gnu::noinline]] void evaluate(const scalar& t, const Vector& y, Vector& f) { (*this)(t, y, f); }
    /// The same without a continuation: f is not finite beyond its border.
    [[gnu::noinline]] void evaluate_inside(const scalar& t, const Vector& y, Vector& f) { call(t, y, f); }
    /// call(problem) of a method that knows more of a problem than f; counted as an evaluation of f if `counts`.
    template <class Call>
    [[gnu::always_inline]] void evaluate_part(Call&& call, bool counts) {
        report_.f += counts ? 1 : 0;
        failure_.keep([&] { measure(work::f, [&] { call(problem_); }); });
    }
    /// The run ends at t1, where f is told `inside`, the time before: what f does from t1 on belongs to another run.
    void ends_at(const scalar& t1, const scalar& inside) { end_ = t1, inside_ = inside; }
    /// The border of the domain of f, once a run has met it.
    border_type& border() { return border_; }
    /// f := the explicit part at (t, y), counted.
    void explicit_part(const scalar& t, const Vector& y, Vector& f) const requires has_explicit_part {
        ++report_.f_explicit;
        // clang 14 instantiates it with the class although its constraint is not satisfied.
        if constexpr (has_explicit_part) counted(f, [&] { problem_.explicit_part(told(t), y, f); });
    }
    /// Adds the explicit part, where there is one, to f.
    void add_explicit_part(const scalar& t, const Vector& y, Vector& f) const {
        if constexpr (has_explicit_part) {
            Vector part(n_);
            explicit_part(t, y, part);
            f += part;
        }
    }

  private:
    /// f(t, y) itself. NaN where a call has thrown and the other processes have not heard of it yet.
    [[gnu::always_inline]] void call(const scalar& t, const Vector& y, Vector& f) {
        if constexpr (has_explicit_part) ++report_.f_implicit;
        counted(f, [&] { problem_(told(t), y, f); });
    }
    const scalar& told(const scalar& t) const { return t == end_ ? inside_ : t; }
    /// evaluate(), which writes f.
    template <class Evaluate>
    [[gnu::always_inline]] void counted(Vector& f, Evaluate&& evaluate) const {
        ++report_.f;
        expect_written(f);
        if constexpr (sums_type::complete && !has_stopwatch<Problem>) {
            evaluate();
            check_size(f);
        } else {
            failure_.keep([&] {
                measure(work::f, evaluate);
                check_size(f);
            });
            if constexpr (!sums_type::complete)
                if (failure_.here()) f.setConstant(n_, std::numeric_limits<scalar>::quiet_NaN());
        }
    }

  public:
    /// Evaluates the Jacobian at (t, y); f0 = f(t, y), `negligible` and, in a first step, `reach` serve finite
    /// differences only.
    void evaluate_jacobian(const scalar& t, const Vector& y, const Vector& f0, const Vector& negligible,
                           const scalar& reach = scalar(0)) {
        ++report_.jacobians;
        if constexpr (analytic) {
            failure_.keep([&] {
                measure(work::jacobian, [&] { problem_.jacobian(told(t), y, J_); });
                if constexpr (size_at_compile_time == Eigen::Dynamic)
                    if (J_.rows() != n_ || J_.cols() != n_) throw size_change{};
            });
            count_products();
        } else if constexpr (automatic) {
            report_.f_jacobian +=
                measure(work::jacobian, [&] { return engine_(problem_, told(t), y, f0, J_); });
        } else {
            report_.f_jacobian += measure(
                work::jacobian, [&] { return engine_(problem_, told(t), y, f0, negligible, reach, J_); });
        }
    }

    /// Whether the entries of the Jacobian are finite, on every process; true where they cannot be looked at.
    bool finite_jacobian() const {
        scalar bad(0);
        if constexpr (has_sparsity<Problem> && !opaque)
            bad = scalar(J_.coeffs().allFinite() ? 0 : 1);
        else if constexpr (!opaque)
            bad = scalar(J_.allFinite() ? 0 : 1);
        sums()(&bad, 1);
        return bad == scalar(0);
    }

    /// The Jacobian as it is kept (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(J_);
    }

    /// The components of index 2 and 3, of which there are none where the problem has no index().
    static constexpr bool may_be_raised = has_index<Problem>;
    const std::vector<raised_component>& raised() const { return raised_; }
    /// Calls visit(i, k - 1) for every component i of index k = 2 or 3.
    template <class Visit>
    void for_each_raised(Visit visit) const {
        for (const auto& r : raised_) visit(r.component, r.power);
    }

    /// The largest index flag: 1, 2 or 3. Above 1 the norms depend on the step size.
    int largest_index() const { return has_index<Problem> ? largest_index_ : 1; }
    /// Extrapolated stages may be noisy: with index 2 and 3, and with linear solvers that iterate.
    bool rough_stages() const { return iterative_blocks<blocks, scalar> || largest_index() > 1; }

    /// The error of what the problem carries along, more than y (sensitivities), where that of y is `error` < 1: of a
    /// measured_step. 0 where there is no more.
    template <class Method, class Step>
    scalar further_error([[maybe_unused]] Method& method, [[maybe_unused]] const Step& step) {
        if constexpr (requires { problem_.further_error(*this, method, step); })
            return problem_.further_error(*this, method, step);
        else
            return scalar(0);
    }

    /// bad_problem if f0 = f(t0, y0) is not what second_order_components promises.
    void demand_second_order([[maybe_unused]] const Vector& f0, [[maybe_unused]] const Vector& y) const {
        if constexpr (has_second_order_components<Problem>)
            for (int i = 0, m = position_components<Problem>(n_); i < m; ++i)
                if (!(f0[i] == y[m + i]))
                    throw bad_problem(
                        "integrate: problem.second_order_components does not hold: f_i is not y_{m+i}");
    }

    /// True if the problem has no domain, or y lies in it, on every process.
    bool inside([[maybe_unused]] const scalar& t, [[maybe_unused]] const Vector& y) const {
        if constexpr (has_domain<Problem, Vector>)
            return succeeds([&] { return static_cast<bool>(problem_.domain(t, y)); });
        else
            return true;
    }
    static constexpr bool excludes_states = has_domain<Problem, Vector>;
    /// Clips components of y below zero by less than atol(i) where the problem says so; how many.
    template <class Tolerance>
    long clip([[maybe_unused]] Vector& y, [[maybe_unused]] const Tolerance& atol) const {
        if constexpr (clips)
            return problem_.clip(y, atol);
        else
            return 0;
    }
    static constexpr bool clips = requires(Problem & p, Vector& y, scalar (*atol)(Eigen::Index)) {
        p.clip(y, atol);
    };

    bool constant_jacobian() {
        if constexpr (has_constant_jacobian<Problem>)
            return problem_.constant_jacobian();
        else
            return false;
    }

  private:
    void count_products() const {
        if constexpr (requires { J_.take_calls(); }) report_.f_jacobian += J_.take_calls();
    }
    void check_size(const Vector& f) const {
        if constexpr (size_at_compile_time == Eigen::Dynamic)
            if (f.size() != n_) throw size_change{};
    }
    struct no_engine {
        explicit no_engine(int) {}
    };
    using engine = std::conditional_t<
        analytic, no_engine,
        std::conditional_t<automatic, automatic_jacobian<scalar, size_at_compile_time>,
                           std::conditional_t<structured, coloured_jacobian<Vector>,
                                              finite_difference_jacobian<scalar, size_at_compile_time>>>>;

    Problem& problem_;
    [[no_unique_address]] detail::run_time<Problem> run_time_;
    report<scalar>& report_;
    scalar end_ = std::numeric_limits<scalar>::quiet_NaN(), inside_{};  // equal to no time before ends_at()
    int n_;
    mass_type mass_;
    [[no_unique_address]] engine engine_;
    matrix J_;
    std::vector<raised_component> raised_;
    int largest_index_ = 1, all_ = n_;
    [[no_unique_address]] border_type border_;
    [[no_unique_address]] mutable shared_failure<scalar, sums_type> failure_;
};

}  // namespace stagecraft
