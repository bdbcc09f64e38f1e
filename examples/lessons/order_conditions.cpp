// SPDX-License-Identifier: BSL-1.0
// Order conditions (Butcher 1963; Hairer-Norsett-Wanner I.II.2): every rooted tree to order 5, drawn; its
// condition as an expression with a type, as text, and in LaTeX; and whether the method below satisfies it.
//
// Edit the method: change a coefficient and see which trees fail. As it stands it is the classical method:
// which trees keep it from order 5?
#include <iostream>
#include <stagecraft/tableaux/fixed_rational.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/statements/expression_text.hpp>
#include <stagecraft/theory/statements/expression_tree.hpp>
#include <stagecraft/theory/statements/order_conditions.hpp>
#include <stagecraft/theory/statements/simplifying.hpp>
#include <stagecraft/theory/trees/tree_text.hpp>
#include <string>

using namespace stagecraft::theory;
using Q = stagecraft::tableaux::fixed_rational;

// The method: rows of A, then b, then c, which must be the row sums of A.
constexpr matrix_model method(std::array<std::array<Q, 4>, 4>{{{Q(0), Q(0), Q(0), Q(0)},
                                                               {Q(1, 2), Q(0), Q(0), Q(0)},
                                                               {Q(0), Q(1, 2), Q(0), Q(0)},
                                                               {Q(0), Q(0), Q(1), Q(0)}}},
                              std::array<Q, 4>{Q(1, 6), Q(1, 3), Q(1, 3), Q(1, 6)},
                              std::array<Q, 4>{Q(0), Q(1, 2), Q(1, 2), Q(1)});

// A condition is an expression: its type is its formula. It can be written by hand,
constexpr auto by_hand = [] {
    using namespace symbols;
    return dot(b, c * (A * c)) == 1 / 8_q;
}();
// it knows its tree, and that tree knows the number that belongs on the right (1/gamma),
static_assert(is_order_condition(by_hand) && density(tree_of(by_hand.left)) == 8);
// and it can be asked of a method, here while this is compiled.
static_assert(holds(by_hand, method));

// The tree as its level sequence says: the root first, every vertex below its parent.
void draw(const rooted_tree& t) {
    for (const int level : t.levels())
        std::cout << "    " << std::string(2 * static_cast<std::size_t>(level - 1), ' ') << "o\n";
}

template <class Statement>
bool show(const Statement& statement) {
    const auto& condition = std::get<0>(statement.equations);
    const rooted_tree t = tree_of(condition.left);
    const Q found = evaluate(condition.left, method);
    const bool satisfied = holds(condition, method);
    std::cout << "\norder " << order(t) << ", tree " << bracket(t) << ", gamma = " << density(t)
              << ", sigma = " << symmetry(t) << '\n';
    draw(t);
    std::cout << "    " << text(condition) << '\n'
              << "    " << latex(condition) << '\n'
              << "    here " << found << (satisfied ? ": holds" : ": FAILS") << '\n';
    return satisfied;
}

int main() {
    static_assert(holds(statements::row_sums, method), "c must be the row sums of A: c = A*one");
    int holding = 0, all = 0;
    std::apply([&](const auto&... each) { ((holding += show(each), ++all), ...); },
               statements::conditions::all);
    std::cout << '\n' << holding << " of " << all << " conditions hold\n";
}
