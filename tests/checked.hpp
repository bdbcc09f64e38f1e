// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <sstream>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/theory/judging/certify_file.hpp>
#include <stagecraft/theory/judging/certify_partitioned.hpp>
#include <string>
#include <string_view>

/// The checker as its tests call it.
namespace checked {

/// theory::certify of a tableau given as JSON text. Throws tableaux::unusable_input.
inline stagecraft::theory::file_certificate certify(std::string_view text) {
    return stagecraft::theory::certify(stagecraft::tableaux::read_tableau(text));
}
/// The same for a file.
inline stagecraft::theory::file_certificate certify_file(const std::string& path) {
    return stagecraft::theory::certify(stagecraft::tableaux::read_tableau_file(path));
}
/// theory::certify of a method of one or several tableaux; partners are files relative to `folder`.
inline stagecraft::theory::file_certificate certify_method(std::string_view text,
                                                           const std::string& folder = ".") {
    return stagecraft::theory::certify(stagecraft::tableaux::read_method_text(text, {}, folder));
}
/// theory::certify_text: what the command prints, and its exit code.
inline int exit_code(std::string_view text, bool as_json, std::string& out, std::string& err,
                     const stagecraft::tableaux::reading& how = {}) {
    std::ostringstream o, e;
    const int code = stagecraft::theory::certify_text(text, as_json, o, e, how);
    out = o.str();
    err = e.str();
    return code;
}

}  // namespace checked
