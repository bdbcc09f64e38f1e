// SPDX-License-Identifier: BSL-1.0
#include "certify_file.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stagecraft/tableaux/program_text.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/theory/judging/certify_partitioned.hpp>
#include <stagecraft/theory/judging/difference.hpp>
#include <stagecraft/theory/judging/junit.hpp>
#include <stagecraft/theory/judging/method_table.hpp>

#include "clock.hpp"

namespace stagecraft::tool {

namespace {

using theory::file_certificate;

file_certificate certificate_of(const std::string& path, const certify_options& o) {
    if (!o.from_text) return theory::certify(tableaux::read_method_file(path, o.how));
    try {
        return theory::certify(tableaux::read_program_text(tableaux::text_of_file(path), o.how));
    } catch (const tableaux::unusable_input& e) {
        throw tableaux::unusable_input(path + ": " + e.what());
    }
}

std::vector<std::string> with_folders_opened(const std::vector<std::string>& paths) {
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        if (!std::filesystem::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        const auto inside = theory::tableau_files_in(path);
        if (inside.empty())  // or whoever checks a folder that was renamed would never learn it
            throw tableaux::unusable_input(path + ": no tableau file (*.json) in this folder");
        for (const auto& file : inside) files.push_back(file.string());
    }
    return files;
}

/// One of several files, in a line of text or of JSON: {"file": ..., what its certificate says}.
void print_line(const theory::file_outcome& outcome, const nlohmann::ordered_json* certificate) {
    if (!certificate) {
        std::cout << outcome.path << ": " << outcome.summary << std::endl;
        return;
    }
    nlohmann::ordered_json line{{"file", outcome.path}};
    line.update(*certificate);
    std::cout << line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
}

}  // namespace

int certify_files(const std::vector<std::string>& paths, const certify_options& o) {
    const bool single = paths.size() == 1 && !std::filesystem::is_directory(paths.front());
    std::vector<theory::file_outcome> all;
    for (const std::string& path : with_folders_opened(paths)) {
        theory::file_outcome outcome{path, 0, {}};
        nlohmann::ordered_json json;
        if (!single) start_clock(path);
        try {
            const auto certificate = certificate_of(path, o);
            outcome = {path, certificate.exit_code(), one_line(certificate)};
            if (single)
                std::cout << (o.json ? theory::json_text(certificate) : theory::to_text(certificate));
            else if (o.json)
                json = theory::to_json(certificate);
        } catch (const tableaux::unusable_input& e) {
            if (single) throw;
            outcome = {path, 2, e.what()};
            json = {{"exit_code", 2}, {"error", e.what()}};
        }
        if (!single) print_line(outcome, o.json ? &json : nullptr);
        all.push_back(std::move(outcome));
    }
    if (!o.junit.empty()) {
        std::ofstream out(o.junit);
        if (!(out << theory::junit_text(all))) throw std::invalid_argument("junit: cannot write " + o.junit);
    }
    return theory::exit_code(all);
}

int diff_files(const std::string& first, const std::string& second) {
    const auto read = [](const std::string& path) {
        const auto file = tableaux::read_tableau_file(path);
        return theory::certified_file{file, theory::certify(file)};
    };
    const auto x = read(first), y = read(second);
    const auto lines = theory::differences(x, y);
    for (const std::string& line : lines) std::cout << line << '\n';
    if (lines.empty())
        std::cout << (theory::all_exact(x.file) && theory::all_exact(y.file)
                          ? "no difference\n"
                          : "no difference but what the rounding of their digits explains\n");
    return lines.empty() ? 0 : 1;
}

void print_method_table(const std::vector<std::string>& paths) {
    std::string table = theory::method_table_head();
    for (const std::string& path : with_folders_opened(paths))
        table += theory::method_row(theory::certify(tableaux::read_tableau_file(path)));
    std::cout << table;
}

}  // namespace stagecraft::tool
