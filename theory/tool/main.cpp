// SPDX-License-Identifier: BSL-1.0
// The command `stagecraft`. Every other source file here declares its subcommands itself (command.hpp).
// Exit status: 0 done; 1 the command says so (a claim refuted, files that differ, an internal error); 2 bad
// input; 3 not decided: a claim is beyond what the digits given can test, or enclosures stayed too wide.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <stagecraft/tableaux/precision.hpp>
#include <string>

#include "clock.hpp"
#include "command.hpp"

namespace {

// What may follow: the subcommands, or the arguments and options of the one that was chosen.
std::string allowed(const CLI::App& app) {
    for (const CLI::App* chosen : app.get_subcommands()) return allowed(*chosen);
    std::string list;
    const auto add = [&](const std::string& entry) { (list += list.empty() ? "" : ", ") += entry; };
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
        add(sub->get_name());
    for (const CLI::Option* option : app.get_options())
        add(option->get_positional() ? option->get_name(true) : option->get_name(false, true));
    return list;
}

bool has_subcommand(const CLI::App& app, const std::string& name) {
    return !app.get_subcommands([&](const CLI::App* sub) { return sub->get_name() == name; }).empty();
}

// Exact decisions on large tables can take hours: after --seconds the command says so and ends.
extern "C" void out_of_time(int) {
    static constexpr char text[] = ": not decided within the seconds allowed (--seconds)\n";
    const std::string& file = stagecraft::tool::file_at_work;
    [[maybe_unused]] auto written = file.empty() ? write(STDERR_FILENO, "stagecraft", 10)
                                                 : write(STDERR_FILENO, file.data(), file.size());
    written = write(STDERR_FILENO, text, sizeof text - 1);
    _exit(3);
}

void allow_seconds(const std::string& text) {
    stagecraft::tool::seconds_allowed =
        static_cast<unsigned>(stagecraft::tool::whole_number("--seconds", text, 0, 1000000));
    stagecraft::tool::start_clock();
}

int complain(std::string what) {
    for (char& c : what)
        if (c == '\n') c = ' ';
    std::cerr << "stagecraft: " << stagecraft::tool::printable(what) << '\n';
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Runge-Kutta methods: exact tableaux and what is proved of them", "stagecraft");
    app.footer(
        "Theorems are cited by authors and place, as Hairer-Wanner II.IV.5; theory/BIBLIOGRAPHY.md has them "
        "in full.\n"
        "Exit code: 0 done; 1 refuted, or different; 2 bad input; 3 not decided: beyond what the digits "
        "given can test, say");
    app.require_subcommand(1);
    app.set_version_flag("--version", "stagecraft " STAGECRAFT_VERSION);
    app.fallthrough();
    app.add_option_function<std::string>(
        "--seconds", allow_seconds, "end undecided after so many seconds for a file, 0: never (default 60)");
    for (const auto declare : stagecraft::tool::declarations()) declare(app);
    try {
        if (argc > 1 && argv[1][0] != '-' && !has_subcommand(app, argv[1]))
            return complain("unknown subcommand '" + std::string(argv[1]) + "'; allowed: " + allowed(app));
        std::signal(SIGALRM, out_of_time);
        stagecraft::tool::start_clock();
        app.parse(argc, argv);
        return 0;
    } catch (const CLI::RuntimeError& e) {
        return e.get_exit_code();
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return app.exit(e);  // --help
        return complain(std::string(e.what()) + "; allowed: " + allowed(app));
    } catch (const std::invalid_argument& e) {
        return complain(e.what());
    } catch (const stagecraft::tableaux::undecided& e) {
        std::cerr << "stagecraft: not decided: " << e.what() << '\n';
        return 3;
    } catch (const std::exception& e) {
        std::cerr << "stagecraft: " << e.what() << '\n';
        return 1;
    }
}
