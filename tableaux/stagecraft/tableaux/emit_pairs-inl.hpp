// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/emit_pairs.hpp"

#include <cctype>
#include <stdexcept>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/dense_from_file.hpp"
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

/// What stands above the function that returns the method of a file of either kind.
template <class File>
std::string function_comment(const File& file, number_kind kind) {
    const bool exact = kind == number_kind::rational || kind == number_kind::quadratic;
    return "\n/// " + file.name + " (" + file.source + "), order " +
           std::to_string(file.claims.order.value_or(0)) +
           (file.claims.embedded_order ? "(" + std::to_string(*file.claims.embedded_order) + ")" : "") +
           (exact ? ", proved" : ", up to the digits published") +
           ": every entry is the nearest double; in another Scalar that one rounded.\n"
           "template <class Scalar = double>\n";
}

STAGECRAFT_INLINE std::string pair_function(const std::string& id, const partitioned_file& file) {
    const std::string type = std::string(file.coupling == coupling::additive      ? "additive_method"
                                         : file.coupling == coupling::partitioned ? "partitioned_method"
                                         : file.coupling == coupling::separable   ? "separable_method"
                                         : file.uses_velocity                     ? "velocity_nystrom_method"
                                                                                  : "nystrom_method") +
                             "<Scalar, " + std::to_string(file.stages()) + ">";
    return function_comment(file, file.kind()) + type + " " + id +
           "() {\n    return coefficients::unpack_pair<" + type + ", coefficients::" + id + ">();\n}\n";
}

STAGECRAFT_INLINE std::string method_data(const std::string& id, const tableau_file& file) {
    return "\nstruct " + id + " {\n    static constexpr int stages = " + std::to_string(file.stages()) +
           ", order = " + std::to_string(file.claims.order.value_or(0)) + ";\n" +
           arrays(rounded<double>(file), {"c", "A", "b", "b_embedded"}) + "};\n";
}

STAGECRAFT_INLINE std::string method_function(const std::string& id, const tableau_file& file) {
    const std::string type = "tableau<Scalar, " + std::to_string(file.stages()) + ">";
    return function_comment(file, file.kind()) + type + " " + id +
           "() {\n    return coefficients::unpack_one<" + type + ", coefficients::" + id + ">();\n}\n";
}

inline const char* enumerator(storage_form form) {
    return form == storage_form::shu_osher    ? "shu_osher"
           : form == storage_form::williamson ? "williamson"
           : form == storage_form::ketcheson  ? "ketcheson"
                                              : "ketcheson_three";
}

