// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/paths/equilibrium.hpp>
#include <stagecraft/bvp/paths/multipliers.hpp>
#include <stagecraft/dense_output.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/problem/two_point_functions.hpp>

namespace stagecraft::detail {

/// How a periodic orbit y over [0, 1] goes round: its mean, and how far from that it is at equally many times.
template <class Vector>
struct orbit_swing {
    using scalar = typename Vector::Scalar;
    static constexpr int times = 64;
    Vector mean;
    Eigen::Matrix<scalar, Vector::RowsAtCompileTime, times> off;

    template <class Orbit>
    explicit orbit_swing(const Orbit& y) : mean(y(scalar(0))), off(mean.size(), times) {
        for (int k = 0; k < times; ++k) off.col(k) = y(scalar(scalar(k) / times));
        mean = off.rowwise().mean();
        off.colwise() -= mean;
    }
    /// The mean of the products: the square of the amplitude where both are the same, and negative where one orbit is
    /// half a turn ahead of the other.
    scalar with(const orbit_swing& other) const { return off.cwiseProduct(other.off).sum() / times; }
};

/// A Hopf point of y' = f(y, p): an equilibrium where a pair of eigenvalues of f_y passes the imaginary axis, at +- i omega. A
/// path of periodic orbits ends there, their parameter and period being p_H + O(a^2) and 2 pi/omega + O(a^2) with the
/// amplitude a (Kuznetsov 2004, section 3.5). p is found by the secant method for the real part along the path of
/// equilibria, and is thus as accurate as f_y, whatever the orbits are known to.
///
/// The functions are T f(y, p) with the parameters (T, p), as orbit_continuation has them; their conditions are not looked at.
template <class Vector, class Parameters>
class hopf_search {
    using scalar = typename Vector::Scalar;
    using functions = two_point_functions<scalar, Vector::RowsAtCompileTime, Parameters::RowsAtCompileTime>;
    using complex = std::complex<scalar>;
    using dense = Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>;

  public:
    Vector y;
    scalar p{0}, period{0};
    scalar change{0};  ///< of p in the last step: how far p may be off
    std::vector<floquet_multiplier<scalar>> multipliers;

    explicit hopf_search(functions& system) : n_(system.size()), rest_(system) {}

    /// From an equilibrium near `from` at `first`, where orbits nearby take `turn` to come round; the Hopf point is
    /// expected at `second`.
    bool run(const Vector& from, const scalar& turn, const scalar& first, const scalar& second) {
        using std::abs;
        rest_.y = from, p = first, omega_ = full_turn() / turn;
        scalar before(0), growth_before(0), growth(0);
        if (!rest_.find(p) || !pair(growth_before)) return false;
        before = std::exchange(p, second);
        if (p == before) p += scalar(1e-4) * (1 + abs(p));
        for (int k = 0; k < 30; ++k) {
            if (!rest_.find(p) || !pair(growth)) return false;
            const scalar step = growth * (p - before) / (growth - growth_before);
            // Where steps no longer shrink, or growth stays as it was, rounding errors decide.
            if (growth == growth_before || (k > 2 && abs(step) >= change / 2)) break;
            change = abs(step);
            before = std::exchange(p, scalar(p - step));
            growth_before = growth;
            if (change <= 4 * std::numeric_limits<scalar>::epsilon() * abs(p)) break;
        }
        y = rest_.y, period = full_turn() / omega_;
        if (!(change - change == scalar(0))) return false;
        find_multipliers();
        return true;
    }

    /// The equilibrium as an orbit over [0, 1].
    solution<Vector> orbit() const {
        interpolation_nodes<scalar, dynamic> at(1);
        at.size = 1;
        at.c[0] = scalar(1);
        at.finish();
        dense_output<Vector, dynamic> piece(n_, 1);
        piece.cover(at, scalar(0), scalar(1), y);
        piece.increments().setZero();
        solution<Vector> constant;
        constant.start(scalar(0), y, scalar(1));
        constant(scalar(1), y, scalar(1), piece);
        return constant;
    }

  private:
    static scalar full_turn() {
        using std::atan;
        return 8 * atan(scalar(1));
    }

    /// The eigenvalues at the equilibrium; those nearest to i omega are the pair.
    bool pair(scalar& growth) {
        const Eigen::EigenSolver<dense> solver(rest_.f_y, false);
        if (solver.info() != Eigen::Success) return false;
        values_.assign(solver.eigenvalues().data(), solver.eigenvalues().data() + n_);
        const complex nearest =
            *std::min_element(values_.begin(), values_.end(), [&](const complex& a, const complex& b) {
                return std::abs(a - complex(0, omega_)) < std::abs(b - complex(0, omega_));
            });
        growth = nearest.real(), omega_ = nearest.imag();
        return omega_ > scalar(0);
    }

    void find_multipliers() {
        multipliers.clear();
        const scalar epsilon = std::numeric_limits<scalar>::epsilon();
        for (const complex& value : values_) {
            const complex factor = std::exp(value * period);
            const scalar error = 100 * epsilon + period * change;
            multipliers.push_back({factor, error * std::abs(factor), value * period, error});
        }
        std::sort(multipliers.begin(), multipliers.end(),
                  [](const auto& a, const auto& b) { return std::abs(a.value) > std::abs(b.value); });
    }

    int n_;
    equilibrium<Vector, Parameters, functions> rest_;
    std::vector<complex> values_;
    scalar omega_{0};
};

}  // namespace stagecraft::detail
