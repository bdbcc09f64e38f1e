// SPDX-License-Identifier: BSL-1.0
#include "export_coq.hpp"

#include <filesystem>
#include <fstream>
#include <stagecraft/coq_generic.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/theory/export/coq_file.hpp>
#include <stdexcept>
#include <system_error>

namespace stagecraft::tool {

namespace {

bool written(const std::filesystem::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary);
    return out << text && out.flush();
}

/// The file is there whole or not at all: it is written beside, then renamed. What is no file, a device or a pipe, is
/// written to and stays what it is.
void write_whole(const std::filesystem::path& path, const std::string& text) {
    const std::invalid_argument cannot("coq: cannot write " + path.string());
    std::error_code failed;
    if (std::filesystem::exists(path, failed) && !std::filesystem::is_regular_file(path, failed)) {
        if (!written(path, text)) throw cannot;
        return;
    }
    auto beside = path;
    beside += ".part";
    if (!written(beside, text)) {
        std::filesystem::remove(beside, failed);
        throw cannot;
    }
    std::filesystem::rename(beside, path, failed);
    if (!failed) return;
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    throw std::invalid_argument("coq: cannot write " + path.string() + ": " + failed.message());
}

void write(const std::string& theorems, const coq_options& o) {
    const std::filesystem::path path(o.path);
    if (!o.split) return write_whole(path, theory::coq_whole(theorems, theory::coq_generic));
    write_whole(path.parent_path() / "stagecraft.v", theory::coq_generic);
    write_whole(path, theory::coq_beside(theorems));
}

}  // namespace

void export_coq(tableaux::family f, int s, const theory::certificate& certificate, const coq_options& o) {
    theory::coq_words words{certificate.method + " of " + std::to_string(s) + (s == 1 ? " stage" : " stages"),
                            {},
                            {},
                            certificate.simplifying,
                            tableaux::nodal_polynomial(f, s)};
    write(theory::coq_theorems(theory::coq_method_of(f, s), words), o);
}

void export_coq(const std::string& tableau, const tableaux::reading& how, const coq_options& o) {
    write(theory::coq_theorems(tableaux::read_tableau_file(tableau, how)), o);
}

}  // namespace stagecraft::tool
