// SPDX-License-Identifier: BSL-1.0
// Prints README.md: which extremes were tried, what holds, and what is refused with which words. Ends with 1 where a row no
// longer holds, with the row on stderr.
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/banded_blocks.hpp>
#include <string>

namespace {

namespace sc = stagecraft;
using V = Eigen::VectorXd;
using M = Eigen::MatrixXd;
using options = sc::options<double>;
using limits = std::numeric_limits<double>;

const double nan = limits::quiet_NaN(), infinity = limits::infinity(), eps = limits::epsilon();

/// Right-hand side and Jacobian of one type for all rows: an integrator is compiled for a type.
struct equation {
    std::function<void(double, const V&, V&)> f;
    std::function<M(double, const V&)> J;
    void operator()(double t, const V& y, V& out) const { f(t, y, out); }
    void jacobian(double t, const V& y, M& out) const { out = J(t, y); }
};
struct with_mass : equation {
    M of;
    const M& mass() const { return of; }
};

equation linear(M A) {
    return {[A](double, const V& y, V& f) { f = A * y; }, [A](double, const V&) { return A; }};
}
equation scalar(double lambda) { return linear(M::Constant(1, 1, lambda)); }
/// y' = -rate (y - cos t) - sin t, y = cos t.
equation prothero_robinson(double rate) {
    return {[rate](double t, const V& y, V& f) {
                f = V::Constant(1, -rate * (y[0] - std::cos(t)) - std::sin(t));
            },
            [rate](double, const V&) { return M::Constant(1, 1, -rate); }};
}
/// y' = -y until t = 1, then `after`.
equation until_one(std::function<void(V&)> after) {
    return {[after](double t, const V& y, V& f) {
                f = -y;
                if (t > 1) after(f);
            },
            [](double, const V& y) { return M(-M::Identity(y.size(), y.size())); }};
}

auto run(const auto& problem, const V& y0, double t0, double t1, const options& o = {}) {
    return sc::integrate(sc::radau_iia<3>(), problem, y0, t0, t1, o);
}
const V one = V::Ones(1);

/// The name of the status, and what was thrown.
std::string words(const auto& r) {
    std::string text = "`" + std::string(name(r.status)) + "`";
    if (r.exception) try {
            std::rethrow_exception(r.exception);
        } catch (const std::exception& e) {
            text += std::string(": ") + e.what();
        }
    return text;
}

/// What is thrown before the run begins.
std::string refusal(const auto& problem, const V& y0, double t0, double t1, const options& o = {}) {
    try {
        return "not refused, " + words(run(problem, y0, t0, t1, o));
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
}

class table {
  public:
    table() { std::puts("| tried | what happens | in its words |\n|---|---|---|"); }
    void row(const char* tried, const char* what, const std::string& said, bool holds) {
        std::printf("| %s | %s | %s |\n", tried, what, said.c_str());
        if (holds) return;
        std::fprintf(stderr, "no longer holds: %s: %s (%s)\n", tried, what, said.c_str());
        good_ = false;
    }
    /// A run that is to end well.
    void success(const char* tried, const char* what, const auto& r, bool holds) {
        row(tried, what, words(r), r.ok() && holds);
    }
    /// One that is not, with these words.
    void refused(const char* tried, const char* what, const std::string& said, const char* expected,
                 bool holds = true) {
        row(tried, what, said, holds && said.find(expected) != std::string::npos);
    }
    bool good() const { return good_; }

  private:
    bool good_ = true;
};

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

void eigenvalues(table& t) {
    std::string said;
    bool damped = true;
    for (const double lambda : {-1e8, -1e150, -1e300}) {
        const auto r = run(scalar(lambda), one, 0, 1);
        damped = damped && r.ok() && std::abs(r.y[0]) < 1e-5 && r.report.steps < 400;
        said = words(r);
    }
    t.row("y' = λ y, λ = -1e8, -1e150, -1e300", "damped to zero in less than 400 steps", said, damped);
    const auto beyond = run(scalar(-1e307), one, 0, 1);
    t.refused("λ = -1e307", "f(y0) over the tolerance is no double: y stays y0", words(beyond), "non_finite",
              beyond.y == one);
    const auto grows = run(scalar(700), one, 0, 1);
    t.success("λ = 700", "e^700 = 1e304 to 1e-2", grows, near(grows.y[0] / std::exp(700.0), 1, 1e-2));
    bool refused = true;
    said.clear();
    for (const double lambda : {1e3, 1e150, 1e300}) {
        const auto r = run(scalar(lambda), one, 0, 1);
        refused = refused && !r.ok() && std::isfinite(r.y[0]) && r.t < 1;
        if (said.find(words(r)) == std::string::npos) said += (said.empty() ? "" : ", ") + words(r);
    }
    t.row("λ = 1e3, 1e150, 1e300", "no success where y is no double; the last state is finite", said,
          refused);
    bool nothing = true;
    for (const double lambda : {1e-300, -1e-310, limits::denorm_min(), 0.0}) {
        const auto r = run(scalar(lambda), one, 0, 1);
        nothing = nothing && r.ok() && r.y == one;
        said = words(r);
    }
    t.row("λ = 1e-300, -1e-310, the least double, 0", "y stays 1 to the last bit", said, nothing);
    const auto turning = run(linear(M{{0, 1e8}, {-1e8, 0}}), V{{1, 0}}, 0, 1, {.max_steps = 2000});
    t.refused("λ = ±1e8 i, 2000 steps allowed", "resolved as far as they go, with an error below 1e-2",
              words(turning), "too_many_steps",
              turning.t > 0 && near(turning.y[0], std::cos(1e8 * turning.t), 1e-2));
    bool exact = true;
    for (const double rate : {1e2, 1e6, 1e12, 1e100}) {
        const auto r = run(prothero_robinson(rate), one, 0, 2, {.rtol = 1e-8, .atol = 1e-8});
        exact = exact && r.ok() && near(r.y[0], std::cos(2.0), 3e-7);
        said = words(r);
    }
    t.row("y' = -λ (y - cos t) - sin t, λ = 1e2 ... 1e100, tolerance 1e-8", "within 30 tolerances", said,
          exact);
}

void masses(table& t) {
    std::string said;
    bool uniform = true;
    for (const double e : {1e-2, 1e-16, 1e-100, 1e-300, limits::denorm_min(), 0.0}) {
        const double start = e == 1e-2 ? 1 / (1 - e) : 1;  // z = y / (1 - eps) has no layer
        const auto r = run(with_mass{linear(M{{-1, 0}, {1, -1}}), M{{1, 0}, {0, e}}}, V{{1, start}}, 0, 1,
                           {.rtol = 1e-8, .atol = 1e-8});
        uniform = uniform && r.ok() && near(r.y[0], std::exp(-1.0), 1e-7) &&
                  near(r.y[1], start * std::exp(-1.0), 1e-7) && r.report.steps < 50;
        said = words(r);
    }
    t.row("y' = -y, ε z' = y - z, ε = 1e-2 ... 1e-300, the least double, 0",
          "within 10 tolerances, in less than 50 steps", said, uniform);
    bool rows = true;
    for (const double s : {1e-150, 1e-12, 1e12, 1e150}) {
        const with_mass p{linear(M{{-1 * s, 0}, {0, -2 / s}}), M{{s, 0}, {0, 1 / s}}};
        const auto r = run(p, V{{1, 1}}, 0, 1, {.rtol = 1e-8, .atol = 1e-8});
        rows = rows && r.ok() && near(r.y[0], std::exp(-1.0), 1e-7) && near(r.y[1], std::exp(-2.0), 1e-7);
        said = words(r);
    }
    t.row("M = diag(s, 1/s), s = 1e-150 ... 1e150",
          "the scale of an equation makes no difference: within 10 tolerances", said, rows);
    const auto singular = run(with_mass{linear(M{{-1, 0}, {0, 0}}), M{{1, 0}, {0, 0}}}, V{{1, 2}}, 0, 1);
    t.refused("0 y₂' = 0, a pencil that is singular", "no step is taken", words(singular), "singular_matrix",
              singular.t == 0);
    const auto off = run(with_mass{linear(M{{-1, 0}, {1, -1}}), M{{1, 0}, {0, 0}}}, V{{1, 5}}, 0, 1);
    t.success("0 = y - z, from z = 5 and y = 1", "z is moved to y", off, near(off.y[1], off.y[0], 1e-5));
}

void times(table& t) {
    const double late = 1e15;
    const auto slow = run(scalar(-1e-6), one, late, late + 1e6);
    t.success("t0 = 1e15, where doubles are 1/8 apart, over 1e6", "as from t0 = 0", slow,
              slow.t == late + 1e6 && near(slow.y[0], std::exp(-1.0), 1e-5));
    const auto fast =
        run(linear(M{{0, 30}, {-30, 0}}), V{{1, 0}}, late, late + 10, {.rtol = 1e-10, .atol = 1e-10});
    t.refused("t0 = 1e15, an oscillation that needs steps of 1/100", "y stays y0", words(fast),
              "step_underflow", fast.t == late);
    bool small = true;
    std::string said;
    for (const double span : {1e-15, 1e-200, 1e-300}) {
        const auto r = run(scalar(-1 / span), one, 0, span);
        small = small && r.ok() && r.t == span && near(r.y[0], std::exp(-1.0), 1e-5);
        said = words(r);
    }
    t.row("y' = -y/T over T = 1e-15, 1e-200, 1e-300", "as over 1", said, small);
    const auto ulp = run(scalar(-1), one, 1, 1 + eps);
    t.success("from 1 to the next double", "one step", ulp, ulp.t == 1 + eps && ulp.report.steps == 1);
    const auto none = run(scalar(-1), one, 1, 1);
    t.success("t1 = t0", "y0", none, none.y == one && none.report.steps == 0);
    bool large = true;
    for (const double span : {1e300, 1e307, -1e307}) {
        const auto r = run(scalar(span > 0 ? -1 : 1), one, 0, span);
        large = large && r.ok() && r.t == span && std::abs(r.y[0]) < 1e-5;
        said = words(r);
    }
    t.row("y' = -y over 1e300, 1e307; y' = y over -1e307", "zero", said, large);
    t.refused("from -1e308 to 1e308", "the span is no double", refusal(scalar(-1), one, -1e308, 1e308),
              "t1 must be finite");
    t.refused("t0 = NaN", "refused", refusal(scalar(-1), one, nan, 1), "t0 must be finite");
}

void tolerances(table& t) {
    const auto tight = run(prothero_robinson(1), one, 0, 2, {.rtol = 4 * eps, .atol = 4 * eps});
    t.success("rtol = atol = 4 ε = 8.9e-16", "within 30 ε", tight, near(tight.y[0], std::cos(2.0), 30 * eps));
    t.refused("rtol = ε", "refused", refusal(scalar(-1), one, 0, 1, {.rtol = eps}),
              "rtol must be at least four times");
    t.refused("atol = 0", "refused", refusal(scalar(-1), one, 0, 1, {.atol = 0}), "atol must be positive");
    t.refused("atol = 1e-320", "refused", refusal(scalar(-1), one, 0, 1, {.atol = 1e-320}),
              "its inverse overflows");
    const auto coarse = run(scalar(-1), one, 0, 1, {.rtol = 0.5, .atol = 0.5});
    t.success("rtol = atol = 1/2", "within the tolerance", coarse, near(coarse.y[0], std::exp(-1.0), 0.5));
}

void states(table& t) {
    const auto decays = run(scalar(-1), one, 0, 730, {.rtol = 1e-6, .atol = limits::min()});
    t.success("y' = -y to 730, atol the least normal double", "down to e^-730 = 9e-318, a denormal", decays,
              std::abs(decays.y[0]) < 1e-307);
    const auto tiny = run(scalar(-1), V::Constant(1, 1e-310), 0, 1, {.atol = limits::min()});
    t.success("y0 = 1e-310, a denormal", "within atol", tiny,
              near(tiny.y[0], 1e-310 * std::exp(-1.0), limits::min()));
    const auto huge = run(scalar(-1), V::Constant(1, 1e307), 0, 1);
    t.success("y0 = 1e307", "relative error below 1e-5", huge, near(huge.y[0] / 1e307, std::exp(-1.0), 1e-5));
    t.refused("y0 = ∞", "refused", refusal(scalar(-1), V::Constant(1, infinity), 0, 1), "y0 must be finite");
    const auto empty = run(until_one([](V&) {}), V(0), 0, 1);
    t.success("n = 0", "reaches t1", empty, empty.t == 1 && empty.y.size() == 0);
}

/// y_i' = -(1 + i) (y_i - y_{i-1}), a million of them, of which the first decays as e^-t.
struct million {
    void operator()(double, const V& y, V& f) const {
        for (Eigen::Index i = 0; i < y.size(); ++i)
            f[i] = -(1.0 + double(i)) * (y[i] - (i > 0 ? y[i - 1] : 0));
    }
    sc::bandwidth bandwidth() const { return {1, 0}; }
};

void many(table& t) {
    const auto r = run(million{}, V(V::Ones(1'000'000)), 0, 1, {.rtol = 1e-3, .atol = 1e-3});
    // y_1' = -2 (y_1 - y_0): y_1 = 2 e^-t - e^-2t.
    t.success("n = 1e6, bidiagonal, rates 1 ... 1e6", "within the tolerance where the solution is known", r,
              near(r.y[0], std::exp(-1.0), 1e-3) && near(r.y[1], 2 * std::exp(-1.0) - std::exp(-2.0), 2e-3));
}

void right_hand_sides(table& t) {
    for (const auto& [value, tried] :
         {std::pair{nan, "f is NaN for t > 1"}, std::pair{infinity, "f is ∞ for t > 1"}}) {
        const auto r = run(until_one([value](V& f) { f[0] = value; }), one, 0, 2);
        t.refused(tried, "the last state, to the tolerance, is before 1", words(r), "non_finite",
                  r.t <= 1 && r.t > 0.9 && near(r.y[0], std::exp(-r.t), 1e-5));
    }
    const auto enormous = run(until_one([](V& f) { f *= -1e305; }), one, 0, 2);
    t.row("f jumps to 1e305 at t = 1", "no success; the last state is finite", words(enormous),
          !enormous.ok() && enormous.y.allFinite());
    const auto thrown = run(until_one([](V&) { throw std::domain_error("beyond the table"); }), one, 0, 2);
    t.refused("f throws for t > 1", "the same, and what was thrown", words(thrown), "beyond the table",
              thrown.t <= 1 && near(thrown.y[0], std::exp(-thrown.t), 1e-5));
    const auto size = run(until_one([](V& f) { f = V::Ones(3); }), one, 0, 2);
    t.refused("f has three components for t > 1", "the same", words(size), "size_changed", size.t <= 1);
    equation broken = scalar(-1);
    broken.J = [](double, const V&) { return M::Constant(1, 1, nan); };
    const auto jacobian = run(broken, one, 0, 1);
    t.row("the Jacobian is NaN", "y stays y0", words(jacobian), !jacobian.ok() && jacobian.y == one);
    const equation pole{[](double, const V& y, V& f) { f = y.cwiseProduct(y); },
                        [](double, const V& y) { return M::Constant(1, 1, 2 * y[0]); }};
    const auto blow_up = run(pole, one, 0, 2);
    t.refused("y' = y², a pole at t = 1", "ends within 1e-5 of it", words(blow_up), "step_underflow",
              near(blow_up.t, 1, 1e-5) && blow_up.y.allFinite());
}

}  // namespace

int main() {
    std::puts(R"(# Stiff and extreme cases

`build/extremes` prints this page and fails where a row no longer holds; a test compares the two. All runs are by Radau IIA with
three stages. Tolerances are 1e-6 where none are named. Many more cases, with other methods, are in `tests/extremes`.
)");
    table t;
    eigenvalues(t), masses(t), times(t), tolerances(t), states(t), many(t), right_hand_sides(t);
    return t.good() ? 0 : 1;
}
