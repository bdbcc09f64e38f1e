// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE pictures
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {
const std::string source = STAGECRAFT_SOURCE_DIR;
const std::string binary = STAGECRAFT_BINARY_DIR;

struct outcome {
    int exit_code;
    std::string messages;
};

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

struct folder {
    fs::path path = fs::temp_directory_path() / ("stagecraft_pictures_" + std::to_string(::getpid()));
    folder() { fs::create_directories(path); }
    ~folder() { fs::remove_all(path); }
};

outcome run(const folder& f, const std::string& arguments, const std::string& environment = "") {
    const fs::path log = f.path / "log";
    const int status = std::system(
        (environment + " '" + binary + "/stagecraft' plot " + arguments + " 2> '" + log.string() + "'")
            .c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(log)};
}
}  // namespace

BOOST_AUTO_TEST_CASE(every_kind_of_picture_is_drawn) {
    const folder f;
    const std::string gauss_3 = source + "/tableaux/catalogue/gauss_3.json";
    for (const char* kind : {"region", "order-star", "E-polynomial", "tableau"}) {
        for (const std::string& method : {std::string("radau_iia 2"), "'" + gauss_3 + "'"}) {
            const fs::path picture = f.path / "picture.svg";
            const auto done = run(f, kind + (" " + method) + " -o '" + picture.string() + "'");
            BOOST_TEST(done.exit_code == 0, done.messages);
            const std::string svg = text_of(picture);
            BOOST_TEST(svg.find("<svg") != std::string::npos);
            BOOST_TEST(svg.find("</svg>") != std::string::npos);
            BOOST_TEST(svg.find(method[0] == 'r' ? "radau_iia, s = 2" : "Kuntzmann") != std::string::npos);
            if (kind[0] == 'r' || kind[0] == 'o') BOOST_TEST(svg.find("poles of R") != std::string::npos);
            fs::remove(picture);
        }
    }
}

// The slopes are the orders; on the stiff problem those that the theory gives for stiff accuracy and stage order 3 (Hairer-Wanner
// II.IV.15: what stays of an error h^{q+1}/(h lambda) in the last stage), and 1 of implicit Euler.
BOOST_AUTO_TEST_CASE(errors_fall_with_the_order) {
    const folder f;
    const std::string files = source + "/tableaux/catalogue/";
    const auto slopes = [&](const std::string& arguments, const std::vector<const char*>& titles) {
        const fs::path picture = f.path / "error.svg";
        const auto done = run(f, "error " + arguments + " -o '" + picture.string() + "'");
        BOOST_TEST(done.exit_code == 0, done.messages);
        const std::string svg = text_of(picture);
        for (const char* title : titles) BOOST_TEST(svg.find(title) != std::string::npos, title);
    };
    slopes("gauss 2 radau_iia 3 '" + files + "classical_rk4.json' lobatto_iiic 2",
           {"gauss, s = 2 (slope 4.0)", "radau_iia, s = 3 (slope 5.0)", "(RK4) (slope 4.0)",
            "lobatto_iiic, s = 2 (slope 2.0)", "step size h"});
    slopes("gauss 1 --problem oscillator", {"gauss, s = 1 (slope 2.0)"});
    slopes("radau_iia 3 radau_iia 1 --problem prothero-robinson",
           {"radau_iia, s = 3 (slope 3.1)", "radau_iia, s = 1 (slope 1.0)"});
}

BOOST_AUTO_TEST_CASE(a_missing_gnuplot_is_a_clear_message) {
    const folder f;
    const auto done = run(f, "region gauss 2 -o '" + (f.path / "x.svg").string() + "'", "PATH=/nowhere");
    BOOST_TEST(done.exit_code == 2);
    BOOST_TEST(done.messages.find("gnuplot is not installed") != std::string::npos);
    BOOST_TEST(!fs::exists(f.path / "x.svg"));
}

BOOST_AUTO_TEST_CASE(bad_input_is_one_line_and_exit_2) {
    const folder f;
    const std::string out = " -o '" + (f.path / "x.svg").string() + "'";
    for (const auto& [arguments, part] : {std::pair<std::string, std::string>{"pie gauss 2" + out, "kind"},
                                          {"region gauss" + out, "stages"},
                                          {"region gauss 0" + out, "stages"},
                                          {"region gaus 2" + out, "family"},
                                          {"region gauss 2", "--output"},
                                          {"region gauss 2 -o '" + f.path.string() + "/x.gif'", "output"},
                                          {"region gauss 2 -o /nowhere/x.svg", "output"},
                                          {"region gauss 2 -w 1,0,0,1" + out, "window"},
                                          {"tableau gauss 2 -w 0,1,0,1" + out, "window"},
                                          {"region gauss 2 3" + out, "METHOD"},
                                          {"region gauss 2 --problem smooth" + out, "problem"},
                                          {"error gauss 2 --problem nix" + out, "prothero-robinson"},
                                          {"error gauss 2 radau_iia" + out, "stages"},
                                          {"error gauss 2 -w 0,1,0,1" + out, "window"},
                                          {"region /nowhere.json" + out, "/nowhere.json"}}) {
        const auto done = run(f, arguments);
        BOOST_TEST(done.exit_code == 2, arguments);
        BOOST_TEST(done.messages.find(part) != std::string::npos, arguments << ": " << done.messages);
        BOOST_TEST(std::count(done.messages.begin(), done.messages.end(), '\n') == 1, arguments);
    }
}
