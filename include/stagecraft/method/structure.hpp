// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// What a method makes of the errors of algebraic components.
enum class algebraic_errors {
    none,  ///< it cannot have such components: A without a left end is singular
    stay,  ///< |R(infinity)| >= 1
    decay  ///< |R(infinity)| < 1
};

/// How the stages of a tableau can be solved, from the zeros among its entries.
struct tableau_structure {
    bool lower = true;        ///< A is lower triangular: explicit, DIRK, SDIRK, ESDIRK
    bool left_stage = false;  ///< the first stage is the left end of the step (first row of A, c_1 zero)
    bool stiffly_accurate = false;  ///< last row of A equals b and c_s = 1, so that y1 = Y_s
    algebraic_errors errors = algebraic_errors::none;

    /// A without a left end is regular.
    bool regular() const { return errors != algebraic_errors::none; }
    /// No errors of algebraic components stay.
    bool forgets() const { return errors != algebraic_errors::stay; }
    /// The last stage of a step is the first one of the next.
    bool first_same_as_last() const { return left_stage && stiffly_accurate; }
};

namespace detail {

/// The largest |R(infinity)| that counts as smaller than one: what rounding leaves of one does not.
template <class Scalar>
Scalar largest_damping() {
    using std::sqrt;
    return Scalar(1) - sqrt(std::numeric_limits<Scalar>::epsilon());
}

}  // namespace detail

/// Examines the entries; zero means exactly zero. If there is a left stage, let a_1 be the rest of the first
/// column and A_r the rest of A: `carry` becomes (1, -A_r^-1 a_1) if A_r is regular, else zeros.
template <class Scalar, int Stages>
tableau_structure structure_of(const tableau<Scalar, Stages>& m, Eigen::Matrix<Scalar, Stages, 1>& carry) {
    using std::abs;
    const int s = m.stages();
    tableau_structure is;
    is.left_stage = m.c[0] == Scalar(0);
    is.stiffly_accurate = m.stiffly_accurate() && m.c[s - 1] == Scalar(1);
    Scalar largest(0);
    for (int i = 0; i < s; ++i)
        for (int j = 0; j < s; ++j) {
            if (j > i && !(m.A(i, j) == Scalar(0))) is.lower = false;
            if (i == 0 && !(m.A(i, j) == Scalar(0))) is.left_stage = false;
            if (abs(m.A(i, j)) > largest) largest = abs(m.A(i, j));
        }
    const int first = is.left_stage ? 1 : 0, n = s - first;
    std::vector<Scalar> a(static_cast<std::size_t>(n * n)), x(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        x[i] = is.left_stage ? Scalar(-m.A(first + i, 0)) : Scalar(1);
        for (int j = 0; j < n; ++j) a[i + j * n] = m.A(first + i, first + j);
    }
    carry.setZero(s);
    if (n == 0) return is;
    for (int k = 0; k < n; ++k) {
        int p = k;
        for (int i = k + 1; i < n; ++i)
            if (abs(a[i + k * n]) > abs(a[p + k * n])) p = i;
        if (!(abs(a[p + k * n]) > detail::condition_tolerance<Scalar>() / Scalar(1000) * largest)) return is;
        std::swap(x[k], x[p]);
        for (int j = 0; j < n; ++j) std::swap(a[k + j * n], a[p + j * n]);
        for (int i = k + 1; i < n; ++i) {
            const Scalar f = a[i + k * n] / a[k + k * n];
            x[i] -= f * x[k];
            for (int j = k + 1; j < n; ++j) a[i + j * n] -= f * a[k + j * n];
        }
    }
    for (int k = n - 1; k >= 0; --k) {
        for (int j = k + 1; j < n; ++j) x[k] -= a[k + j * n] * x[j];
        x[k] /= a[k + k * n];
    }
    Scalar r(is.left_stage ? 0 : 1);  // R(infinity), where y1 = Y_s if the left end is a stage
    if (is.left_stage) {
        carry[0] = Scalar(1);
        for (int k = 0; k < n; ++k) carry[first + k] = x[k];
        if (is.stiffly_accurate) r = x[n - 1];
    } else {
        for (int k = 0; k < n; ++k) r -= m.b[k] * x[k];
    }
    is.errors = abs(r) < detail::largest_damping<Scalar>() ? algebraic_errors::decay : algebraic_errors::stay;
    return is;
}

/// Returns the method itself if its parts fit together, its entries are finite and its weights are those of a
/// consistent method. Otherwise throws std::invalid_argument that names the part.
template <class Scalar, int Stages>
const tableau<Scalar, Stages>& checked(const tableau<Scalar, Stages>& m) {
    const auto demand = [](bool good, const char* what) {
        if (!good) throw std::invalid_argument(what);
    };
    const auto s = m.b.size(), e = m.b_embedded.size();
    demand(s > 0, "integrate: method must have at least one stage");
    demand(m.A.rows() == s && m.A.cols() == s, "integrate: method.A must be s x s with s the size of b");
    demand(m.c.size() == s, "integrate: method.c must have the size of b");
    demand(e == 0 || e == s, "integrate: method.b_embedded must be empty or have the size of b");
    Scalar defect(0), embedded(0), difference(0);  // finite only if every entry is
    bool without_c = true;
    for (Eigen::Index i = 0; i < s; ++i) {
        defect += (m.b[i] - m.b[i]) + (m.c[i] - m.c[i]);
        without_c = without_c && m.c[i] == Scalar(0);
        for (Eigen::Index j = 0; j < s; ++j) defect += m.A(i, j) - m.A(i, j);
        if (e == 0) continue;
        using std::abs;
        defect += m.b_embedded[i] - m.b_embedded[i];
        embedded += m.b_embedded[i];
        difference += abs(m.b_embedded[i] - m.b[i]);
    }
    demand(defect == Scalar(0), "integrate: method must have finite entries");
    demand(!without_c || m.A.isZero(Scalar(0)),
           "integrate: method.c is zero and method.A is not: set c = A 1");
    demand(quadrature_conditions(m, 1) == 1, "integrate: method.b must sum to one");
    demand(e == 0 || detail::holds(embedded, Scalar(1)), "integrate: method.b_embedded must sum to one");
    demand(e == 0 || difference > Scalar(0), "integrate: method.b_embedded must differ from b");
    return m;
}

}  // namespace stagecraft
