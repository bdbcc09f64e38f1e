// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE examples
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/tableaux/fixed_rational.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/theory/models/legendre_model.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/models/pair_model.hpp>
#include <stagecraft/theory/statements/expression.hpp>
#include <stagecraft/theory/statements/expression_text.hpp>
#include <stagecraft/theory/statements/expression_tree.hpp>
#include <stagecraft/theory/statements/simplifying.hpp>
#include <stagecraft/theory/statements/statement.hpp>
#include <string>

// Expressions as a user writes them; ctest compiles this file with g++ and with clang++.
using namespace stagecraft;
using namespace stagecraft::theory;
using namespace stagecraft::theory::symbols;
using tableaux::fixed_rational;
using tableaux::rational;

namespace {

// Printing and source agree but for blanks and the _q of quotients.
std::string compact(std::string s) {
    std::string r;
    for (std::size_t i = 0; i < s.size(); ++i) {
        if (s[i] == ' ') continue;
        if (s.compare(i, 2, "_q") == 0)
            ++i;
        else
            r += s[i];
    }
    return r.substr(0, r.find(",forall"));
}
#define PRINTS_ITSELF(...) BOOST_TEST(compact(text(__VA_ARGS__)) == compact(#__VA_ARGS__))

// Radau IIA of order 3 in any scalar.
template <class K>
tableau<K, 2> radau_iia_2() {
    tableau<K, 2> t;
    t.A << ratio<K>(5, 12), ratio<K>(-1, 12), ratio<K>(3, 4), ratio<K>(1, 4);
    t.b << ratio<K>(3, 4), ratio<K>(1, 4);
    t.c << ratio<K>(1, 3), K(1);
    return t;
}

/// Reads what latex() prints of numbers and vectors, and evaluates it with the numbers of a tableau: sums reach over the
/// product behind them, a minus sign is a difference wherever something stands before it.
class latex_reader {
  public:
    latex_reader(const tableau<rational, 2>& t, std::string text) : t_(t), text_(std::move(text)) {}
    /// The value with the free index i, counted from 0.
    rational value(int i) {
        at_ = 0;
        index_ = {{'i', i}};
        const rational x = sum();
        BOOST_TEST(at_ == text_.size(), text_.substr(at_));
        return x;
    }

  private:
    bool next(const std::string& word) {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        if (text_.compare(at_, word.size(), word) != 0) return false;
        at_ += word.size();
        return true;
    }
    rational sum() {
        rational x = next("-") ? -product() : product();
        for (;;) {
            if (next("+"))
                x += product();
            else if (next("-"))
                x -= product();
            else
                return x;
        }
    }
    rational product() {
        rational x = factor();
        while (next("\\cdot") || starts_factor()) x *= factor();
        return x;
    }
    bool starts_factor() {
        next("");
        return at_ < text_.size() && text_[at_] != '+' && text_[at_] != '-' && text_[at_] != ')' &&
               text_.compare(at_, 5, "\\bigr") != 0;
    }
    rational factor() {
        if (next("\\sum_{")) return summed(text_[at_]);
        rational x = atom();
        if (!next("^{")) return x;
        const rational base = x;
        for (int n = static_cast<int>(number().numerator()); n > 1; --n) x *= base;
        next("}");
        return x;
    }
    rational summed(char letter) {
        at_ += 2;
        const auto outer = index_;
        const std::size_t start = at_;
        rational all = 0;
        for (int k = 0; k < 2; ++k) {
            at_ = start;
            index_[letter] = k;
            // what stands directly behind the sign may be negative, in brackets only
            all += product();
        }
        index_ = outer;
        return all;
    }
    rational atom() {
        if (next("\\bigl(")) {
            const rational x = sum();
            BOOST_TEST(next("\\bigr)"));
            return x;
        }
        if (next("\\frac{")) {
            const rational n = number();
            BOOST_TEST(next("}{"));
            const rational d = number();
            BOOST_TEST(next("}"));
            return n / d;
        }
        if (next("a_{")) {
            const int i = index(), j = index();
            return close(t_.A(i, j));
        }
        if (next("b_{")) return close(t_.b(index()));
        if (next("c_{")) return close(t_.c(index()));
        return number();
    }
    int index() {
        BOOST_REQUIRE(index_.count(text_[at_]) == 1);
        return index_[text_[at_++]];
    }
    rational close(const rational& x) {
        BOOST_TEST(next("}"));
        return x;
    }
    rational number() {
        next("");
        const std::size_t from = at_;
        while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') ++at_;
        BOOST_REQUIRE(at_ > from);
        return rational(std::stoi(text_.substr(from, at_ - from)));
    }

