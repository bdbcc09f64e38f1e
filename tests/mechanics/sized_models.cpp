// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE sized_models
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/sparse_once.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/constraint_forces.hpp>
#include <stagecraft/mechanics/sized_formulations.hpp>

using namespace stagecraft;
using Eigen::VectorXd;

namespace {

// A chain of equal links with point masses at its joints, hung at the origin; q = (x_1, y_1, x_2, ...).
struct chain {
    int links = 2;
    double length = 0.5, mass = 0.3;

    int coordinates() const { return 2 * links; }
    int constraints() const { return links; }
    Eigen::DiagonalMatrix<double, Eigen::Dynamic> M() const {
        return Eigen::DiagonalMatrix<double, Eigen::Dynamic>(VectorXd::Constant(coordinates(), mass));
    }
    VectorXd F(const VectorXd&, const VectorXd&) const {
        VectorXd F = VectorXd::Zero(coordinates());
        for (int k = 0; k < links; ++k) F[2 * k + 1] = -mass * 9.81;
        return F;
    }
    VectorXd g(const VectorXd& q) const {
        VectorXd g(links);
        for (int k = 0; k < links; ++k) g[k] = (link(q, k).squaredNorm() - length * length) / 2;
        return g;
    }
    Eigen::SparseMatrix<double> G(const VectorXd& q) const {
        std::vector<Eigen::Triplet<double>> entries;
        for (int k = 0; k < links; ++k)
            for (int i = 0; i < 2; ++i) {
                entries.emplace_back(k, 2 * k + i, link(q, k)[i]);
                if (k > 0) entries.emplace_back(k, 2 * k - 2 + i, -link(q, k)[i]);
            }
        Eigen::SparseMatrix<double> G(links, coordinates());
        G.setFromTriplets(entries.begin(), entries.end());
        return G;
    }
    double energy(const VectorXd& q, const VectorXd& v) const {
        double sum = mass * v.squaredNorm() / 2;
        for (int k = 0; k < links; ++k) sum += mass * 9.81 * q[2 * k + 1];
        return sum;
    }
    VectorXd horizontal() const {
        VectorXd q = VectorXd::Zero(coordinates());
        for (int k = 0; k < links; ++k) q[2 * k] = (k + 1) * length;
        return q;
    }

  private:
    Eigen::Vector2d link(const VectorXd& q, int k) const {
        return k == 0 ? Eigen::Vector2d(q.head(2))
                      : Eigen::Vector2d(q.segment(2 * k, 2) - q.segment(2 * k - 2, 2));
    }
};

// The double pendulum of two such links in its angles, from the textbook (Landau-Lifshitz, Mechanics, section 5).
VectorXd double_pendulum(double t1) {
    const double l = 0.5, g = 9.81;
    const auto f = [=](double, const Eigen::Vector4d& y, Eigen::Vector4d& out) {
        const double s = std::sin(y[0] - y[1]), c = std::cos(y[0] - y[1]), a = y[2], b = y[3];
        Eigen::Matrix2d M;
        M << 2 * l, l * c, c, 1;
        const Eigen::Vector2d r(-l * b * b * s - 2 * g * std::sin(y[0]), a * a * s - g / l * std::sin(y[1]));
        const double det = M(0, 0) * M(1, 1) - M(0, 1) * M(1, 0);
        out << a, b, (M(1, 1) * r[0] - M(0, 1) * r[1]) / det, (M(0, 0) * r[1] - M(1, 0) * r[0]) / det;
    };
    const double right = std::acos(0.0);
    const auto r = integrate(radau_iia<5>(), f, Eigen::Vector4d(right, right, 0, 0), 0.0, t1,
                             {.rtol = 1e-12, .atol = 1e-12});
    VectorXd q(4);
    q << l * std::sin(r.y[0]), -l * std::cos(r.y[0]), 0, 0;
    q.tail(2) = q.head(2) + l * Eigen::Vector2d(std::sin(r.y[1]), -std::cos(r.y[1]));
    return q;
}

// The same with a mass matrix that depends on q formally, dense, and every constraint twice.
struct doubled : chain {
    int constraints() const { return 2 * links; }
    Eigen::MatrixXd M(const VectorXd& q) const {
        return (mass + 0 * q.sum()) * Eigen::MatrixXd::Identity(coordinates(), coordinates());
    }
    VectorXd g(const VectorXd& q) const {
        VectorXd g(2 * links);
        g << chain::g(q), 3 * chain::g(q);
        return g;
    }
    Eigen::MatrixXd G(const VectorXd& q) const {
        Eigen::MatrixXd G(2 * links, coordinates());
        const Eigen::MatrixXd once = chain::G(q);
        G << once, 3 * once;
        return G;
    }
};

// Ropes side by side, their masses tied to those of their neighbours by elastic threads.
struct net {
    int ropes = 25;
    chain rope{40, 0.05, 0.01};
    double stiffness = 20, distance = 0.05;

    int each() const { return rope.coordinates(); }
    int coordinates() const { return ropes * each(); }
    int constraints() const { return ropes * rope.links; }

