// SPDX-License-Identifier: BSL-1.0
// Boundary values whose conditions are not those at two ends alone: inside the interval and across jumps, on integrals, with
// an unknown end, and at infinity. Solutions in closed form.
#include <stagecraft/bvp/multipoint.hpp>
#include <stagecraft/bvp/semi_infinite.hpp>
#include <stagecraft/coefficients/gauss.hpp>

#include "problem.hpp"

namespace campaign {

namespace {

namespace sc = stagecraft;

/// z_i(t) = b_i + m_i t + exp(-mu_i t) a_i sin(omega_i t + phi_i), or tanh and its derivative in turn, in modes: y = limit + Q z.
struct curve {
    VectorXd b, m, mu, a, omega, phi;
    bool kinks = false;

    template <class T>
    T value(const T& t, Eigen::Index i) const {
        using std::cosh;
        using std::exp;
        using std::sin;
        using std::tanh;
        if (!kinks) return T(b[i] + m[i] * t + a[i] * exp(-mu[i] * t) * sin(omega[i] * t + phi[i]));
        const double w = omega[i - i % 2], c = phi[i - i % 2];
        if (i % 2 == 0) return T(tanh(w * t + c) - 1.);
        const T s = T(1.) / cosh(w * t + c);
        return T(w * s * s);
    }
    template <class T>
    T rate(const T& t, Eigen::Index i) const {
        using std::cos;
        using std::exp;
        using std::sin;
        return T(m[i] + a[i] * exp(-mu[i] * t) *
                            (omega[i] * cos(omega[i] * t + phi[i]) - mu[i] * sin(omega[i] * t + phi[i])));
    }
    VectorXd at(double t) const {
        return VectorXd::NullaryExpr(phi.size(), [&](Eigen::Index i) { return value(t, i); });
    }
    /// The integrals of z_i and z_i^2 over [0, end], where mu and m are zero.
    double integral(Eigen::Index i, double end) const {
        return b[i] * end + a[i] / omega[i] * (std::cos(phi[i]) - std::cos(omega[i] * end + phi[i]));
    }
    double integral_of_square(Eigen::Index i, double end) const {
        const double turn = omega[i] * end + phi[i];
        return b[i] * b[i] * end + 2 * a[i] * b[i] / omega[i] * (std::cos(phi[i]) - std::cos(turn)) +
               a[i] * a[i] * (end / 2 - (std::sin(2 * turn) - std::sin(2 * phi[i])) / (4 * omega[i]));
    }
};

/// Modes z' = s' + lambda (z - s) and a small curvature, s the curve, that are turned by Q; behind `jump` with other lambda and
/// another curve. Mode 0 and mode 1 decay, and the parameter, which is to be `p`, moves mode 1, kinks their time.
struct random_modes {
    int n = 2;
    double end = 1, jump = 0, p = 0, shift = 1;
    MatrixXd Q, R, B;  ///< B: behind the jump y - Q s is B times what it was before
    VectorXd limit, c, lambda[2];
    curve s[2];

    int side(double t) const { return t > jump ? 1 : 0; }
    template <class T>
    int side(const T& t) const {
        return side(t.value());
    }
    VectorXd exact(double t, bool before = false) const {
        return limit + Q * s[before && t == jump ? 0 : t >= jump].at(t);
    }
    template <class T>
    static std::vector<T> turned(const MatrixXd& by, const std::vector<T>& v) {
        std::vector<T> out;
        for (Eigen::Index i = 0; i < by.rows(); ++i) {
            T sum = v[0] * by(i, 0);
            for (Eigen::Index k = 1; k < by.cols(); ++k) sum += v[static_cast<std::size_t>(k)] * by(i, k);
            out.push_back(sum);
        }
        return out;
    }
    template <class Y, class U = typename Y::Scalar>
    std::vector<U> modes(const Y& y) const {
        std::vector<U> off;
        for (int i = 0; i < n; ++i) off.push_back(y[i] - limit[i]);
        return turned(Q.transpose(), off);
    }
    template <class Y, class U = typename Y::Scalar>
    U mode(const Y& y, int i) const {
        return modes(y)[static_cast<std::size_t>(i)];
    }

