// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <optional>
#include <stagecraft/tableaux/complex_roots.hpp>
#include <stagecraft/tableaux/polynomial.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/tableaux/routh_hurwitz.hpp>
#include <stagecraft/theory/statements/certainty.hpp>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// A pole of R or an eigenvalue of A: an enclosure, the exact value where it is known (rational, or in the
/// quadratic field of the tableau), and the multiplicity. Of a complex pair only the member above the real
/// axis is kept.
struct spectral_value {
    tableaux::complex_ball value;
    std::optional<tableaux::quadratic> exact;
    int multiplicity = 1;
    bool is_real() const { return value.im.exactly_zero(); }
};

/// Real values increasing, then pairs by increasing imaginary part.
using spectrum = std::vector<spectral_value>;

/// Decimal digits that a certificate shows.
inline constexpr int spectrum_digits = 12;
/// Largest number of stages whose eigenvalues and poles a certificate encloses: some ten milliseconds there.
inline constexpr int largest_spectrum = 20;

/// What a certificate says of the eigenvalues of A and the poles of R in lowest terms; where it says nothing
/// or has to restrict what it says, the reason is in `note`.
struct spectra {
    std::optional<spectrum> eigenvalues;
    std::optional<spectrum> poles;
    std::string note;
};

std::string beyond_largest_spectrum();

/// The number of values, those of a pair and multiplicities counted.
int count(const spectrum& all);

namespace detail {

inline tableaux::ball exact_to_ball(const tableaux::rational& x, int bits) { return {x, bits}; }
tableaux::ball exact_to_ball(const tableaux::quadratic& x, int bits);

template <class K>
spectral_value exactly(const K& x, int multiplicity, int bits) {
    return {{exact_to_ball(x, bits), 0}, tableaux::quadratic(x), multiplicity};
}

void sort(spectrum& all);

// Long double, in which the search for the roots begins, has to hold them and their powers.
void require_moderate(const std::vector<tableaux::ball>& coefficients);

/// Roots of a squarefree monic factor without the root 0. Where a real part is not told from zero, the exact
/// number of roots on the imaginary axis decides.
template <class K>
spectrum simple_roots(const tableaux::polynomial<K>& factor, int multiplicity, int bits) {
    if (factor.degree() == 1) return {exactly(K(0) - factor[0], multiplicity, bits)};
    std::vector<tableaux::ball> a;
    for (const K& x : factor.coefficients()) a.push_back(exact_to_ball(x, bits));
    require_moderate(a);
    const auto found = tableaux::locate_roots(a, bits);
    spectrum all;
    for (const auto& x : found.real) {
        tableaux::rational simplest(0);  // no root
        if (certainly_positive(x)) simplest = tableaux::simplest_between(x.lower(), x.upper());
        if (certainly_negative(x)) simplest = -tableaux::simplest_between(-x.upper(), -x.lower());
        if (factor(K(simplest)) == K(0))
            all.push_back(exactly(K(simplest), multiplicity, bits));
        else
            all.push_back({{x, 0}, {}, multiplicity});
    }
    int open = 0;
    for (const auto& z : found.upper) {
        if (!certainly_nonzero(z.re)) ++open;
        all.push_back({z, {}, multiplicity});
    }
    if (open == 0) return all;
    if (count_half_planes(factor).axis != 2 * open)
        throw tableaux::undecided("a real part is not told from zero");
    for (auto& v : all)
        if (!certainly_nonzero(v.value.re)) v.value.re = 0;
    return all;
}

}  // namespace detail

/// All roots of p with their multiplicities, proved (tableaux::locate_roots on the factors of Yun's split,
/// exactly coprime and squarefree). Throws undecided where 1024 bits do not suffice or the coefficients
/// exceed the range of long double.
template <class K>
spectrum roots_of(const tableaux::polynomial<K>& p) {
    int zeros = 0;
    while (p[zeros] == K(0)) ++zeros;
    const tableaux::polynomial<K> rest(
        std::vector<K>(p.coefficients().begin() + zeros, p.coefficients().end()));
    for (int bits = 128 + 8 * p.degree();; bits *= 2) {
        try {
            spectrum all;
            if (zeros > 0) all.push_back(detail::exactly(K(0), zeros, bits));
            if (rest.degree() > 0)
                for (const auto& [factor, multiplicity] : squarefree_split(rest))
                    for (auto& v : detail::simple_roots(factor, multiplicity, bits))
                        all.push_back(std::move(v));
            detail::sort(all);
            return all;
        } catch (const tableaux::undecided&) {
            if (bits > 512) throw;
        }
    }
}

/// The eigenvalues of a lower triangular A: its diagonal; for rounded data as it is written. Multiplicities
/// count equal entries.
template <class K>
spectrum diagonal_of(const Eigen::Matrix<K, -1, -1>& A) {
    const auto equal = [](const K& x, const K& y) {
        if constexpr (exact_scalar<K>)
            return x == y;
        else
            return x.middle() == y.middle() && x.radius() == y.radius();
    };
    std::vector<std::pair<K, int>> values;
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        auto at = std::find_if(values.begin(), values.end(),
                               [&](const auto& v) { return equal(v.first, A(i, i)); });
        if (at == values.end()) at = values.insert(at, {A(i, i), 0});
        ++at->second;
    }
    spectrum all;
    for (const auto& [x, multiplicity] : values) {
        if constexpr (exact_scalar<K>)
            all.push_back(detail::exactly(x, multiplicity, checker_bits));
        else
            all.push_back({{x, 0}, {}, multiplicity});
    }
    detail::sort(all);
    return all;
}

/// 1/x for every x other than 0. Throws undecided where an enclosure does not tell.
spectrum reciprocals(const spectrum& all);

namespace detail {

spectrum with_zeros(spectrum all, int multiplicity);

/// Eigenvalues from det(I - zA) = q of an s x s matrix, of which `poles` are the roots of a factor.
template <class K>
spectrum eigenvalues_of(const tableaux::polynomial<K>& q, int s, const spectrum& poles) {
    const bool all = count(poles) == q.degree();
    return with_zeros(reciprocals(all ? poles : roots_of(q)), s - q.degree());
}

/// "2.68108287363": correctly rounded; where the enclosure leaves that open, its middle "+- radius".
std::string digits_of(const tableaux::ball& x);
bool is_certain(const tableaux::ball& x);

}  // namespace detail

/// "3.63783425274, 2.68108287363 +- 3.05043019925 i"; multiplicities above 1 are said; "none" without values.
std::string text(const spectrum& all);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/stability/spectrum-inl.hpp"
#endif
