// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/existence/nearby_method.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <set>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/exact_tableau.hpp"
#include "stagecraft/tableaux/rough_ball.hpp"
#include "stagecraft/tableaux/time_share.hpp"
#include "stagecraft/theory/existence/entry_polynomial.hpp"
#include "stagecraft/theory/existence/slope.hpp"
#include "stagecraft/theory/statements/certainty.hpp"

namespace stagecraft::theory {

namespace detail {

using long_matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using long_vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

STAGECRAFT_INLINE tableaux::ball ball_of(long double x) {
    int e = 0;
    const long double f = std::frexp(x, &e);
    constexpr int p = 64;
    return {tableaux::ball::mantissa(std::ldexp(f, p)), e - p, 0, p};
}

/// The unknowns and equations of a search, as both become fewer.
class method_search {
  public:
    method_search(const order_system& system, nearby_method& found)
        : system_(system), found_(found), numbers_(system.method().numbers) {}

    /// Solves over Q what can be, and leaves out what follows by linear algebra over Q; false where the equations contradict
    /// each other, or what is written.
    bool eliminate() {
        for (bool changed = true; changed;) {
            changed = false;
            open_.clear();
            independent_polynomials others;
            word_values<entry_polynomial> values(system_.method(), system_.words(),
                                                 unknowns_as_polynomials());
            for (std::size_t e = 0; e < system_.equations().size() && !changed; ++e) {
                tableaux::time_share::check_now();
                const auto p = others.take(
                    system_.residual(system_.equations()[e], values,
                                     [](const tableaux::rational& q) { return entry_polynomial(q); }));
                if (p.is_zero() || vanishes_in_surds(p)) continue;
                if (!p.is_too_long() && p.terms().rbegin()->first.empty()) {
                    found_.why_not = "exact entries contradict " + system_.name(system_.equations()[e]);
                    return false;
                }
                if (const auto root = p.root_of_one()) {
                    if (!put(root->first, root->second, e)) return false;
                    changed = true;
                }
                open_.push_back(e);
            }
        }
        for (std::size_t i = 0; i < numbers_.size(); ++i)
            if (!numbers_[i].known && !numbers_[i].surd) unknowns_.push_back(i);
        return true;
    }

    /// Chooses independent equations and the unknowns to solve for at this point.
    void choose(const std::vector<tableaux::ball>& at) {
        long_matrix J = middles(derivative(at, open_, unknowns_));
        for (Eigen::Index j = 0; j < J.cols(); ++j) {
            const auto size = at[unknowns_[static_cast<std::size_t>(j)]].magnitude();
            if (size > 0) J.col(j) *= size;
        }
        for (Eigen::Index i = 0; i < J.rows(); ++i)
            if (const long double size = J.row(i).norm(); size > 0) J.row(i) /= size;
        const auto rows = independent_rows(J);
        equations_.clear();
        left_.clear();
        columns_.clear();
        for (std::size_t i = 0; i < open_.size(); ++i)
            (std::find(rows.begin(), rows.end(), static_cast<Eigen::Index>(i)) != rows.end() ? equations_
                                                                                             : left_)
                .push_back(open_[i]);
        if (rows.empty()) return;
        long_matrix chosen(static_cast<Eigen::Index>(rows.size()), J.cols());
        for (std::size_t i = 0; i < rows.size(); ++i)
            chosen.row(static_cast<Eigen::Index>(i)) = J.row(rows[i]);
        const Eigen::ColPivHouseholderQR<long_matrix> qr(chosen);
        for (std::size_t i = 0; i < rows.size(); ++i)
            columns_.push_back(unknowns_[static_cast<std::size_t>(
                qr.colsPermutation().indices()(static_cast<Eigen::Index>(i)))]);
    }

    /// Of the equations left out those that follow from the others as polynomials: u F is a sum of multiples of the others,
    /// where u is 1 or a number that is not zero. Multiples by products of one or two unknowns are looked at.
    void deduce(const std::vector<tableaux::ball>& at) {
        if (left_.empty()) return;
        word_values<entry_polynomial> values(system_.method(), system_.words(), unknowns_as_polynomials());
        const auto polynomial = [&](std::size_t e) {
            return system_.residual(system_.equations()[e], values,
                                    [](const tableaux::rational& q) { return entry_polynomial(q); });
        };
        std::vector<entry_polynomial> known;
        for (const std::size_t e : equations_) known.push_back(polynomial(e));
        try {
            const tableaux::time_share share(tableaux::time_share::left() / 4);
            for (std::size_t i = 0; i < left_.size();) {
                const auto p = polynomial(left_[i]);
                if (!follows(p, known, at)) {
                    ++i;
                    continue;
                }
                known.push_back(p);
                left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
            }
        } catch (const tableaux::out_of_time&) {  // what is left is not deduced
        }
    }

