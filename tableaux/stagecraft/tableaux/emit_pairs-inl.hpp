// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/emit_pairs.hpp"

#include <cctype>
#include <stdexcept>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/emit.hpp"
#include "stagecraft/tableaux/tableau_from_file.hpp"

namespace stagecraft::tableaux {

namespace emitting {

/// The arrays of one tableau, each under the name that `names` has for c, A, b and b_embedded, in this order; without a
/// name it is left out.
inline std::string arrays(const tableau<double>& t, const char* const (&names)[4]) {
    std::string out;
    if (names[0] != nullptr) out += array(names[0], t.c);
    if (names[1] != nullptr) out += array(names[1], t.A);
    if (names[2] != nullptr) out += array(names[2], t.b);
    if (names[3] != nullptr) out += array(names[3], t.b_embedded);
    return out;
}

STAGECRAFT_INLINE std::string pair_data(const std::string& id, const partitioned_file& file) {
    const auto first = rounded<double>(file.partners[0]), second = rounded<double>(file.partners[1]);
    std::string out = "\nstruct " + id +
                      " {\n    static constexpr int stages = " + std::to_string(file.stages()) +
                      ", order = " + std::to_string(file.claims.order.value_or(0));
    if (file.coupling == coupling::additive)
        out += ", embedded_order = " + std::to_string(file.claims.embedded_order.value_or(0));
    out += ";\n";
    if (file.coupling == coupling::nystrom) {
        out += arrays(first, {"c", "A_bar", "b_bar", "b_bar_embedded"});
        out += arrays(second, {nullptr, file.uses_velocity ? "A" : nullptr, "b", "b_embedded"});
    } else {
        out += arrays(first, {"c", "A", "b", "b_embedded"});
        out += arrays(second, {"c_hat", "A_hat", "b_hat", "b_hat_embedded"});
    }
    return out + "};\n";
}

STAGECRAFT_INLINE std::string pair_function(const std::string& id, const partitioned_file& file) {
    const bool exact = file.kind() == number_kind::rational || file.kind() == number_kind::quadratic;
    const std::string type = std::string(file.coupling == coupling::additive      ? "additive_method"
                                         : file.coupling == coupling::partitioned ? "partitioned_method"
                                         : file.coupling == coupling::separable   ? "separable_method"
                                         : file.uses_velocity                     ? "velocity_nystrom_method"
                                                                                  : "nystrom_method") +
                             "<Scalar, " + std::to_string(file.stages()) + ">";
    return "\n/// " + file.name + " (" + file.source + "), order " +
           std::to_string(file.claims.order.value_or(0)) +
           (file.claims.embedded_order ? "(" + std::to_string(*file.claims.embedded_order) + ")" : "") +
           (exact ? ", proved" : ", up to the digits published") +
           ": every entry is the nearest double; in another Scalar that one rounded.\n"
           "template <class Scalar = double>\n" +
           type + " " + id + "() {\n    return coefficients::unpack_pair<" + type + ", coefficients::" + id +
           ">();\n}\n";
}

}  // namespace emitting

STAGECRAFT_INLINE std::string pairs_header(const std::vector<named_pair>& methods,
                                           const std::string& command) {
    std::string data, functions;
    for (const auto& [id, file] : methods) {
        bool good = !id.empty() && !std::isdigit(static_cast<unsigned char>(id[0]));
        for (const char ch : id) good = good && (std::isalnum(static_cast<unsigned char>(ch)) || ch == '_');
        if (!good) throw std::invalid_argument("coefficients: '" + id + "' is no name of a function");
        if (file.partners.size() != 2)
            throw std::invalid_argument("coefficients: " + id + " must have two tableaux");
        data += emitting::pair_data(id, file);
        functions += emitting::pair_function(id, file);
    }
    return "// SPDX-License-Identifier: BSL-1.0 | written by: " + command +
           "\n// clang-format off\n#pragma once\n\n#include <stagecraft/coefficients/unpack_pair.hpp>\n\n"
           "namespace stagecraft {\nnamespace coefficients {\n" +
           data + "\n}  // namespace coefficients\n" + functions + "\n}  // namespace stagecraft\n";
}

}  // namespace stagecraft::tableaux
