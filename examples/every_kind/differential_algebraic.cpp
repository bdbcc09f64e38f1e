// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <problems/stiff.hpp>
#include <problems/stored.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/radau_iia_variable.hpp>

#include "print_run.hpp"

namespace sc = stagecraft;
using Eigen::VectorXd;

namespace {

/// The pendulum on the unit circle, its constraint as it is (index 3) or differentiated once.
template <int Index>
struct pendulum {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 5, 1>& q, Eigen::Matrix<S, 5, 1>& f) const {
        f[0] = q[2], f[1] = q[3];
        f[2] = -q[0] * q[4], f[3] = -q[1] * q[4] - 1.0;
        f[4] = Index == 3 ? S(q[0] * q[0] + q[1] * q[1] - 1.0) : S(q[0] * q[2] + q[1] * q[3]);
    }
    Eigen::DiagonalMatrix<double, 5> mass() const {
        Eigen::DiagonalMatrix<double, 5> m;
        m.diagonal() << 1, 1, 1, 1, 0;
        return m;
    }
    std::array<int, 5> index() const {
        return Index == 3 ? std::array{1, 1, 2, 2, 3} : std::array{1, 1, 1, 1, 2};
    }
};

}  // namespace

void differential_algebraic() {
    print_run("DAE of index 1", "transistor amplifier", "Radau IIA variable", sc::radau_iia_variable(),
              problems::transistor_amplifier{}, problems::transistor_amplifier::initial(), 0.2,
              problems::reference("transamp"));
    // From beside the pivot to the bottom it takes K(sin 45 deg).
    const double quarter = std::comp_ellint_1(std::sqrt(0.5));
    Eigen::Matrix<double, 5, 1> start;
    start << 1, 0, 0, 0, 0;
    const VectorXd bottom = Eigen::Vector4d(0, -1, -std::sqrt(2.0), 0);
    print_run("DAE of index 2", "pendulum", "Radau IIA s = 3", sc::radau_iia<3>(), pendulum<2>{}, start,
              quarter, bottom);
    print_run("DAE of index 3", "pendulum", "Radau IIA s = 3", sc::radau_iia<3>(), pendulum<3>{}, start,
              quarter, bottom);
}