    std::vector<tableaux::ball> start(int bits) const {
        std::vector<tableaux::ball> all;
        for (const auto& x : numbers_)
            all.push_back(x.surd ? tableaux::to_ball(*x.surd, bits) : tableaux::ball(x.value, bits));
        return all;
    }

    /// Goes to about the nearest zero, in units of what each number may be off: steps of least norm of all unknowns.
    void approach(std::vector<tableaux::ball>& at, int bits) const {
        const auto n = static_cast<Eigen::Index>(unknowns_.size());
        if (equations_.empty()) return;
        long_vector off(n);
        for (Eigen::Index j = 0; j < n; ++j)
            off[j] = numbers_[unknowns_[static_cast<std::size_t>(j)]].radius.template to<long double>();
        const long double most = off.maxCoeff();
        for (Eigen::Index j = 0; j < n; ++j) off[j] = most > 0 ? std::max(off[j] / most, 1e-4L) : 1;
        const long_matrix J = middles(derivative(at, equations_, unknowns_)) * off.asDiagonal();
        const Eigen::CompleteOrthogonalDecomposition<long_matrix> nearest(J);
        for (int turn = 0; turn < 3; ++turn) {
            word_values<tableaux::ball> values(system_.method(), system_.words(), at);
            long_vector f(static_cast<Eigen::Index>(equations_.size()));
            for (std::size_t i = 0; i < equations_.size(); ++i)
                f[static_cast<Eigen::Index>(i)] =
                    tableaux::rough_ball(residual(equations_[i], values)).middle();
            const long_vector step = off.asDiagonal() * long_vector(nearest.solve(f));
            if (!step.allFinite()) return;
            for (Eigen::Index j = 0; j < n; ++j) {
                auto& x = at[unknowns_[static_cast<std::size_t>(j)]];
                x = (x - ball_of(step[j])).with_bits(bits).midpoint();
            }
        }
    }

    /// Newton's iteration with the inverse in long double; whether it got to the end.
    bool polish(std::vector<tableaux::ball>& at, int bits) {
        tableaux::bound before = 1;
        for (int turn = 0; turn < 20 + bits / 20; ++turn) {
            tableaux::time_share::check_now();
            if (turn < 6) invert(at);
            if (!inverse_.allFinite()) return false;
            const auto step = newton_step(at, equations_);
            tableaux::bound size = 0;
            for (std::size_t i = 0; i < columns_.size(); ++i) {
                auto& x = at[columns_[i]];
                x = (x - step[i]).with_bits(bits).midpoint();
                size = std::max(size, step[i].upper_magnitude());
            }
            if (size <= std::ldexp(tableaux::bound(1), 24 - bits)) return true;
            if (turn > 8 && size > before / 2) return size <= std::ldexp(tableaux::bound(1), 54 - bits);
            before = size;
        }
        return false;
    }

    /// Krawczyk's operator on a box about `at`; the box becomes part of `at` where it proves a zero.
    bool prove(std::vector<tableaux::ball>& at) {
        invert(at);
        const auto step = newton_step(at, equations_);
        tableaux::bound most = std::ldexp(tableaux::bound(1), -16000);
        for (const auto& x : step) most = std::max(most, x.upper_magnitude());
        const tableaux::bound radius = tableaux::upward(2 * most);
        auto box = at;
        for (const std::size_t i : columns_) box[i] = box[i].widened(radius);
        const auto J = derivative(box, equations_, columns_);
        for (Eigen::Index i = 0; i < inverse_.rows(); ++i) {
            tableaux::bound sum = 0;
            for (Eigen::Index j = 0; j < inverse_.rows(); ++j) {
                tableaux::rough_ball x(i == j ? 1 : 0);
                for (Eigen::Index k = 0; k < inverse_.rows(); ++k) x -= rough_inverse_(i, k) * J(k, j);
                sum = tableaux::upward(sum + x.magnitude());
            }
            found_.contraction = std::max(found_.contraction, sum);
        }
        if (!(found_.contraction < 0.25L)) return false;  // |K(X) - m| <= most + radius/4 < radius
        at = std::move(box);
        found_.enclosed_to = radius;
        return true;
    }

