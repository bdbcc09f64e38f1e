// SPDX-License-Identifier: BSL-1.0
#include "certify_once.hpp"

#include <sstream>
#include <stagecraft/theory/judging/certify_partitioned.hpp>

namespace certify_once {

stagecraft::theory::file_certificate certify(std::string_view text) {
    return stagecraft::theory::certify(stagecraft::tableaux::read_tableau(text));
}

stagecraft::theory::file_certificate certify_file(const std::string& path) {
    return stagecraft::theory::certify(stagecraft::tableaux::read_tableau_file(path));
}

stagecraft::theory::file_certificate certify_method(std::string_view text, const std::string& folder) {
    return stagecraft::theory::certify(stagecraft::tableaux::read_method(text, {}, folder));
}

int exit_code(std::string_view text, bool as_json, std::string& out, std::string& err,
              const stagecraft::tableaux::reading& how) {
    std::ostringstream o, e;
    const int code = stagecraft::theory::certify_text(text, as_json, o, e, how);
    out = o.str();
    err = e.str();
    return code;
}

}  // namespace certify_once