/// The coefficients of a form, list by list.
STAGECRAFT_INLINE std::string storage_data(const std::string& id, const tableau_file& file) {
    const auto& rows = file.form->rows;
    Eigen::MatrixXd lists(rows.size(), rows.front().size());
    for (Eigen::Index i = 0; i < lists.rows(); ++i)
        for (Eigen::Index j = 0; j < lists.cols(); ++j)
            lists(i, j) = rounded<double>(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
    return "\nstruct " + id + " {\n    static constexpr int stages = " + std::to_string(file.stages()) +
           ", lists = " + std::to_string(rows.size()) +
           ", order = " + std::to_string(file.claims.order.value_or(0)) +
           ";\n    static constexpr storage_form form = storage_form::" + enumerator(file.form->which) +
           ";\n" + array("rows", lists) + array("b_embedded", rounded<double>(file).b_embedded) + "};\n";
}

STAGECRAFT_INLINE std::string storage_function(const std::string& id, const tableau_file& file) {
    return function_comment(file, file.kind()) + "low_storage_method<Scalar> " + id +
           "() {\n    return coefficients::unpack_low_storage<Scalar, coefficients::" + id + ">();\n}\n";
}

/// Whether the arrays of two tableaux are the same, to the bit.
inline bool same_arrays(const tableau<double>& a, const tableau<double>& b) {
    return a.stages() == b.stages() && a.b_embedded.size() == b.b_embedded.size() && a.A == b.A &&
           a.b == b.b && a.c == b.c && a.b_embedded == b.b_embedded;
}

/// A tableau with its continuous solution; where one of `known` is that tableau, its struct has the arrays.
STAGECRAFT_INLINE std::string dense_data(const std::string& id, const tableau_file& file,
                                         const std::vector<named_tableau>& known) {
    const auto m = dense_method_of<double>(file);
    std::string of_tableau;
    for (const auto& [name, other] : known)
        if (other.claims.order == file.claims.order && same_arrays(rounded<double>(other), m.method))
            of_tableau = name;
    const bool alone = of_tableau.empty();
    const std::string own = alone ? "stages = " + std::to_string(m.stages()) +
                                        ", order = " + std::to_string(file.claims.order.value_or(0)) + ", "
                                  : "";
    return "\nstruct " + id + (alone ? "" : " : " + of_tableau) + " {\n    static constexpr int " + own +
           "further_stages = " + std::to_string(m.further_stages()) +
           ", degree = " + std::to_string(m.degree()) + ", dense_order = " + std::to_string(m.dense_order) +
           ";\n" + (alone ? arrays(m.method, {"c", "A", "b", "b_embedded"}) : "") +
           array("c_more", m.c_more) + array("A_more", m.A_more) + array("b_theta", m.b_theta) + "};\n";
}

STAGECRAFT_INLINE std::string dense_function(const std::string& id, const tableau_file& file) {
    const std::string s = std::to_string(dense_method_of<double>(file).stages());
    return function_comment(file, file.kind()) + "dense_method<Scalar, " + s + "> " + id +
           "() {\n    return coefficients::unpack_dense<Scalar, coefficients::" + id + ">();\n}\n";
}

/// Throws std::invalid_argument where `id` is no name of a function.
inline void require_name(const std::string& id) {
    bool good = !id.empty() && !std::isdigit(static_cast<unsigned char>(id[0]));
    for (const char ch : id) good = good && (std::isalnum(static_cast<unsigned char>(ch)) || ch == '_');
    if (!good) throw std::invalid_argument("coefficients: '" + id + "' is no name of a function");
}

inline std::string whole_header(const std::string& command, const std::string& include,
                                const std::string& data, const std::string& functions) {
    return "// SPDX-License-Identifier: BSL-1.0 | written by: " + command +
           "\n// clang-format off\n#pragma once\n\n" + include +
           "\nnamespace stagecraft {\nnamespace coefficients {\n" + data +
           "\n}  // namespace coefficients\n" + functions + "\n}  // namespace stagecraft\n";
}

inline std::string include_line(const std::string& name) {
    return "#include <stagecraft/coefficients/" + name + ".hpp>\n";
}

}  // namespace emitting

STAGECRAFT_INLINE std::string methods_header(const std::vector<named_tableau>& methods,
                                             const std::string& command) {
    enum class kind { plain, stored, dense };
    const auto kind_of = [](const tableau_file& file) {
        return file.form ? kind::stored : file.b_theta.empty() ? kind::plain : kind::dense;
    };
    std::string data, functions;
    kind first = methods.empty() ? kind::plain : kind_of(methods.front().second);
    std::vector<named_tableau> known;
    for (const auto& method : methods)
        if (kind_of(method.second) == kind::dense && first == kind::plain) first = kind::dense;
    for (const auto& method : methods)
        if (first == kind::dense && kind_of(method.second) == kind::plain) known.push_back(method);
    for (const auto& [name, file] : methods) {
        if (first == kind::dense && kind_of(file) == kind::plain) continue;
        const std::string id = first == kind::dense ? name + "_dense" : name;
        emitting::require_name(id);
        if (kind_of(file) != first)
            throw std::invalid_argument(
                "coefficients: " + name +
                ": a header holds tableaux, methods with b_theta, or methods by their "
                "registers");
        data += first == kind::stored  ? emitting::storage_data(id, file)
                : first == kind::dense ? emitting::dense_data(id, file, known)
                                       : emitting::method_data(id, file);
        functions += first == kind::stored  ? emitting::storage_function(id, file)
                     : first == kind::dense ? emitting::dense_function(id, file)
                                            : emitting::method_function(id, file);
    }
    const std::string include = emitting::include_line(first == kind::stored  ? "unpack_low_storage"
                                                       : first == kind::dense ? "unpack_dense"
                                                                              : "unpack_one");
    return emitting::whole_header(
        command, (known.empty() ? "" : emitting::include_line("explicit")) + include, data, functions);
}

STAGECRAFT_INLINE std::string pairs_header(const std::vector<named_pair>& methods,
                                           const std::string& command) {
    std::string data, functions;
    for (const auto& [id, file] : methods) {
        emitting::require_name(id);
        if (file.partners.size() != 2)
            throw std::invalid_argument("coefficients: " + id + " must have two tableaux");
        data += emitting::pair_data(id, file);
        functions += emitting::pair_function(id, file);
    }
    return emitting::whole_header(command, emitting::include_line("unpack_pair"), data, functions);
}

}  // namespace stagecraft::tableaux