    void tell(const std::vector<tableaux::ball>& at) {
        found_.equations = open_.size();
        found_.solved = equations_.size();
        found_.unknowns = unknowns_.size();
        word_values<tableaux::ball> values(system_.method(), system_.words(), at);
        for (const std::size_t e : left_) {
            found_.not_solved.push_back(system_.name(system_.equations()[e]));
            found_.left = std::max(found_.left, residual(e, values).upper_magnitude());
        }
        found_.numbers = at;
    }
    bool all() const { return left_.empty(); }

  private:
    using rough_matrix = Eigen::Matrix<tableaux::rough_ball, Eigen::Dynamic, Eigen::Dynamic>;

    tableaux::ball residual(std::size_t e, word_values<tableaux::ball>& values) const {
        int most = 64;
        for (std::size_t i = 0; i < numbers_.size(); ++i) most = std::max(most, values.number(i).bits());
        return system_.residual(system_.equations()[e], values,
                                [&](const tableaux::rational& q) { return tableaux::ball(q, most); });
    }
    bool follows(const entry_polynomial& p, const std::vector<entry_polynomial>& known,
                 const std::vector<tableaux::ball>& at) const {
        if (p.is_too_long()) return false;
        std::set<std::size_t> in_p;
        for (const auto& [product, x] : p.terms()) in_p.insert(product.begin(), product.end());
        std::vector<entry_polynomial> multipliers{entry_polynomial(1)};
        for (const std::size_t u : in_p) multipliers.push_back(entry_polynomial::unknown(u));
        for (int degree = 1; degree <= 2; ++degree) {
            independent_polynomials others;
            std::size_t count = 0;
            for (const auto& m : multipliers)
                for (const auto& f : known) {
                    tableaux::time_share::check_now();
                    if (count++ < most_multiples) others.take(m * f);
                }
            for (std::size_t u = 0; u <= in_p.size(); ++u) {
                const auto& m = multipliers[u];
                if (u > 0 && !certainly_nonzero(at[m.terms().begin()->first.front()])) continue;
                if (others.rest(m * p).is_zero()) return true;
            }
            const std::size_t linear = multipliers.size();
            for (std::size_t i = 1; i < linear; ++i)
                for (std::size_t j = i; j < linear; ++j)
                    multipliers.push_back(multipliers[i] * multipliers[j]);
        }
        return false;
    }
    static constexpr std::size_t most_multiples = 6000;

