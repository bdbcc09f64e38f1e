// SPDX-License-Identifier: BSL-1.0
#include "problems.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <problems/equations.hpp>
#include <problems/rolling_disc/disc.hpp>
#include <problems/stiff.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/problem/with.hpp>
#include <stdexcept>
#include <work_precision/nonstiff.hpp>

#include "runs.hpp"

namespace playground {

namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
template <class S, int N>
using vec = Eigen::Matrix<S, N, 1>;

VectorXd numbers(std::initializer_list<double> x) {
    return VectorXd::Map(x.begin(), static_cast<Eigen::Index>(x.size()));
}

/// F, for states of N numbers, as the one type of this page.
template <int N, class F>
problem of(F f, VectorXd y0, std::function<VectorXd(double)> solution = {}) {
    auto one = stagecraft::erased<vec<double, N>>(std::move(f));
    if constexpr (std::same_as<decltype(one), stagecraft::erased_dae>)
        return {std::move(one), std::move(y0), std::move(solution)};
    else
        return {
            stagecraft::with_index(stagecraft::with_mass(std::move(one), MatrixXd(MatrixXd::Identity(N, N))),
                                   std::vector<int>(N, 1)),
            std::move(y0), std::move(solution)};
}

struct logistic {
    template <class S>
    void operator()(const S&, const vec<S, 1>& y, vec<S, 1>& f) const {
        f[0] = y[0] * (1.0 - y[0]);
    }
};
struct lotka_volterra {
    template <class S>
    void operator()(const S&, const vec<S, 2>& y, vec<S, 2>& f) const {
        f[0] = y[0] * (1.0 - y[1]);
        f[1] = y[1] * (y[0] - 1.0);
    }
};
struct brusselator {
    double b;
    template <class S>
    void operator()(const S&, const vec<S, 2>& y, vec<S, 2>& f) const {
        const S reaction = y[0] * y[0] * y[1];
        f[0] = 1.0 + reaction - (b + 1.0) * y[0];
        f[1] = b * y[0] - reaction;
    }
};
template <class Problem, int N>
struct by_slopes {
    template <class S>
    void operator()(const S&, const vec<S, N>& y, vec<S, N>& f) const {
        Problem::slopes(y.data(), f.data());
    }
};
struct prothero_robinson {
    double stiffness;
    template <class S>
    void operator()(const S& t, const vec<S, 1>& y, vec<S, 1>& f) const {
        using std::cos;
        using std::sin;
        f[0] = -stiffness * (y[0] - cos(t)) - sin(t);
    }
};

/// A mass of 1 at the end of a rod of length 1, g = 1, in Cartesian coordinates; the constraint is that of the position,
/// p.p = 1, or of the velocity, p.v = 0.
template <bool OfPosition>
struct pendulum {
    template <class S>
    void operator()(const S&, const vec<S, 5>& y, vec<S, 5>& f) const {
        f[0] = y[2];
        f[1] = y[3];
        f[2] = -y[0] * y[4];
        f[3] = -1.0 - y[1] * y[4];
        f[4] = OfPosition ? S(y[0] * y[0] + y[1] * y[1] - 1.0) : S(y[0] * y[2] + y[1] * y[3]);
    }
    Eigen::DiagonalMatrix<double, 5> mass() const {
        Eigen::DiagonalMatrix<double, 5> m;
        m.diagonal() << 1, 1, 1, 1, 0;
        return m;
    }
    std::array<int, 5> index() const {
        return OfPosition ? std::array{1, 1, 2, 2, 3} : std::array{1, 1, 1, 1, 2};
    }
};
struct pendulum_angle {
    template <class S>
    void operator()(const S&, const vec<S, 2>& y, vec<S, 2>& f) const {
        using std::sin;
        f[0] = y[1];
        f[1] = -sin(y[0]);
    }
};

/// From the angle, which has an ordinary differential equation, released where the rod is level.
VectorXd pendulum_at(double t) {
    const VectorXd angle = accurate(of<2>(pendulum_angle{}, numbers({std::numbers::pi / 2, 0})), t);
    const double s = std::sin(angle[0]), c = std::cos(angle[0]), w = angle[1];
    return numbers({s, -c, w * c, w * s, w * w + c});
}
template <bool OfPosition>
problem make_pendulum(double) {
    return of<5>(pendulum<OfPosition>{}, numbers({1, 0, 0, 0, 0}), pendulum_at);
}

/// Two rods of length 1 with masses of 1 at their ends, g = 1, their angles from hanging down.
struct double_pendulum {
    template <class S>
    void operator()(const S&, const vec<S, 4>& y, vec<S, 4>& f) const {
        using std::cos;
        using std::sin;
        const S s = sin(y[0] - y[1]), c = cos(y[0] - y[1]);
        const S first = -s * y[3] * y[3] - 2.0 * sin(y[0]), second = s * y[2] * y[2] - sin(y[1]);
        f[0] = y[2];
        f[1] = y[3];
        f[2] = (first - c * second) / (1.0 + s * s);
        f[3] = (2.0 * second - c * first) / (1.0 + s * s);
    }
};

problem make_disc(double degrees) {
    const rolling_disc::disc<double> body;
    vec<double, 5> q = vec<double, 5>::Zero();
    q[3] = degrees * std::numbers::pi / 180;
    const auto rolling = stagecraft::index_2(body);
    const VectorXd start = rolling.initial_state(q, rolling_disc::initial_velocity(body));
    return of<12>(rolling, start);
}

const std::vector<problem_kind> kinds{
    {"logistic",
     "Logistic growth",
     "y′ = y (1 − y), y(0) = 1/10",
     "lecture, 1.3",
     {"y"},
     10,
     4,
     [](double) {
         return of<1>(logistic{}, numbers({0.1}),
                      [](double t) { return numbers({1 / (1 + 9 * std::exp(-t))}); });
     }},
    {"lotka_volterra",
     "Predator and prey (Lotka, Volterra)",
     "u′ = u (1 − v), v′ = v (u − 1)",
     "Hairer, Lubich, Wanner, I.1",
     {"u", "v"},
     20,
     3,
     [](double) {
         return of<2>(lotka_volterra{}, numbers({2, 2}));
     },
     {},
     0,
     1},
    {"kepler",
     "Two bodies (Kepler), eccentricity 0.6",
     "q″ = −q/|q|³",
     "Hairer, Lubich, Wanner, I.2",
     {"q₁", "q₂", "v₁", "v₂"},
     20,
     3,
     [](double) { return of<4>(problems::kepler{}, problems::kepler::initial()); },
     {},
     0,
     1},
    {"arenstorf",
     "Arenstorf's orbit between earth and moon",
     "the restricted problem of three bodies",
     "Hairer, Norsett, Wanner I, II.0",
     {"x", "y", "x′", "y′"},
     problems::arenstorf::t1,
     1,
     [](double) { return of<4>(by_slopes<problems::arenstorf, 4>{}, problems::arenstorf::initial()); },
     {},
     0,
     1},
    {"lorenz",
     "Lorenz’ attractor",
     "x′ = 10 (y − x), y′ = x (28 − z) − y, z′ = x y − 8/3 z",
     "Hairer, Norsett, Wanner I, I.16",
     {"x", "y", "z"},
     30,
     1,
     [](double) { return of<3>(by_slopes<problems::lorenz, 3>{}, problems::lorenz::initial()); },
     {},
     0,
     2},
    {"brusselator",
     "Brusselator",
     "u′ = 1 + u² v − (B + 1) u, v′ = B u − u² v",
     "Hairer, Norsett, Wanner I, I.16",
     {"u", "v"},
     20,
     2,
     [](double b) {
         return of<2>(brusselator{b}, numbers({1.5, 3}));
     },
     {"B", 3, 0.1, 10},
     0,
     1},
    {"van_der_pol",
     "van der Pol’s oscillator",
     "y′ = z, ε z′ = (1 − y²) z − y",
     "Hairer, Wanner II, IV.10",
     {"y", "z"},
     4,
     0.5,
     [](double e) {
         return of<2>(equations::van_der_pol{e}, numbers({2, -0.66}));
     },
     {"ε", 0.01, 1e-9, 10},
     0,
     1},
    {"robertson",
     "Robertson’s reaction",
     "A′ = −0.04 A + 10⁴ B C, B′ = −A′ − C′, C′ = 3·10⁷ B²",
     "Hairer, Wanner II, IV.10",
     {"A", "B", "C"},
     1e11,
     10,
     [](double) {
         return of<3>(equations::robertson{}, numbers({1, 0, 0}));
     },
     {},
     -1,
     -1,
     true,
     problems::robertson::atol_scale},
    {"oregonator",
     "Oregonator",
     "a model of the reaction of Belousov and Zhabotinskii",
     "Hairer, Wanner II, IV.10",
     {"y₁", "y₂", "y₃"},
     360,
     1,
     [](double) {
         return of<3>(equations::oregonator{}, numbers({1, 2, 3}));
     },
     {},
     -1,
     -1,
     false,
     problems::oregonator::atol_scale},
    {"hires",
     "HIRES",
     "eight reactions of plants in light",
     "Hairer, Wanner II, IV.10",
     {"y₁", "y₂", "y₃", "y₄", "y₅", "y₆", "y₇", "y₈"},
     321.8122,
     5,
     [](double) { return of<8>(equations::hires{}, problems::hires::initial()); },
     {},
     -1,
     -1,
     false,
     problems::hires::atol_scale},
    {"prothero_robinson",
     "Order reduction (Prothero, Robinson)",
     "y′ = −λ (y − cos t) − sin t, y(0) = 1",
     "Hairer, Wanner II, IV.15",
     {"y"},
     10,
     2,
     [](double k) {
         return of<1>(prothero_robinson{k}, numbers({1}), [](double t) { return numbers({std::cos(t)}); });
     },
     {"λ", 1e4, 1, 1e8}},
    {"index_two",
     "A differential-algebraic problem of index 2",
     "y₁′ = y₁ y₂² z², y₂′ = y₁² y₂² − 3 y₂² z, 0 = y₁² y₂ − 1",
     "Hairer, Lubich, Roche 1989",
     {"y₁", "y₂", "z"},
     1,
     0.5,
     [](double) {
         return of<3>(equations::index_two{}, numbers({1, 1, 1}), [](double t) {
             return numbers({std::exp(t), std::exp(-2 * t), std::exp(2 * t)});
         });
     }},
    {"index_three",
     "A differential-algebraic problem of index 3 (Jay)",
     "y, z with 0 = y₁ y₂² − 1 and a multiplier u",
     "Jay 1993",
     {"y₁", "y₂", "z₁", "z₂", "u"},
     1,
     0.5,
     [](double) {
         return of<5>(equations::index_three{}, numbers({1, 1, 1, 1, 1}), [](double t) {
             const double a = std::exp(2 * t), b = std::exp(-t);
             return numbers({a, b, a, b, std::exp(t)});
         });
     }},
    {"pendulum_3",
     "Pendulum, index 3: its position is constrained",
     "p″ = (0, −1) − λ p, 0 = p·p − 1",
     "Hairer, Wanner II, VII.1",
     {"p₁", "p₂", "v₁", "v₂", "λ"},
     15,
     1,
     make_pendulum<true>,
     {},
     0,
     1},
    {"pendulum_2",
     "Pendulum, index 2: its velocity is constrained",
     "p″ = (0, −1) − λ p, 0 = p·p′",
     "Hairer, Wanner II, VII.1",
     {"p₁", "p₂", "v₁", "v₂", "λ"},
     15,
     1,
     make_pendulum<false>,
     {},
     0,
     1},
    {"double_pendulum",
     "Double pendulum, from rest",
     "2 α″ + β″ cos(α − β) + β′² sin(α − β) + 2 sin α = 0, β″ + α″ cos(α − β) − α′² sin(α − β) + sin β = 0",
     "Hairer, Norsett, Wanner I, I.6",
     {"α", "β", "α′", "β′"},
     30,
     1,
     [](double degrees) {
         const double angle = degrees * std::numbers::pi / 180;
         return of<4>(double_pendulum{}, numbers({angle, angle, 0, 0}));
     },
     {"both angles, in degrees", 120, 0.0001, 180}},
    {"rolling_disc",
     "Rolling disc, nonholonomic, index 2",
     "M(q) v′ = F(q, v) − Gᵀλ, 0 = G(q) v",
     "Braun, diploma thesis 2013, 4.1",
     {"x", "y", "α heading", "β leaning", "γ rolling", "x′", "y′", "α′", "β′", "γ′", "λ₁", "λ₂"},
     3,
     0.2,
     make_disc,
     {"leaning, in degrees", 5, 0.1, 60},
     2,
     3}};

}  // namespace

std::span<const problem_kind> problem_kinds() { return kinds; }

const problem_kind& kind_of_problem(std::string_view name) {
    for (const auto& k : kinds)
        if (k.name == name) return k;
    throw std::invalid_argument("problem: '" + std::string(name) + "' is none of those of this page");
}

}  // namespace playground
