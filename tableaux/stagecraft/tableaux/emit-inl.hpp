// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/emit.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/rounded.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE std::string hexadecimal(double x) {
    if (!std::isfinite(x)) throw std::invalid_argument("hexadecimal: not a finite number");
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, std::abs(x), std::chars_format::hex).ptr;
    return (std::signbit(x) ? "-0x" : "0x") + std::string(text, end);
}

namespace emitting {

inline std::string text(bool value) { return value ? "true" : "false"; }

STAGECRAFT_INLINE std::string facts(const stagecraft::facts& f) {
    if (!std::isfinite(f.r_infinity)) throw std::invalid_argument("emit: R(infinity) is not finite");
    return "    static constexpr stagecraft::facts facts{.order = " + std::to_string(f.order) +
           ",\n                                             .stage_order = " + std::to_string(f.stage_order) +
           ",\n                                             .a_stable = " + text(f.a_stable) +
           ",\n                                             .algebraically_stable = " +
           text(f.algebraically_stable) +
           ",\n                                             .symplectic = " + text(f.symplectic) +
           ",\n                                             .symmetric = " + text(f.symmetric) +
           ",\n                                             .r_infinity = " + hexadecimal(f.r_infinity) +
           "};\n";
}

}  // namespace emitting

STAGECRAFT_INLINE std::string coefficient_header(family f, int most,
                                                 const std::function<stagecraft::facts(int)>& facts_of) {
    require_stages(f, most);
    const std::string id(name(f));
    const std::string range = std::to_string(least_stages(f)) + " <= S <= " + std::to_string(most);
    const std::string type =
        std::string(has_regular_matrix(f) ? "transformed_tableau" : "tableau") + "<double, (S > 0 ? S : -1)>";
    std::string out =
        "// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients " + id + " " +
        std::to_string(most) +
        "\n// clang-format off\n#pragma once\n\n#include <stagecraft/coefficients/unpack.hpp>\n\n"
        "namespace stagecraft {\nnamespace coefficients {\n\n"
        "template <int S>\nstruct " +
        id + ";\n";
    for (int s = least_stages(f); s <= most; ++s) {
        out += "\ntemplate <>\nstruct " + id + "<" + std::to_string(s) + "> {\n";
        const auto basic = [&](const tableau<double>& t) {
            out += emitting::facts(t.facts) + emitting::array("c", t.c) + emitting::array("b", t.b) +
                   emitting::array("A", t.A);
        };
        if (has_regular_matrix(f)) {
            const auto t = transformed<double>(f, s, facts_of(s));
            basic(t);
            out += "    static constexpr int pairs = " + std::to_string(t.beta.size()) + ";\n" +
                   emitting::array("gamma", t.gamma) + emitting::array("alpha", t.alpha) +
                   emitting::array("beta", t.beta) + emitting::array("A_inverse", t.A_inverse) +
                   emitting::array("T", t.T) + emitting::array("T_inverse", t.T_inverse);
        } else {
            basic(rounded<double>(f, s, facts_of(s)));
        }
        out += "};\n";
    }
    std::string in_scalar = type;
    in_scalar.replace(in_scalar.find("double"), 6, "Scalar");
    return out + "\n}  // namespace coefficients\n\n" + "/// The S-stage member of this family, " + range +
           ": every entry is the double nearest to the exact one; in another Scalar, float, "
           "that one rounded.\n"
           "template <int S, class Scalar = double>\n" +
           in_scalar + " " + id + "() {  // of a variable s: " + id +
           "(s) of stagecraft/families.hpp\n    constexpr bool generated = " +
           std::to_string(least_stages(f)) + " <= S && S <= " + std::to_string(most) +
           ";\n    static_assert(generated, \"" + id + ": generated for " + range +
           "; see stagecraft/tableaux/rounded.hpp for more\");\n    " + in_scalar +
           " t;\n    if constexpr (generated) coefficients::unpack<coefficients::" + id +
           "<S>>(t);\n    return t;\n}\n\n"
           "/// A number of stages in parentheses is for stagecraft/families.hpp.\n"
           "template <class Never = void>\n" +
           type.substr(0, type.find(',')) + "> " + id +
           "(...) {\n    static_assert(detail::never<Never>, \"the number of stages stands in angle "
           "brackets, " +
           id + "<3>(), or include stagecraft/families.hpp for " + id +
           "(3)\");\n    return {};\n}\n\n}  // namespace stagecraft\n";
}

}  // namespace stagecraft::tableaux
