// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/polynomial_text.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/entry.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE polynomial<rational> read_polynomial(std::string_view text) {
    using poly = polynomial<rational>;
    const auto constant = [](const poly& p, const char* what) {
        if (p.degree() > 0) throw std::invalid_argument(std::string(what) + " must not contain x");
        return p[0];
    };
    const auto checked = [](poly p) {
        if (p.degree() > largest_degree) throw std::invalid_argument("the degree exceeds 64");
        for (const rational& k : p.coefficients())
            if (bit_size(k) > expression_grammar::largest_bits)
                throw std::invalid_argument("too large a number");
        return p;
    };
    std::vector<poly> stack;
    for (const auto& [code, literal] : expression_grammar::compile(with_ascii_minus(text))) {
        if (code == 'x') {
            stack.push_back(poly{0, 1});
            continue;
        }
        if (code == '#') {
            const entry e = expression_grammar::from_literal(literal);
            if (!e.exact) throw std::invalid_argument("'" + literal + "': coefficients must be exact");
            stack.push_back(poly(e.exact->rational_part()));
            continue;
        }
        poly y = std::move(stack.back());
        stack.pop_back();
        if (code == 'n') {
            stack.push_back(y * poly(-1));
            continue;
        }
        if (code == 'r') {
            const auto root = exact_sqrt(constant(y, "sqrt()"));
            if (!root || !root->is_rational()) throw std::invalid_argument("an irrational coefficient");
            stack.push_back(poly(root->rational_part()));
            continue;
        }
        poly x = std::move(stack.back());
        stack.pop_back();
        if (code == '^') {
            const rational n = constant(y, "an exponent");
            if (n.denominator() != 1 || abs(n) > largest_degree)
                throw std::invalid_argument("an exponent must be an integer up to 64");
            if (n < 0) x = poly(rational(1) / constant(x, "a divisor"));
            poly power(1);
            for (rational k = abs(n); k > 0; k -= 1) power = checked(power * x);
            stack.push_back(power);
        } else if (code == '/') {
            const rational divisor = constant(y, "a divisor");
            if (divisor == 0) throw std::invalid_argument("division by zero");
            stack.push_back(checked(x * poly(rational(1) / divisor)));
        } else {
            stack.push_back(checked(code == '+' ? x + y : code == '-' ? x - y : x * y));
        }
    }
    return stack.back();
}

}  // namespace stagecraft::tableaux
