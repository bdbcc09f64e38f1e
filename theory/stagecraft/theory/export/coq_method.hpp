// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/family.hpp>
#include <stagecraft/tableaux/legendre.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/small_solve.hpp>
#include <stagecraft/theory/models/legendre_model.hpp>
#include <stagecraft/theory/models/stage_algebra.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// A method as an exported proof has it: how A and b act on coordinates of stage vectors, and how these are multiplied.
/// The coordinates are the stages themselves (`table`), or coefficients of a polynomial in the nodes, modulo x^s - N(x)
/// (`collocation`, where nodes are all that is written; `acts`, where alpha and beta are). All over Q(sqrt(d)). A model of
/// stage_algebra that does what the Coq file does, step by step.
class coq_method {
  public:
    using scalar = tableaux::quadratic;
    using element = std::vector<scalar>;
    enum class kind { table, collocation, acts };

    kind which = kind::table;
    std::uint64_t radicand = 0;  ///< d, 0 where everything is rational
    std::vector<element> alpha;  ///< A times the k-th basis vector
    element beta;                ///< b^T of the k-th basis vector
    element nodal;               ///< N, empty for a table
    element nodes;               ///< c, as coordinates
    std::string family;          ///< "gauss", or empty

    int stages() const { return static_cast<int>(beta.size()); }
    bool is_table() const { return which == kind::table; }
    element one() const {
        element v(beta.size(), scalar(is_table() ? 1 : 0));
        v[0] = scalar(1);
        return v;
    }
    element c() const { return nodes; }
    element apply(const element& v) const {
        element r(v.size());
        for (std::size_t k = 0; k < v.size(); ++k) {
            if (v[k] == 0) continue;
            for (std::size_t i = 0; i < v.size(); ++i)
                if (!(alpha[k][i] == 0)) r[i] += alpha[k][i] * v[k];
        }
        return r;
    }
    scalar dot_b(const element& v) const {
        scalar sum(0);
        for (std::size_t i = 0; i < v.size(); ++i)
            if (!(v[i] == 0)) sum += beta[i] * v[i];
        return sum;
    }
    element times_x(element v) const {
        const scalar top = v.back();
        v.insert(v.begin(), scalar(0));
        v.pop_back();
        for (std::size_t i = 0; i < v.size(); ++i) v[i] += top * nodal[i];
        return v;
    }
    element multiply(element u, const element& v) const {
        if (is_table()) {
            for (std::size_t i = 0; i < u.size(); ++i) u[i] *= v[i];
            return u;
        }
        element product(v.size());
        for (std::size_t k = u.size(); k-- > 0;) {
            product = times_x(std::move(product));
            for (std::size_t i = 0; i < v.size(); ++i) product[i] += u[k] * v[i];
        }
        return product;
    }
    /// The matrix of A in these coordinates, for what is computed of matrices.
    tableaux::dense<scalar> matrix() const {
        tableaux::dense<scalar> m(stages(), stages());
        for (int i = 0; i < stages(); ++i)
            for (int k = 0; k < stages(); ++k)
                m(i, k) = alpha[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
        return m;
    }
};

/// The method of a tableau with the weights given. Throws std::invalid_argument where the entries need two surds, which
/// no exported file has.
template <class Weights>
coq_method coq_method_of(const tableau<tableaux::quadratic>& t, const Weights& weights) {
    coq_method m;
    const auto taken = [&m](const tableaux::quadratic& x) {
        const auto surds = x.surds();
        if (surds.size() > 1 || (!surds.empty() && m.radicand != 0 && m.radicand != surds[0].radicand))
            throw std::invalid_argument(
                "coq: entries with two square roots, which the exported proofs do not have");
        if (!surds.empty()) m.radicand = surds[0].radicand;
        return x;
    };
    const int s = static_cast<int>(weights.size());
    for (int k = 0; k < s; ++k) {
        m.alpha.emplace_back();
        for (int i = 0; i < s; ++i) m.alpha.back().push_back(taken(t.A(i, k)));
        m.beta.push_back(taken(weights(k)));
        m.nodes.push_back(t.c(k));
    }
    return m;
}

/// A family's member in Q[x] modulo its nodal polynomial: no node is computed. O(s^3) operations.
/// Throws std::invalid_argument where the family has no member with s stages.
inline coq_method coq_method_of(tableaux::family f, int s) {
    using tableaux::rational;
    const tableaux::nodal_polynomial w(f, s);
    const legendre_model<rational> model(f, s);
    coq_method m;
    m.family = std::string(tableaux::name(f));
    m.which = tableaux::construction_of(f) == tableaux::construction::collocation
                  ? coq_method::kind::collocation
                  : coq_method::kind::acts;
    const auto n = static_cast<std::size_t>(s);
    const auto& monomial = w.monomial();
    for (int k = 0; k < s; ++k) m.nodal.push_back(-monomial[k] / monomial.leading());
    auto power = model.one();  // x^k in Legendre coordinates
    for (int k = 0; k < s; ++k) {
        m.beta.push_back(model.dot_b(power));
        const auto image = tableaux::from_legendre(model.apply(power));
        coq_method::element column(n);
        for (int i = 0; i < s; ++i) column[static_cast<std::size_t>(i)] = image[i];
        m.alpha.push_back(std::move(column));
        power = model.multiply(model.c(), power);
    }
    m.nodes = m.times_x(m.one());
    return m;
}

}  // namespace stagecraft::theory
