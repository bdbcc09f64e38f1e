// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE wrong_models
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include <problems/sparse_once.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/sized_formulations.hpp>

using namespace stagecraft;
using Eigen::Vector2d;
using Eigen::VectorXd;

// A start of a model with a fault names the fault, in every formulation that would stumble over it later.

namespace {

void check_message(const std::function<void()>& call, const std::string& what) {
    BOOST_CHECK_EXCEPTION(call(), std::domain_error, [&](const std::domain_error& e) {
        BOOST_TEST_MESSAGE(e.what());
        return std::string(e.what()).find(what) != std::string::npos;
    });
}

// A mass point on the unit circle, with its mass matrix and one number that is added to its force and to G v.
struct on_circle {
    static constexpr int coordinates = 2, constraints = 1;
    Eigen::Matrix2d mass = Eigen::Matrix2d::Identity();
    double in_force = 0, in_gradient = 0;

    template <class S>
    Eigen::Matrix<S, 2, 2> M(const Eigen::Matrix<S, 2, 1>&) const {
        return mass.cast<S>();
    }
    template <class S>
    Eigen::Matrix<S, 2, 1> F(const Eigen::Matrix<S, 2, 1>&, const Eigen::Matrix<S, 2, 1>&) const {
        return Eigen::Matrix<S, 2, 1>(S(0), S(in_force));
    }
    // sqrt(q1) has no derivative at q1 = 0.
    template <class S>
    Eigen::Matrix<S, 1, 2> G(const Eigen::Matrix<S, 2, 1>& q) const {
        using std::sqrt;
        const S edge = in_gradient == 0 ? S(0) : S(in_gradient) * sqrt(q[1]);
        return Eigen::Matrix<S, 1, 2>(q[0] + edge, q[1]);
    }
};

struct sized_on_circle {
    double in_force = 0;
    int coordinates() const { return 2; }
    int constraints() const { return 1; }
    Eigen::MatrixXd M() const { return Eigen::MatrixXd::Identity(2, 2); }
    VectorXd F(const VectorXd&, const VectorXd&) const { return Vector2d(0, in_force); }
    Eigen::MatrixXd G(const VectorXd& q) const { return q.transpose(); }
};

void check_starts(const on_circle& model, const std::string& what) {
    const Vector2d q(1, 0), v(0, 0.5);
    check_message([&] { index_2(model).initial_state(q, v); }, what);
    check_message([&] { index_reduced(model).initial_state(q, v); }, what);
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

BOOST_AUTO_TEST_CASE(a_mass_matrix_that_is_not_positive_definite_is_named_rather_than_the_constraint) {
    Eigen::Matrix2d coupled;
    coupled << 1, 2, 2, 1;
    Eigen::Matrix2d unknown = Eigen::Matrix2d::Identity();
    unknown(1, 0) = not_a_number;
    const std::string message = "M(q) is not positive definite here: ";
    const auto check = [](const Eigen::Matrix2d& mass, const std::string& what) {
        const on_circle model{mass};
        check_starts(model, what);
        check_message([&] { assemble(model, Vector2d(1, 0), Vector2d(0, 0.5)); }, what);
    };
    check(Vector2d(1, 0).asDiagonal(), message + "the mass of coordinate 1 is not positive");
    check(Vector2d(-1, -1).asDiagonal(), message + "the mass of coordinate 0 is not positive");
    check(coupled, message + "with coordinate 1 it is singular or indefinite");
    check(unknown, "M(q) is not finite here, in row 1");
    // Masses of very different size are no fault.
    const on_circle unequal{Vector2d(1e20, 1e-20).asDiagonal()};
    BOOST_CHECK_NO_THROW(index_2(unequal).initial_state(Vector2d(1, 0), Vector2d(0, 0.5)));
}

BOOST_AUTO_TEST_CASE(forces_and_gradients_without_a_value_are_named_at_the_start) {
    on_circle pulled, edged;
    pulled.in_force = not_a_number;
    edged.in_gradient = 1;
    check_starts(
        pulled,
        "F (with lagrangian: from Q and the derivatives of T and V) is not finite here, in component 1");
    check_starts(edged, "the derivative of G v + b along the motion is not finite here, in component 0");
    const sized_on_circle sized{not_a_number};
    const VectorXd q = Vector2d(1, 0), v = Vector2d(0, 0.5);
    check_message([&] { index_2(sized, q).initial_state(q, v); }, "F is not finite here, in component 1");
}
