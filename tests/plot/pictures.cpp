// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE pictures
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cctype>
#include <cmath>
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

long count(const std::string& text, const std::string& what) {
    long n = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}

/// One picture whose groups close, whose commands end with a semicolon, and whose lengths TeX can hold (16383 pt, 575 cm).
void check_tikz(const std::string& text) {
    BOOST_TEST(count(text, "\\begin{tikzpicture}") == 1);
    BOOST_TEST(text.ends_with("\\end{tikzpicture}\n"));
    BOOST_TEST(count(text, "\\begin{") == count(text, "\\end{"));
    BOOST_TEST(count(text, "{") == count(text, "}"));
    BOOST_TEST(count(text, "$") % 2 == 0);
    BOOST_TEST(text.find("nan") == std::string::npos);
    std::istringstream lines(text);
    double largest = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line[0] == '%') continue;
        const bool drawn = line.starts_with("\\draw") || line.starts_with("\\clip") ||
                           line.starts_with("\\fill") || line.starts_with("\\node");
        BOOST_TEST(drawn == line.ends_with(";"), line.substr(0, 80));
        for (auto at = line.find('('); drawn && at != std::string::npos; at = line.find('(', at + 1))
            if (std::isdigit(static_cast<unsigned char>(line[at + 1])) || line[at + 1] == '-')
                largest = std::max(largest, std::abs(std::stod(line.substr(at + 1))));
    }
    BOOST_TEST(largest < 1500);
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

BOOST_AUTO_TEST_CASE(several_regions_share_a_window_and_each_has_a_line_and_a_name) {
    const folder f;
    const std::string files = source + "/tableaux/";
    const fs::path picture = f.path / "regions.svg";
    const auto draw = [&](const std::string& arguments) {
        const auto done = run(f, "region " + arguments + " -o '" + picture.string() + "'");
        BOOST_TEST(done.exit_code == 0, done.messages);
        return text_of(picture);
    };
    const std::string svg = draw("radau_iia:3 gauss 2 '" + files + "catalogue/classical_rk4.json' '" + files +
                                 "pairs/ark4.json' --implicit -5");
    for (const char* name : {"radau_iia, s = 3", "gauss, s = 2", "(RK4)", "implicit part at z = -5"})
        BOOST_TEST(count(svg, std::string(name) + "<") >= 1, name);
    // The script says what is drawn in front: ticks and border stay visible on the shading.
    const std::string script = draw("radau_iia 3 gauss:2 --script");
    BOOST_TEST(count(script, "set tics front") == 1);
    BOOST_TEST(count(script, "|R| \u2264 1 of ") == 4);  // two methods, both and one of them
    BOOST_TEST(count(script, "lc rgb '#1f4e79'") == 1);
    BOOST_TEST(count(script, "lc rgb '#b71c1c'") == 1);
    BOOST_TEST(count(draw("radau_iia 3"), "|R| \u2264 1 of radau_iia, s = 3<") >= 1);
}

// 1 + 2 + 2*3 + 4*4 + 9*5 nodes of the trees to order 5, each tree one node more than edges; alpha sums to (n - 1)! over the trees
// of an order (Hairer-Norsett-Wanner I.II.2).
BOOST_AUTO_TEST_CASE(the_trees_are_a_sheet_with_their_conditions) {
    const folder f;
    const fs::path picture = f.path / "trees.svg", latex = f.path / "trees.tikz";
    BOOST_TEST(run(f, "trees 5 -o '" + picture.string() + "'", "PATH=/nowhere").exit_code == 0);
    const std::string svg = text_of(picture);
    BOOST_TEST(count(svg, "<circle") == 70);
    BOOST_TEST(count(svg, "<path") == 70 - 17);
    BOOST_TEST(count(svg, "dot(b, c*(A*(c*c))) == 1/15<") == 1);
    BOOST_TEST(count(svg, "order 5   \u03b3 = 15   \u03c3 = 2   \u03b1 = 4<") == 1);
    long sum = 0;
    for (auto at = svg.find(">order 5"); at != std::string::npos; at = svg.find(">order 5", at + 1))
        sum += std::stol(svg.substr(svg.find("\u03b1 = ", at) + std::string("\u03b1 = ").size()));
    BOOST_TEST(sum == 24);
    BOOST_TEST(run(f, "trees 5 -o '" + latex.string() + "'").exit_code == 0);
    const std::string tikz = text_of(latex);
    BOOST_TEST(count(tikz, "circle[radius") == 70);
    BOOST_TEST(count(tikz, "\\draw") == 70 - 17);
    BOOST_TEST(count(tikz, "\\frac{1}{15}$") == 1);
    check_tikz(tikz);
}

