// SPDX-License-Identifier: BSL-1.0
// Eight point masses on rigid links, 1 m and 1 kg in all, hung at the origin and let go horizontally.
#include "body.hpp"

namespace mechanics {

namespace {

struct links {
    static constexpr int count = 8, coordinates = 2 * count, constraints = count;
    static constexpr double length = 1.0 / count, mass = 1.0 / count, gravity = 9.81;
    template <class S>
    using vector = Eigen::Matrix<S, coordinates, 1>;

    template <class S>
    Eigen::Matrix<S, coordinates, coordinates> M(const vector<S>&) const {
        return vector<S>::Constant(S(mass)).asDiagonal();
    }
    template <class S>
    vector<S> solve_mass(const vector<S>&, const vector<S>& r) const {
        return r / S(mass);
    }
    template <class S>
    vector<S> F(const vector<S>&, const vector<S>&) const {
        vector<S> F;
        for (int k = 0; k < count; ++k) F[2 * k] = S(0), F[2 * k + 1] = S(-mass * gravity);
        return F;
    }
    template <class S>
    Eigen::Matrix<S, count, 1> g(const vector<S>& q) const {
        Eigen::Matrix<S, count, 1> g;
        for (int k = 0; k < count; ++k) {
            const S x = link(q, k, 0), y = link(q, k, 1);
            g[k] = (x * x + y * y - S(length) * S(length)) / S(2);
        }
        return g;
    }
    template <class S>
    Eigen::Matrix<S, count, coordinates> G(const vector<S>& q) const {
        Eigen::Matrix<S, count, coordinates> G = Eigen::Matrix<S, count, coordinates>::Constant(S(0));
        for (int k = 0; k < count; ++k)
            for (int i = 0; i < 2; ++i) {
                G(k, 2 * k + i) = link(q, k, i);
                if (k > 0) G(k, 2 * k - 2 + i) = -link(q, k, i);
            }
        return G;
    }
    template <class S>
    S potential(const vector<S>& q) const {
        S height(0);
        for (int k = 0; k < count; ++k) height += q[2 * k + 1];
        return S(mass * gravity) * height;
    }

  private:
    template <class S>
    static S link(const vector<S>& q, int k, int i) {
        return k == 0 ? q[i] : S(q[2 * k + i] - q[2 * k - 2 + i]);
    }
};

}  // namespace

body chain() {
    VectorXd q = VectorXd::Zero(links::coordinates);
    for (int k = 0; k < links::count; ++k) q[2 * k] = (k + 1) * links::length;
    return describe("chain", links(), links(), q, VectorXd::Zero(links::coordinates), 0.5);
}

}  // namespace mechanics
