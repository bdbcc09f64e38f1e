// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <stagecraft/mechanics/model.hpp>

namespace stagecraft {

/// An observer for `integrate` that keeps a run away from the positions where M(q) is singular. The model
/// names them (`singularity(q)`, `singular_position`); a run whose states begin with q ends with
/// status::stopped at the first step in which |singularity(q)| falls to `margin` or changes its sign. The
/// continuous solution is examined within the step, so that harmless ends hide nothing. `time` and `position`
/// are those at which the margin is reached; what was computed beyond them must not be used. Pass it as an
/// lvalue:
///
///     singularity_watch watch(body);
///     auto r = integrate(method, index_2(body), y0, t0, t1, options, watch);
///     if (watch.found()) std::cout << watch.message();
template <fixed_size_model Model>
requires names_singular_positions<Model>
class singularity_watch {
  public:
    using coordinates = coordinate_vector<double, Model>;

    /// Throws std::invalid_argument unless margin > 0. At |singularity(q)| = margin the condition number of
    /// M(q) is of the size margin^-2.
    explicit singularity_watch(Model model, double margin = 1e-3)
        : model_(std::move(model)), margin_(margin) {
        if (!(margin > 0)) throw std::invalid_argument("singularity_watch: margin must be positive");
    }

    template <class Vector, class Output>
    bool operator()(double t, const Vector&, double, const Output& output) {
        constexpr int pieces = 4;
        const double start = output.t0();
        double before = start;
        if (sign_ == 0) sign_ = distance(output, start) < 0 ? -1 : 1;
        for (int k = 0; k <= pieces; ++k) {
            const double at = k == pieces ? t : start + (t - start) * k / pieces;
            if (!(sign_ * distance(output, at) > margin_)) {
                locate(output, before, at);
                return false;
            }
            before = at;
        }
        return true;
    }

    bool found() const { return found_; }
    double time() const { return time_; }                   ///< when the margin was reached
    const coordinates& position() const { return where_; }  ///< q there
    /// The position in the model's words and the time, or an empty text if none was met.
    std::string message() const {
        return found_ ? std::string(Model::singular_position) + ", at t = " + std::to_string(time_)
                      : std::string();
    }

  private:
    template <class Output>
    coordinates q(const Output& output, double t) const {
        const auto y = output(t);
        return y.template head<Model::coordinates>();
    }
    template <class Output>
    double distance(const Output& output, double t) const {
        return model_.singularity(q(output, t));
    }
    // Bisection for the first time at which the margin is reached, which lies in (good, bad].
    template <class Output>
    void locate(const Output& output, double good, double bad) {
        for (int k = 0; k < 60; ++k) {
            const double middle = good + (bad - good) / 2;
            (sign_ * distance(output, middle) > margin_ ? good : bad) = middle;
        }
        found_ = true;
        time_ = good;
        where_ = q(output, good);
    }

    Model model_;
    double margin_, time_ = 0;
    int sign_ = 0;
    bool found_ = false;
    coordinates where_ = coordinates::Zero();
};

}  // namespace stagecraft
