// SPDX-License-Identifier: BSL-1.0
// says: the observer must be callable as observer(t, y)
// lines: 8
#include <complex>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d, Eigen::Vector3d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run(double& last) {
#ifdef RIGHT
    const auto keep = [&](double, const Vector2d& y) { last = y[1]; };
#else
    const auto keep = [&](double, const Vector3d& y) { last = y[1]; };
#endif
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, keep);
}

#ifdef RIGHT
auto converted(double& last) {
    const auto keep = [&](auto, const Eigen::VectorXd& y, auto...) { last = y[1]; };
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, keep);
}
auto referred(double& last) {
    const auto keep = [&](double, Eigen::Ref<const Eigen::VectorXd> y, double) { last = y[1]; };
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, keep);
}
auto in_a_row(double& last) {
    const auto keep = [&](double, Eigen::RowVector2d y) { last = y[1]; };
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, keep);
}
auto complex(std::complex<double>& last) {
    const auto keep = [&](double, const Eigen::Vector2cd& y) { last = y[1]; };
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, keep);
}
struct both {
    double last = 0;
    void operator()(double, const Vector2d& y) { last = y[1]; }
    void operator()(double, const Vector3d& y) { last = y[2]; }
};
auto overloaded(both& keep) {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, keep);
}
struct shortest final {
    double last = 0;
    void operator()(auto, const auto& y, auto...) { last = y[1]; }
};
auto with_all(shortest& keep) {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, keep);
}
#endif