    std::vector<entry_polynomial> unknowns_as_polynomials() const {
        std::vector<entry_polynomial> all;
        for (std::size_t i = 0; i < numbers_.size(); ++i)
            all.push_back(numbers_[i].known ? entry_polynomial(numbers_[i].value)
                                            : entry_polynomial::unknown(i));
        return all;
    }
    /// A polynomial in numbers that are all known as surds, and in these is zero.
    bool vanishes_in_surds(const entry_polynomial& p) const {
        if (p.is_too_long()) return false;
        tableaux::quadratic sum(0);
        try {
            for (const auto& [product, by] : p.terms()) {
                tableaux::quadratic term(by);
                for (const std::size_t i : product) {
                    if (!numbers_[i].surd) return false;
                    term *= *numbers_[i].surd;
                }
                sum += term;
            }
        } catch (const tableaux::mixed_surds&) {
            return false;
        }
        return sum == tableaux::quadratic(0);
    }
    /// An equation gives this number; false where it is not what is written.
    bool put(std::size_t number, const tableaux::rational& value, std::size_t e) {
        auto& x = numbers_[number];
        if (x.surd || abs(value - x.value) > x.radius * tableaux::rational(64)) {
            found_.why_not = system_.name(system_.equations()[e]) + " gives " + x.name + " = " + value.str() +
                             ", which is not what is written";
            return false;
        }
        x.value = value;
        x.known = true;
        return true;
    }
    rough_matrix derivative(const std::vector<tableaux::ball>& at, const std::vector<std::size_t>& equations,
                            const std::vector<std::size_t>& columns) const {
        using number = slope<tableaux::rough_ball>;
        rough_matrix J(static_cast<Eigen::Index>(equations.size()),
                       static_cast<Eigen::Index>(columns.size()));
        std::vector<number> all;
        for (const auto& x : at) all.emplace_back(tableaux::rough_ball(x), tableaux::rough_ball(0));
        for (std::size_t j = 0; j < columns.size(); ++j) {
            tableaux::time_share::check_now();
            auto numbers = all;
            numbers[columns[j]].rate = tableaux::rough_ball(1);
            word_values<number> values(system_.method(), system_.words(), std::move(numbers));
            for (std::size_t i = 0; i < equations.size(); ++i)
                J(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                    system_
                        .residual(system_.equations()[equations[i]], values,
                                  [](const tableaux::rational& q) {
                                      return number(tableaux::rough_ball(tableaux::ball(q, 64)),
                                                    tableaux::rough_ball(0));
                                  })
                        .rate;
        }
        return J;
    }
    static long_matrix middles(const rough_matrix& J) {
        return J.unaryExpr([](const tableaux::rough_ball& x) { return x.middle(); })
            .template cast<long double>();
    }
    /// Rows of norm 1, the first ones that are independent: what is left of each orthogonally to those before, or nothing.
    std::vector<Eigen::Index> independent_rows(const long_matrix& J) {
        std::vector<Eigen::Index> rows;
        std::vector<long_vector> basis;
        found_.least_pivot = 1;
        for (Eigen::Index i = 0; i < J.rows(); ++i) {
            long_vector v = J.row(i).transpose();
            for (int twice = 0; twice < 2; ++twice)
                for (const auto& b : basis) v -= b.dot(v) * b;
            const long double left = v.norm();
            if (left < smallest_pivot) {
                found_.next_pivot = std::max(found_.next_pivot, left);
                continue;
            }
            found_.least_pivot = std::min(found_.least_pivot, left);
            basis.push_back(v / left);
            rows.push_back(i);
        }
        return rows;
    }
    static constexpr long double smallest_pivot = 1e-9L;

    void invert(const std::vector<tableaux::ball>& at) {
        const long_matrix J = middles(derivative(at, equations_, columns_));
        inverse_ = J.rows() == 0 ? J : long_matrix(Eigen::PartialPivLU<long_matrix>(J).inverse());
        rough_inverse_.resize(inverse_.rows(), inverse_.cols());
        ball_inverse_.clear();
        if (!inverse_.allFinite()) return;
        for (Eigen::Index i = 0; i < inverse_.rows(); ++i) {
            ball_inverse_.emplace_back();
            for (Eigen::Index j = 0; j < inverse_.cols(); ++j) {
                ball_inverse_.back().push_back(ball_of(inverse_(i, j)));
                rough_inverse_(i, j) = tableaux::rough_ball(ball_inverse_.back().back());
            }
        }
    }
    std::vector<tableaux::ball> newton_step(const std::vector<tableaux::ball>& at,
                                            const std::vector<std::size_t>& equations) const {
        word_values<tableaux::ball> values(system_.method(), system_.words(), at);
        std::vector<tableaux::ball> f, step;
        for (const std::size_t e : equations) f.push_back(residual(e, values));
        for (std::size_t i = 0; i < f.size(); ++i) {
            tableaux::ball sum(0);
            for (std::size_t j = 0; j < f.size(); ++j) sum += ball_inverse_[i][j] * f[j];
            step.push_back(sum);
        }
        return step;
    }

    const order_system& system_;
    nearby_method& found_;
    std::vector<sought_number> numbers_;
    std::vector<std::size_t> open_, unknowns_, equations_, columns_, left_;
    long_matrix inverse_;
    rough_matrix rough_inverse_;
    std::vector<std::vector<tableaux::ball>> ball_inverse_;
};

}  // namespace detail

STAGECRAFT_INLINE nearby_method find_nearby(const order_system& system, int digits) {
    nearby_method found;
    detail::method_search search(system, found);
    if (!search.eliminate()) return found;
    const int bits = tableaux::bits_for_digits(digits) + 64;
    auto at = search.start(bits);
    search.choose(at);
    search.approach(at, bits);
    if (!search.polish(at, bits)) {
        found.why_not = "Newton's iteration from these entries does not converge";
        search.tell(at);
        return found;
    }
    found.exists = search.prove(at);
    if (found.exists) search.deduce(at);
    if (!found.exists)
        found.why_not = "Krawczyk's operator does not map a box about these entries into itself";
    search.tell(at);
    for (const auto& [x, y] : system.distinct())
        if (!certainly_nonzero(at[x] - at[y])) found.exists = false;
    found.all_equations = found.exists && search.all();
    return found;
}

}  // namespace stagecraft::theory