    template <class T, class Y, class P, class Out>
    void operator()(const T& t, const Y& y, const P& q, Out& out) const {
        using U = typename Y::Scalar;
        const curve& here = s[side(t)];
        const VectorXd& rates = lambda[side(t)];
        std::vector<U> z = modes(y);
        std::vector<U> f(z.size(), U(0.));
        const auto at = [](int i) { return static_cast<std::size_t>(i); };
        if (here.kinks) {
            for (int i = 0; i < n; i += 2) {
                const U u = z[at(i)] + 1.;
                f[at(i)] = z[at(i + 1)] * (q[0] / p);
                f[at(i + 1)] = 2 * here.omega[i] * here.omega[i] * u * (u * u - 1.) * (q[0] / p);
            }
        } else {
            z[1] -= shift * (q[0] - p);
            std::vector<U> e;
            for (int i = 0; i < n; ++i) e.push_back(U(here.value(t, i)));
            const auto bend = turned(R, z), own = turned(R, e);
            for (int i = 0; i < n; ++i)
                f[at(i)] = (z[at(i)] - e[at(i)]) * rates[i] + here.rate(t, i) +
                           c[i] * (bend[at(i)] * bend[at(i)] - own[at(i)] * own[at(i)]);
        }
        const auto y_rate = turned(Q, f);
        for (int i = 0; i < n; ++i) out[i] = y_rate[at(i)];
    }
};

/// What is drawn for all classes. Growing modes have the numbers from 2 on.
random_modes draw(dice& d, double end, bool jumps) {
    random_modes r;
    r.n = d.integer(2, 4), r.end = end, r.jump = jumps ? d.between(0.1, 0.9) * end : INFINITY;
    r.p = d.between(0.5, 2), r.shift = d.sign() * d.between(0.5, 2);
    r.Q = d.rotation(r.n), r.R = d.matrix(r.n, r.n), r.c = d.vector(r.n, 0.1 / r.n);
    r.limit = VectorXd::Zero(r.n);
    r.B = MatrixXd::Identity(r.n, r.n) + d.matrix(r.n, r.n, 0.2 / r.n);
    const double slow = d.log_between(0.3, 2), fast = d.log_between(0.3, 30);
    for (const int k : {0, 1}) {
        curve& s = r.s[k];
        s.b = d.vector(r.n), s.a = d.vector(r.n), s.phi = d.vector(r.n, 3.2);
        s.m = s.mu = VectorXd::Zero(r.n), s.omega.resize(r.n), r.lambda[k].resize(r.n);
        s.b[1] = d.between(1.5, 2.5);
        for (int i = 0; i < r.n; ++i) {
            s.omega[i] = d.log_between(0.3, 8);
            const double rate = (i == 0 ? slow : i == 1 ? fast : d.log_between(0.5, 30)) * d.between(1, 1.5);
            r.lambda[k][i] = i < 2 || d.coin() ? -rate : rate;
            if (k == 1 && i > 1) r.lambda[1][i] = std::copysign(rate, r.lambda[0][i]);
        }
    }
    return r;
}

/// Mode i at the end where it is known: the beginning of those that decay, the end of the others; `but` none of those.
template <class R, class Y>
int known_modes(const random_modes& m, const Y& left, const Y& right, R& r, int from) {
    int k = 0;
    for (int i = from; i < m.n; ++i)
        r[k++] = m.lambda[0][i] < 0 ? m.mode(left, i) - m.s[m.side(0.)].value(0., i)
                                    : m.mode(right, i) - m.s[m.side(m.end)].value(m.end, i);
    return k;
}

/// The errors of a run in tolerances; those of y at the mesh, and between its points.
template <class Result>
outcome judged(const Result& r, const random_modes& m, double tol, double length_error) {
    outcome o;
    o.success = r.ok(), o.status = sc::name(r.status), o.steps = r.report.f;
    if (!r.ok()) return o;
    const auto look = [&](const VectorXd& y, const VectorXd& exact) {
        for (Eigen::Index i = 0; i < y.size(); ++i) {
            const double e = std::abs(y[i] - exact[i]) / (1 + std::abs(exact[i]));
            o.worst = std::max(o.worst, std::isnan(e) ? INFINITY : e);
        }
    };
    // With a length that is off, y is compared where both are known.
    for (std::size_t k = 0; k + 1 < r.mesh.size(); ++k)
        for (int j = 0; j < 4; ++j) {
            const double t = r.mesh[k] + j * (r.mesh[k + 1] - r.mesh[k]) / 4;
            look(r.y(t), m.exact(t));
            if (j == 0 && k > 0) look(r.y.before(t), m.exact(t, true));
        }
    look(r.y(r.mesh.back()), m.exact(r.mesh.back()));
    o.worst = std::max({o.worst, std::abs(r.p[0] - m.p) / (1 + m.p), length_error});
    o.t = r.y.t1();
    if (o.worst > 1e-13) o.estimate = r.error.global / o.worst;
    o.worst /= tol;
    return o;
}

VectorXd off(dice& d, const VectorXd& exact) { return exact + d.vector(static_cast<int>(exact.size()), 0.3); }
VectorXd near(dice& d, double p) { return VectorXd::Constant(1, p + d.between(-0.2, 0.2)); }

}  // namespace

/// Mode 0 and the parameter follow from conditions inside, and y jumps at a point, at times that of the first condition.
outcome run_interior(dice d, double tol) {
    const random_modes m = draw(d, d.between(0.5, 2), true);
    const double first = d.integer(0, 4) == 0 ? m.jump : d.between(0.1, 0.9) * m.end,
                 second = d.between(0.3, 0.95) * m.end;
    const auto value = [&m](double t, int i) { return m.s[t > m.jump].value(t, i); };
    const double v = value(first, 0), w = value(second, 1);
    const auto ends = [&m](const auto& left, const auto& right, const auto&, auto& r) {
        known_modes(m, left, right, r, 1);
    };
    const auto inside = [&m, v](const auto& y) {
        const auto z = m.mode(y, 0);
        return z + 0.1 * z * z - (v + 0.1 * v * v);
    };
    const auto driven = [&m, w](const auto& y) { return m.mode(y, 1) - w; };
    const VectorXd before = m.exact(m.jump, true), after = m.exact(m.jump);
    const auto relation = [&m, before, after](const auto& left, const auto& right, auto& r) {
        for (int i = 0; i < m.n; ++i) {
            r[i] = right[i] - after[i];
            for (int k = 0; k < m.n; ++k) r[i] -= m.B(i, k) * (left[k] - before[k]);
        }
    };
    const VectorXd guess = off(d, m.exact(0));
    const auto r = sc::solve_bvp(sc::gauss<5>(),
                                 sc::two_point(m, ends, sc::interior(first, inside),
                                               sc::interior(second, driven), sc::jump_at(m.jump, relation)),
                                 0, m.end, guess, near(d, m.p), {.rtol = tol});
    return judged(r, m, tol, 0);
}

/// Mode 0 and the parameter follow from integrals over all of the interval.
outcome run_integral(dice d, double tol) {
    const random_modes m = draw(d, d.between(0.5, 4), false);
    const auto ends = [&m](const auto& left, const auto& right, const auto&, auto& r) {
        known_modes(m, left, right, r, 1);
    };
    const auto mean = [&m](const auto&, const auto& y) { return m.mode(y, 0); };
    const auto driven = [&m](const auto&, const auto& y, const auto& p) {
        const auto z = m.mode(y, 1);
        return z + 0.1 * z * z + 0.3 * m.shift * p[0];
    };
    const double v = m.s[0].integral(0, m.end), w = m.s[0].integral(1, m.end) +
                                                    0.1 * m.s[0].integral_of_square(1, m.end) +
                                                    0.3 * m.shift * m.p * m.end;
    const VectorXd guess = off(d, m.exact(0));
    const auto r =
        sc::solve_bvp(sc::gauss<5>(), sc::two_point(m, ends, sc::integral(mean, v), sc::integral(driven, w)),
                      0, m.end, guess, near(d, m.p), {.rtol = tol});
    return judged(r, m, tol, 0);
}

/// The end is where mode 0, which rises, has a given value; the parameter follows from mode 1 there.
outcome run_free_length(dice d, double tol) {
    random_modes m = draw(d, d.between(0.5, 4), false);
    m.s[0].m[0] = 1, m.s[0].a[0] *= 0.5 / m.s[0].omega[0];
    const VectorXd end = m.s[0].at(m.end);
    const auto ends = [&m, end](const auto& left, const auto& right, const auto&, auto& r) {
        const int k = known_modes(m, left, right, r, 0);
        r[k] = m.mode(right, 0) - end[0], r[k + 1] = m.mode(right, 1) - end[1];
    };
    const VectorXd guess = off(d, m.exact(0));
    const double b = m.end * d.between(0.8, 1.25);
    const auto r = sc::solve_bvp(sc::gauss<5>(), sc::two_point(m, ends, sc::free_length()), 0, b, guess,
                                 near(d, m.p), {.rtol = tol});
    return judged(r, m, tol, r.ok() ? std::abs(r.y.t1() - m.end) / (1 + m.end) : 0);
}

/// On [0, infinity): modes that approach a limit on a wave that dies away, or kinks u'' = 2 omega^2 u (u^2 - 1); the parameter
/// follows from a condition inside, as what moves the limit, or as the unit of time.
outcome run_semi_infinite(dice d, double tol) {
    random_modes m = draw(d, 1e9, false);
    curve& s = m.s[0];
    s.kinks = m.n % 2 == 0 && d.coin();
    m.limit = d.vector(m.n, 2);
    s.b.setZero();
    for (int i = 0; i < m.n; ++i) {
        s.mu[i] = d.log_between(0.3, 3);
        if (s.kinks) s.omega[i] = d.between(0.4, 1.5), s.phi[i] = d.between(-1, 1);
    }
    const auto limit = [&m](double, const auto& p, auto& y) {
        for (int i = 0; i < m.n; ++i)
            y[i] = m.limit[i] + (m.s[0].kinks ? 0. : m.shift) * m.Q(i, 1) * (p[0] - m.p);
    };
    const auto ends = [&m](const auto& left, const auto&, const auto&, auto& r) {
        int k = 0;
        for (int i = 0; i < m.n; ++i)
            if (m.s[0].kinks ? i % 2 == 0 : m.lambda[0][i] < 0)
                r[k++] = m.mode(left, i) - m.s[0].value(0., i);
    };
    const int watched = s.kinks ? 0 : 1;
    const double inside = d.between(0.5, 2), w = s.value(inside, watched);
    const auto driven = [&m, watched, w](const auto& y) { return m.mode(y, watched) - w; };
    const VectorXd start = off(d, m.exact(0));
    const auto guess = [&m, start](double t) -> VectorXd {
        return m.limit + std::exp(-t) * (start - m.limit);
    };
    const auto r = sc::solve_bvp(sc::gauss<5>(),
                                 sc::two_point(m, ends, sc::interior(inside, driven), sc::to_infinity(limit)),
                                 0, INFINITY, guess, near(d, m.p), {.rtol = tol});
    return judged(r, m, tol, 0);
}

}  // namespace campaign
