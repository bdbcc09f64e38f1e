// SPDX-License-Identifier: BSL-1.0
#include "drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "placed.hpp"

namespace thesis {

namespace {

// Seen from above at an angle, in pixels, in the middle of a picture 920 wide.
class view {
  public:
    explicit view(const std::vector<placed>& all) {
        for (const placed& p : all)
            for (int k = 0; k < corners; ++k) include(seen(p.rim(k * step)));
        scale_ = std::min(860 / (high_[0] - low_[0]), 480 / (high_[1] - low_[1]));
        left_ = 460 - scale_ * (high_[0] - low_[0]) / 2;
    }
    std::string operator()(const point& p) const {
        const Eigen::Vector2d f = seen(p);
        char text[40];
        std::snprintf(text, sizeof text, "%.1f,%.1f", left_ + scale_ * (f[0] - low_[0]),
                      60 + scale_ * (high_[1] - f[1]));
        return text;
    }
    std::string rim(const placed& p) const {
        std::string points;
        for (int k = 0; k < corners; ++k) points += (k > 0 ? " " : "") + (*this)(p.rim(k * step));
        return points;
    }
    std::string spoke(const placed& p) const { return (*this)(p.centre()) + " " + (*this)(p.mark()); }
    int height() const { return static_cast<int>(90 + scale_ * (high_[1] - low_[1])); }

  private:
    void include(const Eigen::Vector2d& f) {
        low_ = low_.cwiseMin(f);
        high_ = high_.cwiseMax(f);
    }
    static constexpr double step = 2 * 3.14159265358979323846 / corners;
    Eigen::Vector2d low_{1e300, 1e300}, high_{-1e300, -1e300};
    double scale_ = 1, left_ = 0;
};

std::string opened(const view& eye, const std::string& title) {
    const std::string size = "920 " + std::to_string(eye.height());
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size +
           "\" font-family=\"Helvetica,Arial,sans-serif\">\n<rect width=\"920\" height=\"100%\" "
           "fill=\"#fff\"/>\n<text x=\"460\" y=\"30\" font-size=\"18\" text-anchor=\"middle\">" +
           title + "</text>\n";
}

std::string track(const view& eye, const std::vector<placed>& all) {
    std::string points;
    for (const placed& p : all) points += eye(p.contact) + " ";
    return "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"#d55e00\" stroke-width=\"2\"/>\n";
}

std::string disc_at(const view& eye, const placed& p) {
    return "<polygon points=\"" + eye.rim(p) +
           "\" fill=\"#0072b2\" fill-opacity=\"0.25\" stroke=\"#0072b2\" stroke-width=\"3\"/>\n<polyline "
           "points=\"" +
           eye.spoke(p) + "\" stroke=\"#222\" stroke-width=\"3\"/>\n";
}

// A strip of frames, each with the whole track: the track is not much longer than the disc is wide, and discs in
// one picture would hide each other.
std::string still(const view& eye, const std::vector<placed>& all) {
    const int columns = 4, frames = 12, width = 230, row = 190;
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 920 " +
                      std::to_string(50 + 3 * row) +
                      "\" font-family=\"Helvetica,Arial,sans-serif\">\n<rect width=\"920\" height=\"100%\" "
                      "fill=\"#fff\"/>\n" +
                      "<text x=\"460\" y=\"30\" font-size=\"18\" text-anchor=\"middle\">4.1 The rolling disc "
                      "along the track of its "
                      "contact point</text>\n";
    for (int k = 0; k < frames; ++k) {
        const std::size_t at = static_cast<std::size_t>(k) * (all.size() - 1) / (frames - 1);
        const int x = k % columns * width, y = 40 + k / columns * row;
        char time[40];
        std::snprintf(time, sizeof time, "t = %.2f s", static_cast<double>(k) / (frames - 1));
        // 920 to width, and the panel's own middle under it.
        svg += "<g transform=\"translate(" + std::to_string(x - 46) + "," + std::to_string(y) +
               ") scale(0.35)\">\n" + track(eye, all) + disc_at(eye, all[at]) + "</g>\n<text x=\"" +
               std::to_string(x + 12) + "\" y=\"" + std::to_string(y + 22) + "\" font-size=\"14\">" + time +
               "</text>\n";
    }
    return svg + "</svg>\n";
}

std::string animated(const view& eye, const std::vector<placed>& all) {
    const std::size_t frames = 120;
    std::string rims, spokes;
    for (std::size_t k = 0; k <= frames; ++k) {
        const placed& p = all[k * (all.size() - 1) / frames];
        rims += (k > 0 ? ";" : "") + eye.rim(p);
        spokes += (k > 0 ? ";" : "") + eye.spoke(p);
    }
    const auto moving = [](const std::string& values) {
        return "<animate attributeName=\"points\" dur=\"8s\" repeatCount=\"indefinite\" values=\"" + values +
               "\"/>";
    };
    return opened(eye, "4.1 The rolling disc, one second of its motion in eight") + track(eye, all) +
           "<polygon points=\"" + eye.rim(all.front()) +
           "\" fill=\"#0072b2\" fill-opacity=\"0.25\" stroke=\"#0072b2\" stroke-width=\"2\">" + moving(rims) +
           "</polygon>\n<polyline points=\"" + eye.spoke(all.front()) +
           "\" stroke=\"#222\" stroke-width=\"2\">" + moving(spokes) + "</polyline>\n</svg>\n";
}

}  // namespace

std::vector<drawing> disc_drawings(const trajectory& motion) {
    std::vector<placed> all;
    for (const auto& p : motion.path) all.emplace_back(p.y);
    const view eye(all);
    return {{"fig_4_1", "4.1 The rolling disc along its track", still(eye, all)},
            {"fig_4_1_sketch", "4.1 The rolling disc and its coordinates", disc_sketch()},
            {"fig_4_1_moving", "4.1 The rolling disc, animated", animated(eye, all)}};
}

}  // namespace thesis