BOOST_AUTO_TEST_CASE(regions_are_written_for_latex) {
    const folder f;
    const fs::path latex = f.path / "region.tikz";
    const auto written = [&](const std::string& arguments) {
        const auto done = run(f, "region " + arguments + " -o '" + latex.string() + "'", "PATH=/nowhere");
        BOOST_TEST(done.exit_code == 0, done.messages);
        check_tikz(text_of(latex));
        return text_of(latex);
    };
    const std::string one = written("radau_iia 3");
    BOOST_TEST(count(one, "$|R| \\le 1$ of radau\\_iia, s = 3}") == 1);
    BOOST_TEST(count(one, "{$\\times$};") == 3);  // poles
    BOOST_TEST(count(one, "{$\\circ$};") == 2);   // zeros
    const std::string several =
        written("radau_iia 3 gauss:2 '" + source + "/tableaux/catalogue/classical_rk4.json'");
    BOOST_TEST(count(several, "$|R| \\le 1$ of ") == 5);
    BOOST_TEST(count(several, "dash pattern=on 10pt off 4pt") >= 2);  // in the picture and the legend
    BOOST_TEST(count(several, "\\definecolor") == 6);                 // three lines and three shades
    // Of few digits every coefficient counts, also those that are smaller than a thousand roundings: five zeros.
    const fs::path few = f.path / "few_digits.json";
    std::ofstream(few) << R"({"form": "2N", "A": ["0", "-1.0", "-1.55798", "-1.0", "-0.45031"],
                             "B": ["0.2", "0.83204", "0.6", "0.35394", "0.2"]})";
    BOOST_TEST(count(written("'" + few.string() + "'"), "{$\\circ$};") == 5);
    BOOST_TEST(run(f, "order-star '" + few.string() + "' -o '" + latex.string() + ".svg'").messages ==
               "stagecraft: order-star: the digits are too few to tell R from the exponential near 0\n");
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
    const std::string rk4 = source + "/tableaux/catalogue/classical_rk4.json";
    for (const auto& [arguments, part] :
         {std::pair<std::string, std::string>{"pie gauss 2" + out, "kind"},
          {"region gauss" + out, "stages"},
          {"region gauss 0" + out, "stages"},
          {"region gaus 2" + out, "family"},
          {"region gauss 2", "--output"},
          {"region gauss 2 -o '" + f.path.string() + "/x.gif'", "output"},
          {"region gauss 2 -o /nowhere/x.svg", "output"},
          {"region gauss 2 -w 1,0,0,1" + out, "window"},
          {"tableau gauss 2 -w 0,1,0,1" + out, "window"},
          {"region gauss 2 3" + out, "METHOD"},
          {"region radau_iia:x" + out, "stages"},
          {"region '" + rk4 + "' 3" + out, "stages"},
          {"order-star gauss:2 gauss:3" + out, "METHOD"},
          {"region gauss:1 gauss:2 gauss:3 gauss:4 gauss:5 gauss:6 gauss:7 "
           "gauss:8 gauss:9" +
               out,
           "METHOD: 9 methods"},
          {"trees 11" + out, "N: '11'"},
          {"trees gauss 2" + out, "N: "},
          {"trees 3 -o '" + f.path.string() + "/x.png'", "output"},
          {"tableau gauss 2 -o '" + f.path.string() + "/x.tikz'", "output"},
          {"region gauss 2 --script -o '" + f.path.string() + "/x.tikz'", "script"},
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