    Eigen::DiagonalMatrix<double, Eigen::Dynamic> M() const {
        return Eigen::DiagonalMatrix<double, Eigen::Dynamic>(VectorXd::Constant(coordinates(), rope.mass));
    }
    VectorXd F(const VectorXd& q, const VectorXd&) const {
        VectorXd F(coordinates());
        for (int i = 0; i < coordinates(); ++i) F[i] = i % 2 == 0 ? 0 : -rope.mass * 9.81;
        const int step = each();
        for (int i = 0; i + step < coordinates(); ++i) {
            const double pull = stiffness * (q[i + step] - q[i] - (i % 2 == 0 ? distance : 0));
            F[i] += pull;
            F[i + step] -= pull;
        }
        return F;
    }
    /// The link to mass k of rope r from the one above it.
    Eigen::Vector2d link(const VectorXd& q, int r, int k) const {
        const int at = r * each() + 2 * k;
        return k == 0 ? Eigen::Vector2d(q[at] - r * distance, q[at + 1])
                      : Eigen::Vector2d(q[at] - q[at - 2], q[at + 1] - q[at - 1]);
    }
    VectorXd g(const VectorXd& q) const {
        VectorXd g(constraints());
        for (int r = 0; r < ropes; ++r)
            for (int k = 0; k < rope.links; ++k)
                g[r * rope.links + k] = (link(q, r, k).squaredNorm() - rope.length * rope.length) / 2;
        return g;
    }
    Eigen::SparseMatrix<double> G(const VectorXd& q) const {
        Eigen::SparseMatrix<double> G(constraints(), coordinates());
        G.reserve(2 * coordinates());
        for (int r = 0, column = 0; r < ropes; ++r)
            for (int k = 0; k < rope.links; ++k)
                for (int i = 0; i < 2; ++i, ++column) {
                    G.startVec(column);
                    G.insertBack(r * rope.links + k, column) = link(q, r, k)[i];
                    if (k + 1 < rope.links)
                        G.insertBack(r * rope.links + k + 1, column) = -link(q, r, k + 1)[i];
                }
        G.finalize();
        return G;
    }
};

template <class Problem>
auto run(const Problem& problem, const chain& model, double end, double tolerance) {
    const VectorXd q = model.horizontal();
    return integrate(radau_iia<3>(), problem, problem.initial_state(q, VectorXd::Zero(q.size())), 0.0, end,
                     {.rtol = tolerance, .atol = tolerance});
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_links_are_the_double_pendulum_in_every_formulation) {
    const chain model;
    const VectorXd q = model.horizontal(), expected = double_pendulum(1);
    BOOST_TEST((run(index_2(model, q), model, 1, 1e-9).y.head(4) - expected).norm() < 1e-6);
    BOOST_TEST((run(index_3(model, q), model, 1, 1e-9).y.head(4) - expected).norm() < 1e-6);
    BOOST_TEST((run(stabilised_index_2(model, q), model, 1, 1e-9).y.head(4) - expected).norm() < 1e-6);
    BOOST_TEST(
        (run(regularised_position(model, q, 1e-10, 1, 1, 1), model, 1, 1e-9).y.head(4) - expected).norm() <
        1e-6);
}

BOOST_AUTO_TEST_CASE(springs_in_place_of_links_give_way_in_proportion_to_eps) {
    // The static chain: link k carries all masses below it, 9.81 m (links - k) = lambda_k length with the gradient
    // length of g, so that g_k = eps lambda_k / c.
    chain model;
    VectorXd q = VectorXd::Zero(4);
    q[1] = -0.5, q[3] = -1;
    for (const double kappa : {1.0, 0.5}) {
        const auto problem = regularised_position(model, q, 1e-4, kappa, 2, 3);
        const auto r = integrate(radau_iia<3>(), problem, problem.initial_state(q, VectorXd::Zero(4)), 0.0,
                                 1.0, {.rtol = 1e-9, .atol = 1e-9});
        BOOST_TEST(r.ok());
        const VectorXd g = model.g(r.y.head(4));
        for (int k = 0; k < 2; ++k) {
            const double stretched = std::sqrt(0.25 + 2 * g[k]), lambda = 0.3 * 9.81 * (2 - k) / stretched;
            BOOST_TEST(g[k] == 1e-4 / 2 * lambda, boost::test_tools::tolerance(2e-3));
        }
    }
    BOOST_CHECK_THROW(regularised_position(model, q, -1, 1, 2, 3), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(redundant_constraints_are_named_and_left_out) {
    const doubled model;
    const VectorXd q = model.horizontal(), v = VectorXd::Zero(4);
    BOOST_CHECK_THROW(index_2(model, q).initial_state(q, v), std::domain_error);
    const auto independent = independent_constraints(model, q);
    BOOST_TEST(independent.rows().rank == 2);
    BOOST_TEST(independent.rows().dependent.size() == 2u);
    const auto dae = index_2(independent, q);
    BOOST_TEST(dae.size() == 3 * 4 + 2);
    const auto r = run(dae, model, 1, 1e-9);
    BOOST_TEST(r.ok());
    BOOST_TEST((r.y.head(4) - double_pendulum(1)).norm() < 1e-6);
}

BOOST_AUTO_TEST_CASE(a_start_off_the_constraints_says_by_how_much) {
    const chain model;
    VectorXd q = model.horizontal(), v = VectorXd::Zero(4);
    v[2] = 0.25;  // stretches the second link of length 0.5
    BOOST_CHECK_EXCEPTION(index_2(model, q).initial_state(q, v), std::invalid_argument, [](const auto& e) {
        return std::string(e.what()).find("velocity constraint 1 is 0.125") != std::string::npos;
    });
}

BOOST_AUTO_TEST_CASE(a_chain_of_200_links_falls_with_its_energy_and_its_lengths) {
    chain model;
    model.links = 200;
    model.length = 0.01;
    const VectorXd q = model.horizontal();
    const auto dae = index_2(model, q);
    BOOST_TEST(dae.size() == 1000);
    BOOST_TEST(dae.sparsity().nonZeros() < 20 * 1000);
    const auto r = run(dae, model, 0.2, 1e-7);
    BOOST_TEST(r.ok());
    const VectorXd end = r.y.head(400), speed = r.y.segment(400, 400);
    BOOST_TEST(model.g(end).cwiseAbs().maxCoeff() < 1e-7);
    BOOST_TEST((model.G(end) * speed).cwiseAbs().maxCoeff() < 1e-7);
    const double turned_over = 60 * 9.81 * 0.2;  // all 60 kg by 0.2 m
    BOOST_TEST(std::abs(model.energy(end, speed) - model.energy(q, VectorXd::Zero(400))) <
               1e-6 * turned_over);
    BOOST_TEST(std::abs(end[399] + 9.81 * 0.2 * 0.2 / 2) <
               1e-6);  // no wave has reached its free end: it falls freely
}

// With G^T mu in place of unit vectors rounding errors of g in mu were a tenth of the tolerance: the run ended.
BOOST_AUTO_TEST_CASE(a_stabilised_chain_of_short_links_runs_at_tight_tolerances) {
    chain model{20, 0.05, 0.05};
    const VectorXd q = model.horizontal(), v = VectorXd::Zero(40);
    const auto both = stabilised_index_2(model, q);
    const auto r =
        integrate(radau_iia<7>(), both, both.initial_state(q, v), 0.0, 0.5, {.rtol = 1e-12, .atol = 1e-12});
    BOOST_TEST(r.ok());
    BOOST_TEST(model.g(r.y.head(40)).cwiseAbs().maxCoeff() < 1e-12);
    BOOST_TEST(std::abs(model.energy(r.y.head(40), r.y.segment(40, 40)) - model.energy(q, v)) < 1e-9);
    BOOST_TEST(r.report.rejected() < r.report.steps / 4);
}

// All ropes swing alike, the threads stay as long as they are: each moves as a rope alone does.
BOOST_AUTO_TEST_CASE(a_net_of_1000_point_masses_swings_as_its_ropes_do) {
    const net model;
    VectorXd hanging = VectorXd::Zero(model.each()), pushed = VectorXd::Zero(model.each());
    for (int k = 0; k < model.rope.links; ++k) {
        hanging[2 * k + 1] = -(k + 1) * model.rope.length;
        pushed[2 * k] = 0.5 + 0.02 * k;
    }
    VectorXd q(model.coordinates()), v(model.coordinates());
    for (int r = 0; r < model.ropes; ++r) {
        VectorXd own = hanging;
        for (int i = 0; i < model.each(); i += 2) own[i] += r * model.distance;
        q.segment(r * model.each(), model.each()) = own;
        v.segment(r * model.each(), model.each()) = pushed;
    }
    const options<double> loose{.rtol = 1e-5, .atol = 1e-5}, tight{.rtol = 1e-9, .atol = 1e-9};
    const auto all = index_2(model, q);
    BOOST_TEST(all.size() == 5000);
    const auto r = integrate(radau_iia<3>(), all, all.initial_state(q, v), 0.0, 0.03, loose);
    BOOST_TEST(r.ok());
    const auto one = index_2(model.rope, hanging);
    const auto alone = integrate(radau_iia<3>(), one, one.initial_state(hanging, pushed), 0.0, 0.03, tight);
    BOOST_TEST(alone.ok());
    for (int k = 0; k < model.ropes; ++k) {
        VectorXd own = r.y.segment(k * model.each(), model.each());
        for (int i = 0; i < model.each(); i += 2) own[i] -= k * model.distance;
        BOOST_TEST((own - alone.y.head(model.each())).cwiseAbs().maxCoeff() < 1e-4);
    }
    BOOST_TEST((alone.y.head(model.each()) - hanging).cwiseAbs().maxCoeff() > 0.01);
    BOOST_TEST(
        (constraint_forces(one, alone.y) * VectorXd::Ones(40) - one.constraint_force(0.03, alone.y)).norm() <
        1e-12);
}
