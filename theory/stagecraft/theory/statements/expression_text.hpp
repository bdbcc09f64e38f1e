// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/statements/expression_node.hpp>
#include <stagecraft/theory/trees/tree_text.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace stagecraft::theory {

namespace detail {

// How tightly a written expression holds together; a sum sign reaches over what follows it.
enum binding { additive, open_sum, multiplicative, atomic };
struct formula {
    std::string text;
    binding strength = atomic;

    std::string at_least(binding needed, const char* left = "(", const char* right = ")") const;
    std::string latex_at_least(binding needed) const { return at_least(needed, "\\bigl(", "\\bigr)"); }
    /// Behind something else: a minus sign would be read as a difference.
    std::string latex_behind(binding needed) const;
};

/// Two factors in LaTeX: a number behind another factor has a dot before it.
std::string latex_product(const std::string& left, const std::string& right);

// Source text: what is printed compiles, up to the _q of quotients. (Member functions, so that they see one
// another whatever their order.)
struct in_source {
    static formula of(map_A) { return {"A"}; }
    static formula of(unit_vector) { return {"one"}; }
    static formula of(node_vector) { return {"c"}; }
    static formula of(weight_row) { return {"b"}; }
    static formula of(hat_node_vector) { return {"c_hat"}; }
    static formula of(hat_weight_row) { return {"b_hat"}; }
    static formula of(last_stage) { return {"last"}; }
    template <int I>
    static formula of(any_vector<I>) {
        return {I == 0 ? "u" : "v"};
    }
    static formula of(const constant& e);
    template <class V>
    static formula of(const application<V>& e) {
        return {"A*" + of(e.argument).at_least(atomic), multiplicative};
    }
    template <class V>
    static formula of(const hat_application<V>& e) {
        return {"A_hat*" + of(e.argument).at_least(atomic), multiplicative};
    }
    template <class V>
    static formula of(const reflection<V>& e) {
        return {"P*" + of(e.argument).at_least(atomic), multiplicative};
    }
    template <class F>
    static formula of(const transposed_application<F>& e) {
        return {"transposed(A)*" + of(e.argument).at_least(atomic), multiplicative};
    }
    template <class U, class V>
    static formula of(const product<U, V>& e) {
        return product_of(e.left, e.right);
    }
    template <class F, class V>
    static formula of(const weighted_row<F, V>& e) {
        return product_of(e.row, e.by);
    }
    template <int N, class V>
    static formula of(const power<N, V>& e) {
        return {"pow<" + std::to_string(N) + ">(" + of(e.base).text + ")"};
    }
    template <class F, class V>
    static formula of(const pairing<F, V>& e) {
        return {"dot(" + of(e.row).text + ", " + of(e.vector).text + ")"};
    }
    template <class X, class Y>
    static formula of(const multiple<X, Y>& e) {
        if constexpr (std::is_same_v<X, constant>) {
            if (e.factor.value == 1) return of(e.argument);
            if (e.factor.value.numerator() == 1)
                return {of(e.argument).at_least(multiplicative) + "/" +
                            exact_number(e.factor.value.denominator(), 1).str(),
                        multiplicative};
        }
        return {of(e.factor).at_least(multiplicative) + "*" + of(e.argument).at_least(atomic),
                multiplicative};
    }
    template <class X, class Y, int Sign>
    static formula of(const sum<X, Y, Sign>& e) {
        return {of(e.left).text + (Sign > 0 ? " + " : " - ") +
                    of(e.right).at_least(Sign > 0 ? additive : multiplicative),
                additive};
    }

  private:
    template <class X, class Y>
    static formula product_of(const X& left, const Y& right) {
        const binding needed = is_application<X> ? atomic : multiplicative;
        return {of(left).at_least(needed) + "*" + of(right).at_least(atomic), multiplicative};
    }
};

// Where in LaTeX a vector or a row is written: its index, and the depth of the next free letter.
struct place {
    std::string index;
    int next;
    place reversed() const { return {index.rfind("s+1-", 0) == 0 ? index.substr(4) : "s+1-" + index, next}; }
};

// LaTeX in indices, as the books write it.
struct in_latex {
    static formula of(const constant& e, const place&);
    template <class F, class V>
    static formula of(const pairing<F, V>& e, const place& at) {
        if constexpr (std::is_same_v<F, last_stage>) {
            return of(e.vector, {"s", at.next});
        } else {
            const place inside = deeper(at);
            return {"\\sum_{" + inside.index + "} " + product_of(e, inside).latex_behind(open_sum), open_sum};
        }
    }
    template <class V>
    static formula of(const application<V>& e, const place& at) {
        return application_of("a", e.argument, at);
    }
    template <class V>
    static formula of(const hat_application<V>& e, const place& at) {
        return application_of("\\hat a", e.argument, at);
    }
    template <class F>
    static formula of(const transposed_application<F>& e, const place& at) {
        const place inside = deeper(at);
        return {"\\sum_{" + inside.index + "} " + of(e.argument, inside).latex_behind(multiplicative) +
                    " a_{" + inside.index + at.index + "}",
                open_sum};
    }
    template <class V>
    static formula of(const reflection<V>& e, const place& at) {
        return of(e.argument, at.reversed());
    }
    template <class X, class Y>
    static formula of(const multiple<X, Y>& e, const place& at) {
        if constexpr (std::is_same_v<Y, unit_vector>) return of(e.factor, at);
        if constexpr (std::is_same_v<X, constant>)
            if (e.factor.value == 1) return of(e.argument, at);
        const formula x = of(e.factor, at), y = of(e.argument, at);
        return {latex_product(x.latex_at_least(multiplicative), y.latex_behind(open_sum)),
                y.strength == open_sum ? open_sum : multiplicative};
    }
    template <class X, class Y, int Sign>
    static formula of(const sum<X, Y, Sign>& e, const place& at) {
        return {of(e.left, at).text + (Sign > 0 ? " + " : " - ") +
                    of(e.right, at).latex_behind(Sign > 0 ? additive : open_sum),
                additive};
    }
    // Everything else is a product of factors, perhaps of one or of none.
    template <class E>
    static formula of(const E& e, const place& at) {
        return product_of(e, at);
    }

