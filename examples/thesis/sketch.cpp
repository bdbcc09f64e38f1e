// SPDX-License-Identifier: BSL-1.0
// Figure 4.1 of the thesis: what the coordinates of the rolling disc are.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "placed.hpp"

namespace thesis {

namespace {

constexpr const char *ink = "#222", *blue = "#0072b2", *red = "#d55e00", *grey = "#888";

// The disc of the picture: a state (x, y, alpha, beta, gamma) in which no line hides another.
placed chosen() {
    Eigen::VectorXd y(5);
    y << 0.22, -0.1, 1.1, 0.3, 1.2;
    return placed(y);
}

// In pixels, right and down.
Eigen::Vector2d pixel(const point& p) {
    const Eigen::Vector2d f = seen(p);
    return {210 + 1500 * f[0], 425 - 1500 * f[1]};
}
std::string at(const point& p) {
    const Eigen::Vector2d x = pixel(p);
    char text[40];
    std::snprintf(text, sizeof text, "%.1f,%.1f", x[0], x[1]);
    return text;
}

std::string line(const std::vector<point>& points, const char* colour, const std::string& more = "") {
    std::string text;
    for (const point& p : points) text += at(p) + " ";
    return "<polyline points=\"" + text + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"2\" " +
           more + "/>\n";
}
std::string arrow(const point& from, const point& to, const char* colour) {
    return line({from, to}, colour, "marker-end=\"url(#head)\"");
}
std::string dashed(const point& from, const point& to) {
    return line({from, to}, grey, "stroke-dasharray=\"5 4\"");
}

// From direction a to direction b, at that distance from a point.
std::string angle(const point& from, const point& a, const point& b, double distance, const char* colour) {
    std::vector<point> arc;
    for (int k = 0; k <= 20; ++k)
        arc.push_back(from + distance * ((1 - k / 20.) * a + k / 20. * b).normalized());
    return line(arc, colour);
}

std::string letter(const point& p, const char* text, int right, int down) {
    const Eigen::Vector2d x = pixel(p);
    char placed_at[80];
    std::snprintf(placed_at, sizeof placed_at, "x=\"%.1f\" y=\"%.1f\"", x[0] + right, x[1] + down);
    return std::string("<text ") + placed_at + " font-size=\"20\" font-style=\"italic\">" + text +
           "</text>\n";
}

}  // namespace

std::string disc_sketch() {
    const placed disc = chosen();
    const point origin(0, 0, 0), X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);
    const point side(-disc.ahead[1], disc.ahead[0], 0);  // the frame that is turned by alpha: ahead, side
    const point foot = disc.ahead.dot(disc.contact) * disc.ahead, top = disc.contact + 2 * radius * disc.up;
    std::string rim;
    for (int k = 0; k < corners; ++k) rim += at(disc.rim(2 * std::acos(-1.0) * k / corners)) + " ";
    std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 920 560\" "
        "font-family=\"Helvetica,Arial,sans-serif\">\n<defs><marker id=\"head\" viewBox=\"0 0 10 10\" "
        "refX=\"9\" "
        "refY=\"5\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\"><path d=\"M0 1L9 5L0 9\" "
        "fill=\"none\" "
        "stroke=\"#222\"/></marker></defs>\n<rect width=\"920\" height=\"100%\" fill=\"#fff\"/>\n<text "
        "x=\"460\" "
        "y=\"30\" font-size=\"18\" text-anchor=\"middle\">4.1 The rolling disc and its coordinates</text>\n";
    svg += arrow(origin, 0.26 * X, ink) + arrow(origin, 0.3 * Y, ink) + arrow(origin, 0.2 * Z, ink);
    svg += arrow(origin, foot + 0.12 * disc.ahead, grey);
    svg += dashed(foot, disc.contact) + dashed(disc.contact, disc.contact + 2.2 * radius * Z);
    svg += "<polygon points=\"" + rim + "\" fill=\"" + blue + "\" fill-opacity=\"0.2\" stroke=\"" + blue +
           "\" stroke-width=\"3\"/>\n";
    svg +=
        line({disc.contact, top}, blue, "stroke-dasharray=\"2 3\"") + line({disc.centre(), disc.mark()}, ink);
    svg += arrow(disc.contact, disc.contact + 0.13 * disc.ahead, red);
    svg += angle(origin, X, disc.ahead, 0.11, red) + angle(disc.contact, Z, disc.up, 2.1 * radius, red) +
           angle(disc.centre(), disc.up, (disc.mark() - disc.centre()) / radius, 0.45 * radius, red);
    svg += letter(origin + 0.26 * X, "X", 6, 8) + letter(origin + 0.3 * Y, "Y", 4, -4) +
           letter(origin + 0.2 * Z, "Z", 6, 4) +
           letter(origin + 0.13 * (X + disc.ahead).normalized(), "α", 0, 8) + letter(foot / 2, "x", -4, -8) +
           letter((foot + disc.contact) / 2, "y", -24, 14) +
           letter(disc.contact + 2.2 * radius * (Z + disc.up).normalized(), "β", -6, -6) +
           letter(disc.centre() + 0.6 * radius * (disc.up + disc.ahead).normalized(), "γ", 0, 0) +
           letter((disc.centre() + disc.mark()) / 2, "R", 8, 16) + letter(disc.contact, "P", -6, 24);
    return svg + "</svg>\n";
}

}  // namespace thesis
