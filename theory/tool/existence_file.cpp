// SPDX-License-Identifier: BSL-1.0
#include "existence_file.hpp"

#include <fstream>
#include <iostream>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/tableaux/time_share.hpp>
#include <stagecraft/theory/existence/existence.hpp>

#include "clock.hpp"
#include "command.hpp"

namespace stagecraft::tool {

int certify_existence_of(const std::string& path, const existence_options& o) {
    const auto file = tableaux::read_method_file(path, o.how);
    const auto certificate = [&] {
        const tableaux::time_share share(seconds_for_decisions());
        return theory::certify_existence(file, o.digits);
    }();
    if (o.json)
        std::cout
            << theory::to_json(certificate).dump(2, ' ', false, nlohmann::json::error_handler_t::replace)
            << '\n';
    else
        std::cout << printable(theory::to_text(certificate));
    if (o.polished.empty()) return certificate.exit_code();
    if (certificate.polished.is_null()) {
        std::cerr << "stagecraft: polished: nothing is written, for nothing is proved\n";
        return certificate.exit_code();
    }
    std::ofstream out(o.polished);
    if (!(out << certificate.polished.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n'))
        throw std::invalid_argument("polished: cannot write " + o.polished);
    return certificate.exit_code();
}

}  // namespace stagecraft::tool
