// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE projection_cost
#include <problems/equations.hpp>

#include "projection_cost.hpp"

using Eigen::Vector3d;

namespace {

const auto index_2 = sc::semi_explicit<2, 1>(dae::hlr_f{}, dae::hlr_g{});

// y0^2 + y1^2 and y2 + y3 of y0' = y1, y1' = -y0, y2' = -y2, y3' = y2.
struct rotation {
    void operator()(double, const Eigen::VectorXd& y, Eigen::VectorXd& f) const {
        f << y[1], -y[0], -y[2], y[2];
    }
};
template <derivatives Known>
struct invariants_alone {
    template <class S>
    requires(Known == derivatives::automatic || std::is_same_v<S, double>) void operator()(
        double, const Eigen::Matrix<S, Eigen::Dynamic, 1>& y, Eigen::Matrix<S, 2, 1>& g) const {
        g[0] = y[0] * y[0] + y[1] * y[1] - 1.0;
        g[1] = y[2] + y[3] - 1.0;
    }
};
template <derivatives Known>
struct invariants : invariants_alone<Known> {};
template <>
struct invariants<derivatives::own> : invariants_alone<derivatives::own> {
    void jacobian(double, const Eigen::VectorXd& y, Eigen::Matrix<double, 2, Eigen::Dynamic>& G) const {
        G << 2 * y[0], 2 * y[1], 0, 0, 0, 0, 1, 1;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_projection_allocates_nothing_per_step_for_states_of_fixed_size) {
    for (const bool hidden : {false, true})
        for (const bool along : {false, true})
            BOOST_TEST(allocations_per_step(sc::gauss<2>(), index_2, Vector3d(1, 1, 1),
                                            {.hidden = hidden, .along_algebraic = along}) == 0);
    const equations::index_three index_3{};
    const Eigen::Matrix<double, 5, 1> start = Eigen::Matrix<double, 5, 1>::Ones();
    BOOST_TEST(allocations_per_step(sc::radau_iia<2>(), index_3, start, {.hidden = true}) == 0);
}

BOOST_AUTO_TEST_CASE(nor_does_a_projection_onto_invariants_of_a_state_of_run_time_size) {
    const Eigen::VectorXd start = Eigen::Vector4d(1, 0, 0.25, 0.75);
    const auto per_step = [&](auto g) {
        return allocations_per_step([&](int steps) {
            auto keep = sc::projection_onto<2>(g);
            const auto r =
                sc::integrate(sc::radau_iia<2>(), rotation{}, start, 0, 4, {.fixed_step = 4.0 / steps}, keep);
            if (!r.ok() || keep.corrections() != steps)
                throw std::runtime_error("not every step was corrected");
        });
    };
    BOOST_TEST(per_step(invariants<derivatives::automatic>{}) == 0);
    BOOST_TEST(per_step(invariants<derivatives::own>{}) == 0);
    BOOST_TEST(per_step(invariants<derivatives::differences>{}) == 0);
    const auto wasteful = [](double t, const Eigen::VectorXd& y, Eigen::Vector2d& g) {
        const Eigen::VectorXd copy = y;
        invariants<derivatives::differences>{}(t, copy, g);
    };
    BOOST_TEST(per_step(wasteful) > 0);
}