  private:
    template <class V>
    static formula application_of(const std::string& name, const V& argument, const place& at) {
        const place inside = deeper(at);
        const std::string separator = at.index.size() > 1 ? "," : "";
        const std::string entry = name + "_{" + at.index + separator + inside.index + "}";
        const std::string sum = "\\sum_{" + inside.index + "} ";
        if constexpr (std::is_same_v<V, unit_vector>)
            return {sum + entry, open_sum};
        else
            return {sum + latex_product(entry, of(argument, inside).latex_behind(open_sum)), open_sum};
    }
    static place deeper(const place& at) { return {index_letter(at.next), at.next + 1}; }

    template <class E>
    static formula product_of(const E& e, const place& at) {
        std::vector<std::pair<formula, int>> factors;  // equal neighbours as powers
        collect(e, at, factors);
        if (factors.empty()) return {"1"};
        if (factors.size() == 1 && factors[0].second == 1) return factors[0].first;
        formula all{"", factors.size() == 1 ? atomic : multiplicative};
        for (std::size_t k = 0; k < factors.size(); ++k) {
            const auto& [f, n] = factors[k];
            const bool reaches_to_the_end = k + 1 == factors.size() && n == 1 && f.strength == open_sum;
            if (reaches_to_the_end) all.strength = open_sum;
            const binding needed = n > 1 ? atomic : reaches_to_the_end ? open_sum : multiplicative;
            const std::string factor =
                latex_power(k == 0 ? f.latex_at_least(needed) : f.latex_behind(needed), n);
            all.text = k == 0 ? factor : latex_product(all.text, factor);
        }
        return all;
    }

    using factor_list = std::vector<std::pair<formula, int>>;
    static void append(factor_list& factors, formula f);
    static void collect(unit_vector, const place&, factor_list&) {}
    static void collect(node_vector, const place& at, factor_list& f) { append(f, {"c_{" + at.index + "}"}); }
    static void collect(weight_row, const place& at, factor_list& f) { append(f, {"b_{" + at.index + "}"}); }
    static void collect(hat_node_vector, const place& at, factor_list& f);
    static void collect(hat_weight_row, const place& at, factor_list& f);
    template <int I>
    static void collect(any_vector<I>, const place& at, factor_list& f) {
        append(f, {(I == 0 ? "u_{" : "v_{") + at.index + "}"});
    }
    template <class U, class V>
    static void collect(const product<U, V>& e, const place& at, factor_list& f) {
        collect(e.left, at, f);
        collect(e.right, at, f);
    }
    template <class F, class V>
    static void collect(const weighted_row<F, V>& e, const place& at, factor_list& f) {
        collect(e.row, at, f);
        collect(e.by, at, f);
    }
    template <class F, class V>
    static void collect(const pairing<F, V>& e, const place& at, factor_list& f) {
        collect(e.row, at, f);
        collect(e.vector, at, f);
    }
    template <int N, class V>
    static void collect(const power<N, V>& e, const place& at, factor_list& f) {
        for (int i = 0; i < N; ++i) collect(e.base, at, f);
    }
    template <class E>
    static void collect(const E& e, const place& at, factor_list& f) {
        append(f, of(e, at));
    }
};

}  // namespace detail

/// The expression as it is written in source text (quotients without their _q): "dot(b, c*c*(A*c))".
template <expression E>
std::string text(const E& e) {
    return detail::in_source::of(e).text;
}

/// The expression in LaTeX, in indices: "\sum_{i} b_{i} c_{i}^{2} \sum_{j} a_{ij} c_{j}"; vectors and rows
/// are written at the index i.
template <expression E>
std::string latex(const E& e) {
    return detail::in_latex::of(e, E::sort == sorts::number ? detail::place{"", 0} : detail::place{"i", 1})
        .text;
}

namespace detail {
std::string all_of(unsigned free);
}  // namespace detail

/// The equation as it is written in source text: "dot(b, c*c*(A*c)) == 1/10"; ", for all u, v" where it has
/// arbitrary stage vectors.
template <class L, class R>
std::string text(const equation<L, R>& e) {
    const std::string any = detail::all_of(equation<L, R>::free);
    return text(e.left) + " == " + text(e.right) + (any.empty() ? "" : ", for all " + any);
}

/// The equation in LaTeX (math mode), in indices: "\sum_{i} b_{i} c_{i} = \frac{1}{2}".
template <class L, class R>
std::string latex(const equation<L, R>& e) {
    const std::string any = detail::all_of(equation<L, R>::free);
    return latex(e.left) + " = " + latex(e.right) + (any.empty() ? "" : " \\quad\\text{for all } " + any) +
           (L::sort == sorts::number ? "" : " \\quad (i = 1, \\dots, s)");
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/statements/expression_text-inl.hpp"
#endif
