// SPDX-License-Identifier: BSL-1.0
#include "certify_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <stagecraft/tableaux/program_text.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/time_share.hpp>
#include <stagecraft/theory/judging/certify_partitioned.hpp>
#include <stagecraft/theory/judging/difference.hpp>
#include <stagecraft/theory/judging/junit.hpp>
#include <stagecraft/theory/judging/method_table.hpp>

#include "clock.hpp"
#include "command.hpp"

namespace stagecraft::tool {

namespace {

using theory::file_certificate;

/// What a file holds: one tableau or method, or the tableaux of a program and what of it was not used.
struct judged_file {
    std::vector<file_certificate> certificates;
    std::vector<tableaux::unusable_tableau> unusable;
    std::vector<std::string> unused;

    /// "not used: E (line 12), order_of_embedded (line 3)"; empty where everything was.
    std::string unused_text() const {
        std::string text;
        const std::size_t shown = std::min<std::size_t>(unused.size(), 40);
        for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "not used: " : ", ") + unused[i];
        return shown < unused.size() ? text + " and " + std::to_string(unused.size() - shown) + " more"
                                     : text;
    }
};

/// The certificate of a tableau or method; what is not decided within the seconds allowed says so.
template <class File>
file_certificate certified_in_time(const File& file) {
    const tableaux::time_share share(seconds_for_decisions());
    return theory::certify(file);
}

judged_file judged_program(const std::string& path, const certify_options& o) {
    try {
        auto program = tableaux::read_program_text(tableaux::text_of_file(path), o.how);
        const bool alone = program.tableaux.size() + program.unusable.size() == 1;
        if (alone && !program.unusable.empty()) throw tableaux::unusable_input(program.unusable.front().what);
        judged_file out{{}, std::move(program.unusable), std::move(program.unused)};
        for (const auto& tableau : program.tableaux) {
            if (!alone) start_clock(path + ": " + tableau.name);
            out.certificates.push_back(certified_in_time(tableau));
        }
        return out;
    } catch (const tableaux::unusable_input& e) {
        throw tableaux::unusable_input(path + ": " + e.what());
    }
}

judged_file judged(const std::string& path, const certify_options& o) {
    if (o.from_text) return judged_program(path, o);
    return {{certified_in_time(tableaux::read_method_file(path, o.how))}, {}, {}};
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

std::string line_of(const nlohmann::ordered_json& json) {
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// One of several files, in a line of text or of JSON: {"file": ..., what its certificate says}.
void print_line(const theory::file_outcome& outcome, const nlohmann::ordered_json* certificate) {
    if (!certificate) {
        std::cout << printable(outcome.path + ": " + outcome.summary) << std::endl;
        return;
    }
    nlohmann::ordered_json line{{"file", outcome.path}};
    line.update(*certificate);
    std::cout << line_of(line) << std::flush;
}

nlohmann::ordered_json unusable_json(const std::string& what) { return {{"exit_code", 2}, {"error", what}}; }

/// Prints the certificates of the only file: as JSON one object, or a line for each where there are several.
void print_all(const judged_file& file, const certify_options& o) {
    const bool several = file.certificates.size() + file.unusable.size() > 1;
    if (o.json && !several) {
        auto all = theory::to_json(file.certificates.front());
        if (!file.unused.empty()) all["not_used"] = file.unused;
        std::cout << all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
        return;
    }
    for (const auto& c : file.certificates)
        std::cout << (o.json ? line_of(theory::to_json(c)) : printable(theory::to_text(c)));
    for (const auto& u : file.unusable) {
        nlohmann::ordered_json json{{"name", u.name}};
        json.update(unusable_json(u.what));
        std::cout << (o.json ? line_of(json) : printable(u.name + "\n  verdict: unusable: " + u.what + "\n"));
    }
    if (file.unused.empty()) return;
    std::cout << (o.json ? line_of({{"exit_code", o.strict ? 2 : 0}, {"not_used", file.unused}})
                         : printable(file.unused_text()) + "\n");
}

/// What the parts of a file say: each tableau, and what was not used.
void take_outcomes(const std::string& path, const judged_file& file, const certify_options& o,
                   const std::function<void(theory::file_outcome, const nlohmann::ordered_json&)>& take) {
    const bool several = file.certificates.size() + file.unusable.size() > 1;
    const auto named = [&](const std::string& name) { return several ? path + ": " + name : path; };
    for (const auto& c : file.certificates)
        take({named(c.name), c.exit_code(), one_line(c)}, theory::to_json(c));
    for (const auto& u : file.unusable) take({named(u.name), 2, u.what}, unusable_json(u.what));
    const int code = o.strict ? 2 : 0;
    if (!file.unused.empty())
        take({path, code, file.unused_text()}, {{"exit_code", code}, {"not_used", file.unused}});
}

}  // namespace

int certify_files(const std::vector<std::string>& paths, const certify_options& o) {
    const bool single = paths.size() == 1 && !std::filesystem::is_directory(paths.front());
    std::vector<theory::file_outcome> all;
    const auto take = [&](theory::file_outcome outcome, const nlohmann::ordered_json& json) {
        if (!single) print_line(outcome, o.json ? &json : nullptr);
        all.push_back(std::move(outcome));
    };
    for (const std::string& path : with_folders_opened(paths)) {
        if (!single) start_clock(path);
        try {
            const auto file = judged(path, o);
            if (single) print_all(file, o);
            take_outcomes(path, file, o, take);
        } catch (const tableaux::unusable_input& e) {
            if (single && o.junit.empty()) throw;
            if (single) std::cerr << "stagecraft: " << printable(e.what()) << '\n';
            if (single && o.json) print_unusable(e.what());
            take({path, 2, e.what()}, unusable_json(e.what()));
        }
    }
    if (!o.junit.empty()) {
        std::ofstream out(o.junit);
        if (!(out << theory::junit_text(all))) throw std::invalid_argument("junit: cannot write " + o.junit);
    }
    return theory::exit_code(all);
}

void print_unusable(const std::string& what) { std::cout << line_of(unusable_json(what)); }

int diff_files(const std::string& first, const std::string& second, const tableaux::reading& how) {
    const auto read = [&](const std::string& path) {
        const auto file = tableaux::read_tableau_file(path, how);
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

void print_method_table(const std::vector<std::string>& paths, const tableaux::reading& how) {
    std::string table = theory::method_table_head();
    for (const std::string& path : with_folders_opened(paths))
        table += theory::method_row(theory::certify(tableaux::read_tableau_file(path, how)));
    std::cout << table;
}

}  // namespace stagecraft::tool
