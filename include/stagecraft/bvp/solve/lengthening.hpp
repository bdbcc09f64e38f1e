// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include <stagecraft/bvp/result.hpp>

namespace stagecraft::detail {

/// Differences between the solutions on two intervals from a on, over the shorter of them; `global` beside `floor` + |y|.
template <class Result>
struct gap_between {
    using scalar = typename Result::scalar;
    scalar global{0}, floor, end, errors;
    Eigen::Matrix<scalar, Eigen::Dynamic, 1> components, parameters;

    gap_between(const Result& shorter, const Result& longer, const scalar& least)
        : floor(least),
          end(shorter.mesh.back()),
          errors(2 * (shorter.error.global + longer.error.global)),
          components(shorter.error.components.size()),
          parameters(shorter.p.size()) {
        components.setZero();
        for (std::size_t i = 0; i + 1 < shorter.mesh.size(); ++i)
            for (const scalar& part : {scalar(0), scalar(1) / 2}) {
                const scalar t = shorter.mesh[i] + part * (shorter.mesh[i + 1] - shorter.mesh[i]);
                look(shorter.y(t), longer.y(t), components);
            }
        look(shorter.y(end), longer.y(end), components);  // where it is most, as a rule
        parameters.setZero();
        look(shorter.p, longer.p, parameters);
    }
    /// Counts `off` as a difference as well, beside a solution y.
    template <class Vector>
    void widen(const Vector& off, const Vector& y) {
        look(Vector(y + off), y, components);
    }
    /// What the errors of both do not explain.
    scalar beyond_errors() const { return std::max(scalar(global - errors), scalar(0)); }

  private:
    template <class A, class B>
    void look(const A& a, const B& b, Eigen::Matrix<scalar, Eigen::Dynamic, 1>& largest) {
        using std::abs;
        for (Eigen::Index c = 0; c < a.size(); ++c) {
            const scalar d = abs(a[c] - b[c]);
            largest[c] = std::max(largest[c], d);
            global = std::max(global, scalar(d / (floor + abs(b[c]))));
        }
    }
};

inline void add_work(bvp_report& all, const bvp_report& one) {
    all.meshes += one.meshes, all.intervals = one.intervals, all.newton_steps += one.newton_steps;
    all.f += one.f, all.f_jacobian += one.f_jacobian, all.jacobians += one.jacobians;
    all.factorisations += one.factorisations, all.solves += one.solves;
    all.error_solves += one.error_solves, all.conditioning_solves += one.conditioning_solves;
}

/// The mesh of the solution on [a, T] carried on to `end` by intervals as long as the last of it, eight at most. That of
/// several pieces, which are solved on one mesh, has the points of all of them: one in so many is left.
template <class Scalar>
std::vector<Scalar> lengthened_mesh(std::vector<Scalar> mesh, const Scalar& end, int most, int pieces) {
    std::vector<Scalar> left{mesh.front()};
    for (std::size_t i = 1; i + 1 < mesh.size(); ++i)  // times of pieces may be one in rounding
        if (i % static_cast<std::size_t>(pieces) == 0 && mesh[i] > left.back() && mesh[i] < mesh.back())
            left.push_back(mesh[i]);
    left.push_back(mesh.back());
    mesh = std::move(left);
    const Scalar from = mesh.back(), last = from - mesh[mesh.size() - 2];
    const int more = std::clamp(static_cast<int>((end - from) / last), 1, 8);
    for (int k = 1; k < more; ++k) mesh.push_back(from + (end - from) * Scalar(k) / Scalar(more));
    mesh.push_back(end);
    if (static_cast<int>(mesh.size()) > most / pieces) mesh.clear();
    return mesh;
}

/// How y - limit falls from one interval to the next. What falls exponentially, however slowly, falls like a higher power of the
/// length the longer the interval is, which no power does. What falls by less than half and not like that, three times, is no
/// approach.
template <class Scalar>
struct slow_approach {
    Scalar rate{0}, power{0};
    int times = 0;

    /// The largest |y - limit| near the ends of two intervals, and their lengths.
    void look(const Scalar& before, const Scalar& now, const Scalar& shorter, const Scalar& longer) {
        using std::log;
        using std::sqrt;
        const Scalar falls = now > Scalar(0) ? Scalar(log(before / now)) : Scalar(100),
                     by_length = falls / log(longer / shorter),
                     least = std::max(Scalar(sqrt(longer / shorter) * power), Scalar(1e-6));
        times = falls < Scalar(log(Scalar(2))) ? times + (by_length > least ? 0 : 1) : 0;
        power = by_length, rate = falls / (longer - shorter);
    }
    bool stays() const { return times >= 3; }
    /// Why the search ends, beside the rate of the eigenvalues.
    std::string in_words(const Scalar& modes) const {
        std::ostringstream text;
        text.precision(2);
        if (!stays())
            text << "y - limit falls like exp(-" << rate
                 << " t), far more slowly than the eigenvalues of f_y at limit tell, exp(-" << modes
                 << " t), and no interval tried is long enough: give b";
        else
            text << "the solution found on finite intervals does not approach limit as they grow: over the "
                    "last one y - limit falls at the rate "
                 << rate << ", by the eigenvalues of f_y at limit at the rate " << modes;
        return text.str();
    }
};

}  // namespace stagecraft::detail
