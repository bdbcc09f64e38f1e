// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE chain_over_edge
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include <problems/sparse_once.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/sized_formulations.hpp>

using namespace stagecraft;
using Eigen::Vector2d, Eigen::VectorXd;

namespace {

// A chain of length 1 and mass 1 that slides without friction over the edge of a table, its links of equal length between
// point masses that follow the rounded edge x y = radius^2, x, y < 0: level on the left, upright below. The first mass
// hangs lowest. One degree of freedom, 2 links - 1 constraints on 2 links coordinates.
struct chain {
    int links = 20;

    double length() const { return 1.0 / links; }
    double radius() const { return 2 * length(); }
    int coordinates() const { return 2 * links; }
    int constraints() const { return 2 * links - 1; }
    Eigen::DiagonalMatrix<double, Eigen::Dynamic> M() const {
        return Eigen::DiagonalMatrix<double, Eigen::Dynamic>(VectorXd::Constant(coordinates(), 1.0 / links));
    }
    VectorXd F(const VectorXd&, const VectorXd&) const {
        VectorXd F = VectorXd::Zero(coordinates());
        for (int k = 0; k < links; ++k) F[2 * k + 1] = -9.81 / links;
        return F;
    }
    VectorXd g(const VectorXd& q) const {
        VectorXd g(constraints());
        for (int k = 0; k < links; ++k) g[k] = q[2 * k] * q[2 * k + 1] - radius() * radius();
        for (int k = 0; k + 1 < links; ++k)
            g[links + k] = (link(q, k).squaredNorm() - length() * length()) / 2;
        return g;
    }
    Eigen::SparseMatrix<double> G(const VectorXd& q) const {
        Eigen::SparseMatrix<double> G(constraints(), coordinates());
        G.reserve(3 * coordinates());
        for (int k = 0; k < links; ++k)
            for (int i = 0; i < 2; ++i) {
                G.startVec(2 * k + i);
                G.insertBack(k, 2 * k + i) = q[2 * k + 1 - i];
                if (k > 0) G.insertBack(links + k - 1, 2 * k + i) = link(q, k - 1)[i];
                if (k + 1 < links) G.insertBack(links + k, 2 * k + i) = -link(q, k)[i];
            }
        G.finalize();
        return G;
    }
    double energy(const VectorXd& q, const VectorXd& v) const {
        double sum = v.squaredNorm() / 2;
        for (int k = 0; k < links; ++k) sum += 9.81 * q[2 * k + 1];
        return sum / links;
    }
    // The first mass at this depth, every other at its distance up the edge from the one before.
    VectorXd hanging(double depth) const {
        VectorXd q(coordinates());
        const double r2 = radius() * radius();
        q.head(2) << -r2 / depth, -depth;
        for (int k = 1; k < links; ++k) {
            const Vector2d last = q.segment(2 * k - 2, 2);
            const auto at = [&](double u) {
                return Vector2d(-radius() * std::exp(u), -radius() * std::exp(-u));
            };
            double low = std::log(-last[0] / radius()), high = low + 20;
            for (int halving = 0; halving < 80; ++halving) {
                const double middle = (low + high) / 2;
                ((at(middle) - last).norm() < length() ? low : high) = middle;
            }
            q.segment(2 * k, 2) = at(low);
        }
        return q;
    }

  private:
    Vector2d link(const VectorXd& q, int k) const { return q.segment(2 * k + 2, 2) - q.segment(2 * k, 2); }
};

// The time that it takes from rest at one depth to another, by energy alone: there is one degree of freedom, so that the
// depth s and its rate say all. t = integral of sqrt((sum |dq_k/ds|^2 / (2 links)) / (V(start) - V(s))) ds, with
// s = start + x^2, by the midpoint rule.
double time_to(const chain& model, double start, double depth) {
    constexpr int pieces = 400;
    const double width = std::sqrt(depth - start) / pieces, ds = 1e-5;
    const VectorXd rest = VectorXd::Zero(model.coordinates());
    const double at_start = model.energy(model.hanging(start), rest);
    double sum = 0;
    for (int k = 0; k < pieces; ++k) {
        const double x = (k + 0.5) * width, s = start + x * x;
        const VectorXd rate = (model.hanging(s + ds) - model.hanging(s - ds)) / (2 * ds);
        const double fallen = at_start - model.energy(model.hanging(s), rest);
        sum += 2 * x * std::sqrt(rate.squaredNorm() / (2 * model.links) / fallen) * width;
    }
    return sum;
}

}  // namespace

// What hangs pulls the rest, s'' = g s for a chain of length 1: s = s(0) cosh(sqrt(g) t), for an ever sharper edge and ever
// shorter links.
BOOST_AUTO_TEST_CASE(a_chain_falls_over_an_edge_as_the_textbook_has_it) {
    const double start = 0.3, end = 0.5, expected = start * std::cosh(std::sqrt(9.81) * end);
    std::vector<double> off;
    for (const int links : {20, 40, 80}) {
        const chain model{links};
        const auto rough = model.hanging(start);
        const auto at = assemble(model, rough, VectorXd::Zero(rough.size()));
        BOOST_TEST((at.q - rough).norm() < 1e-10);
        const auto dae = stabilised_index_2(model, at.q);
        const auto r = integrate(radau_iia<3>(), dae, dae.initial_state(at.q, at.v), 0.0, end,
                                 {.rtol = 1e-7, .atol = 1e-7});
        BOOST_TEST(r.ok());
        const VectorXd q = r.y.head(2 * links), v = r.y.segment(2 * links, 2 * links);
        BOOST_TEST(model.g(q).cwiseAbs().maxCoeff() < 1e-8);
        BOOST_TEST(std::abs(model.energy(q, v) - model.energy(at.q, at.v)) < 1e-6);
        if (links == 20) BOOST_TEST(std::abs(time_to(model, start, -q[1]) - end) < 1e-5);
        off.push_back(std::abs(-q[1] - expected));
    }
    BOOST_TEST_MESSAGE(off[0] << ", " << off[1] << ", " << off[2] << " of " << expected);
    BOOST_TEST(off[1] < off[0]);
    BOOST_TEST(off[2] < off[1]);
    BOOST_TEST(off[2] < 1.1e-2 * expected);
}
