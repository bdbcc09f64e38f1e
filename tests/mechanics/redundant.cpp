// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE redundant
#include <Eigen/Core>
#include <boost/test/unit_test.hpp>
#include <functional>
#include <stdexcept>
#include <string>

#include <problems/sparse_once.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/sized_formulations.hpp>

using namespace stagecraft;
using Eigen::VectorXd;

namespace {

void check_named(const std::function<void()>& call, const std::string& what) {
    BOOST_CHECK_EXCEPTION(call(), std::domain_error, [&](const std::domain_error& e) {
        BOOST_TEST_MESSAGE(e.what());
        return std::string(e.what()).find(what) != std::string::npos;
    });
}

// A parallelogram: a bar held by two or three parallel cranks of length 1 at x = 0, 1, 2. Its end points are
// (q0, q1) and (q2, q3), the bar is of length 2; the third crank holds its middle and follows from the others.
struct parallelogram {
    static constexpr int coordinates = 4, constraints = 4;

    template <class S>
    Eigen::Matrix<S, 4, 1> g(const Eigen::Matrix<S, 4, 1>& q) const {
        const S x = (q[0] + q[2]) / 2 - 1, y = (q[1] + q[3]) / 2, dx = q[2] - q[0], dy = q[3] - q[1];
        Eigen::Matrix<S, 4, 1> g;
        g << q[0] * q[0] + q[1] * q[1] - 1, (q[2] - 2) * (q[2] - 2) + q[3] * q[3] - 1, dx * dx + dy * dy - 4,
            x * x + y * y - 1;
        return g;
    }
};

struct sized_parallelogram {
    int coordinates() const { return 4; }
    int constraints() const { return 4; }
    Eigen::MatrixXd M() const { return Eigen::MatrixXd::Identity(4, 4) * scale; }
    VectorXd F(const VectorXd&, const VectorXd&) const { return Eigen::Vector4d(0, -9.81, 0, -9.81) * scale; }
    VectorXd g(const VectorXd& q) const { return parallelogram().g<double>(q); }
    Eigen::MatrixXd G(const VectorXd& q) const {
        const double x = (q[0] + q[2]) / 2 - 1, y = (q[1] + q[3]) / 2, dx = q[2] - q[0], dy = q[3] - q[1];
        Eigen::Matrix4d G;
        G << 2 * q[0], 2 * q[1], 0, 0, 0, 0, 2 * (q[2] - 2), 2 * q[3], -2 * dx, -2 * dy, 2 * dx, 2 * dy, x, y,
            x, y;
        return G;
    }
    double scale = 1;  // of masses, in whatever unit
};

// The same bar in space, where four constraints leave two degrees of freedom.
struct hanging_bar {
    static constexpr int coordinates = 6, constraints = 4;
    double mass = 1;
    template <class S>
    Eigen::Matrix<S, 6, 6> M(const Eigen::Matrix<S, 6, 1>&) const {
        return Eigen::Matrix<S, 6, 6>::Identity() * S(mass);
    }
    template <class S>
    Eigen::Matrix<S, 6, 1> F(const Eigen::Matrix<S, 6, 1>&, const Eigen::Matrix<S, 6, 1>&) const {
        return Eigen::Matrix<S, 6, 1>::Constant(S(0));
    }
    template <class S>
    Eigen::Matrix<S, 4, 1> g(const Eigen::Matrix<S, 6, 1>& q) const {
        Eigen::Matrix<S, 4, 1> plane;
        plane << q[0], q[1], q[2], q[3];
        return parallelogram().g<S>(plane);
    }
    template <class S>
    Eigen::Matrix<S, 4, 6> G(const Eigen::Matrix<S, 6, 1>& q) const {
        const S x = (q[0] + q[2]) / 2 - 1, y = (q[1] + q[3]) / 2, dx = q[2] - q[0], dy = q[3] - q[1];
        Eigen::Matrix<S, 4, 6> G = Eigen::Matrix<S, 4, 6>::Constant(S(0));
        G(0, 0) = 2 * q[0], G(0, 1) = 2 * q[1], G(1, 2) = 2 * (q[2] - 2), G(1, 3) = 2 * q[3];
        G(2, 0) = -2 * dx, G(2, 1) = -2 * dy, G(2, 2) = 2 * dx, G(2, 3) = 2 * dy;
        G(3, 0) = x, G(3, 1) = y, G(3, 2) = x, G(3, 3) = y;
        return G;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_start_of_a_fixed_size_names_the_redundant_constraint) {
    Eigen::Matrix<double, 6, 1> q, v = Eigen::Matrix<double, 6, 1>::Zero();
    q << 0.6, -0.8, 2.6, -0.8, 0, 0;
    const std::string third = "G has rank 3 of 4 here; constraints that depend on others: 3";
    check_named([&] { index_2(hanging_bar{}).initial_state(q, v); }, third);
    check_named([&] { index_reduced(hanging_bar{}).initial_state(q, v); }, third);
    check_named([&] { baumgarte(hanging_bar{}, 5, 5).initial_state(q, v); }, third);
    check_named([&] { assemble(hanging_bar{}, q, v); }, third);
    hanging_bar weightless;
    weightless.mass = 0;
    check_named([&] { index_2(weightless).initial_state(q, v); },
                "M(q) is not positive definite here: the mass of coordinate 0");
    q[0] = q[1] = 0;  // the first crank has no length: no direction either
    check_named([&] { assemble(hanging_bar{}, q, v); }, "constraint 0 has a row of zeros in G");
}

BOOST_AUTO_TEST_CASE(every_start_of_a_run_time_size_names_the_redundant_constraint) {
    const VectorXd q = Eigen::Vector4d(0.6, -0.8, 2.6, -0.8), v = VectorXd::Zero(4);
    for (const double scale : {1.0, 1e-20, 1e20}) {
        const sized_parallelogram model{scale};
        check_named([&] { index_2(model, q).initial_state(q, v); }, "G has rank 3 of 4 here; constraints");
        check_named([&] { assemble(model, q, v); }, "depend on others");
        check_named([&] { assemble(model, Eigen::Vector4d(0, 0, 2.6, -0.8), v); },
                    "constraint 0 has a row of zeros in G");
        // Without it the bar swings like a mass point on a crank: G a = 0 at rest.
        const auto independent = independent_constraints(model, q);
        BOOST_TEST(independent.rows().rank == 3);
        const VectorXd y = index_2(independent, q).initial_state(q, v);
        BOOST_TEST(y.size() == 8 + 3);
        const VectorXd balance = model.F(q, v) - independent.G(q, 0).transpose() * y.tail(3);
        const double along = 0.8 * balance[0] + 0.6 * balance[1];  // the tangent (0.8, 0.6) of the crank
        BOOST_TEST(std::abs(along + 0.6 * 9.81 * scale) < 1e-9 * scale);
        BOOST_TEST(std::abs(0.6 * balance[0] - 0.8 * balance[1]) < 1e-9 * scale);
    }
}

BOOST_AUTO_TEST_CASE(a_model_of_run_time_size_is_assembled_from_rough_coordinates) {
    const VectorXd exact = Eigen::Vector4d(0.6, -0.8, 2.6, -0.8),
                   rough = exact + 0.02 * Eigen::Vector4d(1, 0, -1, 1);
    const auto model = independent_constraints(sized_parallelogram{}, rough);
    const auto three = independent_constraints(sized_parallelogram{}, exact);
    BOOST_TEST(model.rows().rank == 4);  // off the constraints nothing shows that the fourth is redundant
    const auto start = assemble(three, rough, Eigen::Vector4d(1, 0, 0, 0));
    BOOST_TEST(three.g(start.q, 0).norm() < 1e-14);
    BOOST_TEST((start.q - exact).norm() < 0.05);
    BOOST_CHECK_NO_THROW(index_2(three, exact).initial_state(start.q, start.v));
    check_named([&] { assemble(model, rough, VectorXd::Zero(4)); }, "depend on others");
    BOOST_CHECK_THROW(assemble(three, VectorXd::Zero(3), VectorXd::Zero(4)), std::invalid_argument);
}
