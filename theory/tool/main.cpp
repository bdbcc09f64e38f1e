// SPDX-License-Identifier: BSL-1.0
// The command `stagecraft`. Every other source file here declares its subcommands itself (command.hpp).
// Exit status: 0 done; 1 the command says so (a claim refuted, an internal error); 2 bad input.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string>

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

int complain(std::string what) {
    for (char& c : what)
        if (c == '\n') c = ' ';
    std::cerr << "stagecraft: " << what << '\n';
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Runge-Kutta methods: exact tableaux and what is proved of them", "stagecraft");
    app.require_subcommand(1);
    for (const auto declare : stagecraft::tool::declarations()) declare(app);
    try {
        if (argc > 1 && argv[1][0] != '-' && !has_subcommand(app, argv[1]))
            return complain("unknown subcommand '" + std::string(argv[1]) + "'; allowed: " + allowed(app));
        app.parse(argc, argv);
        return 0;
    } catch (const CLI::RuntimeError& e) {
        return e.get_exit_code();
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return app.exit(e);  // --help
        return complain(std::string(e.what()) + "; allowed: " + allowed(app));
    } catch (const std::invalid_argument& e) {
        return complain(e.what());
    } catch (const std::exception& e) {
        std::cerr << "stagecraft: " << e.what() << '\n';
        return 1;
    }
}