    tableau<rational, 2> t_;
    std::string text_;
    std::size_t at_ = 0;
    std::map<char, int> index_;
};

/// Whether the printed formula has the expression's value for a tableau of numbers without relations.
template <class E>
void reads_back(const E& e) {
    tableau<rational, 2> t;
    t.A << rational(2, 3), rational(-5, 7), rational(11, 13), rational(-17, 19);
    t.b << rational(23, 29), rational(-31, 37);
    t.c << rational(-41, 43), rational(47, 53);
    latex_reader reader(t, latex(e));
    const auto value = evaluate(e, matrix_model(t));
    if constexpr (E::sort == sorts::number) {
        BOOST_TEST((reader.value(0) == value), latex(e));
    } else {
        for (int i = 0; i < 2; ++i)
            BOOST_TEST((reader.value(i) == value[static_cast<std::size_t>(i)]), latex(e));
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(conditions_compile_as_written) {
    constexpr auto t53 = dot(b, c * (A * (c * c))) == 1 / 15_q;
    constexpr auto t52 = dot(b, c * c * (A * c)) == 1 / 10_q;
    constexpr auto t55 = dot(b, (A * c) * (A * c)) == 1 / 20_q;
    static_assert(is_order_condition(t53) && is_order_condition(t52) && is_order_condition(t55));
    static_assert(tree_of(t53.left) == rooted_tree{1, 2, 3, 3, 2});
    static_assert(tree_of(t55.left) == tree_of(dot(b, pow<2>(A * c))));
    static_assert(is_order_condition(dot(b, one) == 1));
    static_assert(is_order_condition(dot(b, A * (A * one)) == 1 / 6_q));
    static_assert(is_order_condition(dot(transposed(A) * (b * c), c * c) == 1 / 15_q));
    static_assert(is_order_condition(dot(b * c, A * (c * c)) == 1 / 15_q));
    // a wrong right-hand side, and equations that belong to no tree
    static_assert(!is_order_condition(dot(b, c * c * (A * c)) == 1 / 15_q));
    static_assert(!is_order_condition(A * one == c));
    static_assert(!is_order_condition(dot(b, c - c * c) == 1 / 6_q));
    static_assert(!is_order_condition(dot(last, A * c) == 1 / 2_q));
    static_assert(!is_order_condition(dot(b, c) == dot(b, A * one)));
}

BOOST_AUTO_TEST_CASE(expressions_print_what_was_written) {
    PRINTS_ITSELF(dot(b, one) == 1);
    PRINTS_ITSELF(dot(b, c * c * (A * c)) == 1 / 10_q);
    PRINTS_ITSELF(dot(b, (A * c) * (A * c)) == 1 / 20_q);
    PRINTS_ITSELF(dot(b, pow<2>(A * c) * (A * (c * (A * one)))) == 1 / 162_q);
    PRINTS_ITSELF(dot(transposed(A) * (b * c), c * c) == 1 / 15_q);
    PRINTS_ITSELF(transposed(A) * (b * c) == b * (one - pow<2>(c)) / 2);
    PRINTS_ITSELF(A * pow<3>(c) == pow<4>(c) / 4);
    PRINTS_ITSELF(dot(b, u * (A * v)) + dot(b, v * (A * u)) == dot(b, u) * dot(b, v));
    PRINTS_ITSELF(P * (A * (P * v)) + A * v == dot(b, v) * one);
    PRINTS_ITSELF(dot(last, A * v) == dot(b, v));
    PRINTS_ITSELF(dot(b, c - 2 / 3_q * pow<2>(c)) == -1 / 3_q);
    PRINTS_ITSELF(A * c - (c - A * c) == one - (c - one));
}

BOOST_AUTO_TEST_CASE(negative_factors_print_what_was_written) {
    PRINTS_ITSELF(dot(b, -1 * c) == -1 / 2_q);
    PRINTS_ITSELF(dot(b, c * (-1 * c)) == -1 / 3_q);
    PRINTS_ITSELF(dot(b, c * (-2 * (A * c))) == -1 / 4_q);
    PRINTS_ITSELF(A * (-1 * c) == -1 / 2_q * (c * c));
    PRINTS_ITSELF(dot(b, one - -1 * c) == 3 / 2_q);
    PRINTS_ITSELF(-1 * dot(b, c) == -1 / 2_q);
    PRINTS_ITSELF(dot(b, pow<2>(-1 * c)) == 1 / 3_q);
    PRINTS_ITSELF(transposed(A) * (-1 * b) == b);
    BOOST_TEST(latex(dot(b, c * (-1 * c)) == -1 / 3_q) ==
               "\\sum_{i} b_{i} c_{i} \\bigl(-1 c_{i}\\bigr) = -\\frac{1}{3}");
    BOOST_TEST(latex(one - -1 * c) == "1 - \\bigl(-1 c_{i}\\bigr)");
    BOOST_TEST(latex(2 * (3 * c)) == "2 \\cdot 3 c_{i}");
}

BOOST_AUTO_TEST_CASE(latex_read_back_has_the_values_of_the_expression) {
    reads_back(dot(b, c));
    reads_back(dot(b, c * c * (A * c)));
    reads_back(dot(b, c * (A * c) * (A * (c * (A * one)))));
    reads_back(dot(b, -1 * c));
    reads_back(dot(b, -1 / 2_q * c));
    reads_back(dot(b, c * (-1 * c)));
    reads_back(dot(b, (-1 * c) * c));
    reads_back(dot(b, (-1 * c) * (-1 * c)));
    reads_back(dot(b, c * (-2 * (A * c))));
    reads_back(dot(b, c * (-2 / 3_q * (A * (-1 * c)))));
    reads_back(dot(b, c * (A * (-1 * c)) * c));
    reads_back(dot(b, one - -1 * c));
    reads_back(dot(b, c - (c - one)));
    reads_back(dot(b, c - (-1 * c - one)));
    reads_back(dot(b, c + -1 * c));
    reads_back(dot(b, pow<2>(-1 * c)));
    reads_back(dot(b, pow<3>(c - one)));
    reads_back(dot(b, pow<2>(A * c) * (-1 * c)));
    reads_back(-1 * dot(b, c));
    reads_back(2 * dot(b, c) - dot(b, one - c));
    reads_back(dot(b, c) * dot(b, A * c));
    reads_back(1 / 2_q * dot(b, -3 * (1 / 2_q * c)));
    reads_back(dot(-1 * b, c));
    reads_back(dot(b * (-1 * c), c));
    reads_back(dot(transposed(A) * (-1 * b), c));
    reads_back(dot(transposed(A) * (b * c), -1 * c));
    reads_back(-1 * c);
    reads_back(A * (-1 * c));
    reads_back(A * (2 * c));
    reads_back(c * (2 * one) * (1 / 2_q * one));
    reads_back(pow<2>(1 / 2_q * one) * c);
    reads_back(pow<2>(-3 * one) * c);
    reads_back(-1 * (A * (c - 2 * (A * c))));
    reads_back(c - -1 / 2_q * (A * c));
    reads_back(2 * (3 * c) - 1 / 2_q * (1 / 3_q * c));
    reads_back(dot(b, c) * (-1 * c));
    reads_back(c * (A * c) - (A * c) * (A * c));
    reads_back((c - A * c) * (A * c - one) / 2);
}

BOOST_AUTO_TEST_CASE(latex_is_in_indices) {
    BOOST_TEST(
        latex(dot(b, c * c * c * (A * c) * (A * (A * c))) == 1 / 288_q) ==
        "\\sum_{i} b_{i} c_{i}^{3} \\bigl(\\sum_{j} a_{ij} c_{j}\\bigr) \\sum_{j} a_{ij} \\sum_{k} a_{jk} "
        "c_{k} = \\frac{1}{288}");
    BOOST_TEST(latex(transposed(A) * (b * c) == b * (one - pow<2>(c)) / 2) ==
               "\\sum_{j} b_{j} c_{j} a_{ji} = \\frac{1}{2} b_{i} \\bigl(1 - c_{i}^{2}\\bigr) \\quad (i = 1, "
               "\\dots, s)");
    BOOST_TEST(latex(P * (A * (P * v)) + A * v == dot(b, v) * one) ==
               "\\sum_{j} a_{s+1-i,j} v_{s+1-j} + \\sum_{j} a_{ij} v_{j} = \\sum_{j} b_{j} v_{j} "
               "\\quad\\text{for all } v \\quad (i = 1, \\dots, s)");
    BOOST_TEST(latex(dot(last, A * v) == dot(b, v)) ==
               "\\sum_{i} a_{si} v_{i} = \\sum_{i} b_{i} v_{i} \\quad\\text{for all } v");
}

BOOST_AUTO_TEST_CASE(one_expression_evaluates_in_every_model) {
    using real_100 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                                   boost::multiprecision::et_off>;
    constexpr auto weight = dot(b, c * (A * (c * c)));  // of Radau IIA, s = 2: 3/4*1/3*(-1/27) + 1/4*1/3
    const rational exact(2, 27);

    BOOST_TEST((evaluate(weight, matrix_model(radau_iia_2<rational>())) == exact));
    BOOST_TEST((evaluate(weight, matrix_model(radau_iia_2<fixed_rational>())) == fixed_rational(2, 27)));
    BOOST_TEST(
        (evaluate(weight, matrix_model(radau_iia_2<tableaux::quadratic>())) == tableaux::quadratic(exact)));
    BOOST_TEST(std::abs(evaluate(weight, matrix_model(radau_iia_2<double>())) - 2.0 / 27) < 1e-16);
    BOOST_TEST(
        (abs(evaluate(weight, matrix_model(radau_iia_2<real_100>())) - real_100(2) / 27) < real_100(1e-99)));
    using model = legendre_model<rational>;
    BOOST_TEST((evaluate(weight, model(tableaux::family::radau_iia, 2)) == exact));

    const auto enclosed = evaluate(weight, matrix_model(radau_iia_2<tableaux::ball>()));
    const auto off = enclosed - ratio<tableaux::ball>(2, 27);
    BOOST_TEST(!(off.radius() == 0));
    BOOST_TEST(off.radius() < 1e-17);
    BOOST_TEST(!certainly_nonzero(off));
    BOOST_TEST(certainly_nonzero(enclosed - ratio<tableaux::ball>(2, 28)));
}

BOOST_AUTO_TEST_CASE(enclosures_keep_their_precision_in_residuals) {
    // 1/15 with the 64 bits of an integer would leave 1e-20 where the data have 300 bits.
    tableau<tableaux::ball, 2> t;
    const auto q = [](int n, int d) { return tableaux::ball(rational(n, d), 300); };
    t.A << q(5, 12), q(-1, 12), q(3, 4), q(1, 4);
    t.b << q(3, 4), q(1, 4);
    t.c << q(1, 3), q(1, 1);
    const matrix_model m(t);
    for_each_residual(dot(b, c * c) == 1 / 3_q, m,
                      [](const tableaux::ball& r) { BOOST_TEST(r.radius() < 1e-85); });
    for_each_residual(A * c == pow<2>(c) / 2, m,
                      [](const tableaux::ball& r) { BOOST_TEST(r.radius() < 1e-85); });
}

BOOST_AUTO_TEST_CASE(statements_hold_alike_in_the_legendre_ring_and_over_the_nodes) {
    using namespace statements;
    const legendre_model<rational> iia(tableaux::family::radau_iia, 2),
        iiib(tableaux::family::lobatto_iiib, 4);
    BOOST_TEST((holds(B<3>, iia) && !holds(B<4>, iia)));
    BOOST_TEST((holds(C<2>, iia) && !holds(C<3>, iia)));
    BOOST_TEST((holds(D<1>, iia) && !holds(D<2>, iia)));
    BOOST_TEST((holds(B<6>, iiib) && !holds(B<7>, iiib)));
    BOOST_TEST((holds(C<2>, iiib) && !holds(C<3>, iiib)));
    BOOST_TEST((holds(D<4>, iiib) && !holds(D<5>, iiib)));
    static_assert(holds(D<3>, legendre_model<fixed_rational>(tableaux::family::gauss, 3)));
    static_assert(!holds(D<4>, legendre_model<fixed_rational>(tableaux::family::gauss, 3)));
}

BOOST_AUTO_TEST_CASE(a_pair_of_tableaux_has_two_colours) {
    using q = fixed_rational;
    // Lobatto IIIA and IIIB with three stages, of order 4 together.
    constexpr matrix_model<q, 3> iiia(
        {{{0, 0, 0}, {q(5, 24), q(1, 3), q(-1, 24)}, {q(1, 6), q(2, 3), q(1, 6)}}},
        {q(1, 6), q(2, 3), q(1, 6)}, {0, q(1, 2), 1});
    constexpr matrix_model<q, 3> iiib(
        {{{q(1, 6), q(-1, 6), 0}, {q(1, 6), q(1, 3), 0}, {q(1, 6), q(5, 6), 0}}}, {q(1, 6), q(2, 3), q(1, 6)},
        {0, q(1, 2), 1});
    constexpr pair_model pair(iiia, iiib);
    static_assert(holds(dot(b, A_hat * c) == 1 / 6_q, pair));
    static_assert(holds(dot(b_hat, c * (A * c_hat)) == 1 / 8_q, pair));
    static_assert(holds(dot(b, A * (A_hat * c)) == 1 / 24_q, pair));
    static_assert(!holds(dot(b, A_hat * (c * c * c)) == 1 / 20_q, pair));
    PRINTS_ITSELF(dot(b_hat, c_hat * (A * (A_hat * c))) == 1 / 40_q);
    BOOST_TEST(latex(dot(b_hat, c_hat * (A_hat * c))) ==
               "\\sum_{i} \\hat b_{i} \\hat c_{i} \\sum_{j} \\hat a_{ij} c_{j}");
}
