// SPDX-License-Identifier: BSL-1.0
// Order conditions (Butcher 1963; Hairer-Norsett-Wanner I.II.2): every rooted tree to order 5, drawn; its condition as
// text and in LaTeX; and whether the method below satisfies it. Change a coefficient and see which trees fail.
#include <iostream>
#include <stagecraft/tableaux/fixed_rational.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/statements/expression_text.hpp>
#include <stagecraft/theory/statements/expression_tree.hpp>
#include <stagecraft/theory/statements/order_conditions.hpp>
#include <stagecraft/theory/trees/tree_text.hpp>

using namespace stagecraft::theory;
using namespace stagecraft::theory::symbols;
using Q = stagecraft::tableaux::fixed_rational;

// The classical method: rows of A, then b, then c. Which trees keep it from order 5?
constexpr matrix_model method(
    std::array<std::array<Q, 4>, 4>{{{Q(0)}, {Q(1, 2)}, {Q(0), Q(1, 2)}, {Q(0), Q(0), Q(1)}}},
    std::array<Q, 4>{Q(1, 6), Q(1, 3), Q(1, 3), Q(1, 6)}, std::array<Q, 4>{Q(0), Q(1, 2), Q(1, 2), Q(1)});
static_assert(holds(A * one == c, method), "c must be the row sums of A");

// A condition is an expression, whose type is its formula: it can be asked of a method while this is compiled.
static_assert(holds(dot(b, pow<3>(c)) == 1 / 4_q, method));

int main() {
    int holding = 0, all = 0;
    const auto show = [&](const auto& statement) {
        const auto& condition = std::get<0>(statement.equations);
        const bool good = holds(condition, method);
        const rooted_tree t = tree_of(condition.left);
        std::cout << "\norder " << order(t) << ", tree " << bracket(t) << ", gamma = " << density(t)
                  << ", sigma = " << symmetry(t) << '\n';
        for (const int level : t.levels()) std::cout << std::string(2 * level + 2, ' ') << "o\n";
        std::cout << "    " << text(condition) << "\n    " << latex(condition) << "\n    here "
                  << evaluate(condition.left, method) << (good ? ": holds\n" : ": FAILS\n");
        holding += good, ++all;
    };
    std::apply([&](const auto&... each) { (show(each), ...); }, statements::conditions::all);
    std::cout << '\n' << holding << " of " << all << " conditions hold\n";
}
