// SPDX-License-Identifier: BSL-1.0
#include "certify_file.hpp"

#include <iostream>
#include <stagecraft/theory/judging/certify_file.hpp>

namespace stagecraft::tool {

int certify_file(const std::string& path, bool json) {
    const auto certificate = theory::certify(tableaux::read_tableau_file(path));
    std::cout << (json ? theory::json_text(certificate) : theory::to_text(certificate));
    return certificate.exit_code();
}

}  // namespace stagecraft::tool
