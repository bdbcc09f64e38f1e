// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE projection_cost_run_time
#include "projection_cost.hpp"

#include <problems/equations.hpp>
#include <type_traits>
#include <utility>
#include <vector>

using Eigen::Vector3d;

namespace {

// The index-2 problem of HLR89 (or, with five components of them, Jay's of index 3) followed by components
// that decay.
template <derivatives Known, int Index>
struct padded_alone {
    static constexpr int core = Index == 2 ? 3 : 5;
    int size;

    template <class S>
    requires(Known == derivatives::automatic || std::is_same_v<S, double>) void operator()(
        const S& t, const Eigen::Matrix<S, Eigen::Dynamic, 1>& x,
        Eigen::Matrix<S, Eigen::Dynamic, 1>& f) const {
        const Eigen::Matrix<S, core, 1> in = x.template head<core>();
        Eigen::Matrix<S, core, 1> out;
        if constexpr (Index == 2)
            equations::index_two{}(t, in, out);
        else
            equations::index_three{}(t, in, out);
        for (int i = 0; i < core; ++i) f[i] = out[i];
        for (int i = core; i < size; ++i) f[i] = -x[i];
    }
    Eigen::DiagonalMatrix<double, Eigen::Dynamic> mass() const {
        Eigen::DiagonalMatrix<double, Eigen::Dynamic> m(size);
        for (int i = 0; i < size; ++i) m.diagonal()[i] = i == core - 1 ? 0 : 1;
        return m;
    }
    std::vector<int> index() const {
        std::vector<int> flags(size, 1);
        if (Index == 3) flags[2] = flags[3] = 2;
        flags[core - 1] = Index;
        return flags;
    }
};
template <derivatives Known, int Index>
struct padded : padded_alone<Known, Index> {};
template <int Index>
struct padded<derivatives::own, Index> : padded_alone<derivatives::own, Index> {
    void jacobian(double, const Eigen::VectorXd& x, Eigen::MatrixXd& J) const {
        J.setZero();
        J.diagonal().setConstant(-1);
        J.topLeftCorner<3, 3>() << x[1] * x[1] * x[2] * x[2], 2 * x[0] * x[1] * x[2] * x[2],
            2 * x[0] * x[1] * x[1] * x[2], 2 * x[0] * x[1] * x[1], 2 * x[0] * x[0] * x[1] - 6 * x[1] * x[2],
            -3 * x[1] * x[1], 2 * x[0] * x[1], x[0] * x[0], 0;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_projection_allocates_nothing_per_step_for_states_of_run_time_size) {
    auto open = sc::semi_explicit(dae::hlr_f{}, dae::hlr_g{}, 2, 1);
    const Eigen::VectorXd start = Vector3d(1, 1, 1), longer = Eigen::VectorXd::Ones(12);
    for (const bool hidden : {false, true})
        for (const bool along : {false, true}) {
            const sc::projection_options o{.hidden = hidden, .along_algebraic = along};
            BOOST_TEST(allocations_per_step(sc::gauss<2>(), open, start, o) == 0);
            const padded<derivatives::own, 2> own{12};
            const padded<derivatives::differences, 2> differences{12};
            BOOST_TEST(allocations_per_step(sc::gauss<2>(), own, longer, o) == 0);
            BOOST_TEST(allocations_per_step(sc::gauss<2>(), differences, longer, o) == 0);
        }
    const padded<derivatives::automatic, 3> index_3{12};
    BOOST_TEST(allocations_per_step(sc::radau_iia<2>(), index_3, longer, {.hidden = true}) == 0);
    // What would be seen above: a problem that is const has no place for the copies of its parts.
    BOOST_TEST(allocations_per_step(sc::gauss<2>(), std::as_const(open), start, {}) > 10);
}
