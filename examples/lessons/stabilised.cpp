// SPDX-License-Identifier: BSL-1.0
// A heat equation in two dimensions by a stabilised explicit method: no matrix, no linear system, five vectors. The number of
// stages follows the step, so that a grid twice as fine costs twice the evaluations and not four times the steps.
#include <cmath>
#include <cstdio>
#include <stagecraft/stabilised.hpp>

using Eigen::VectorXd;
struct heat {  // u_t = u_xx + u_yy on the unit square, zero at its border; (m - 1)^2 unknowns
    int m;
    void operator()(double, const VectorXd& u, VectorXd& f) const {
        const auto at = [&](int i, int j) {
            return i == 0 || j == 0 || i == m || j == m ? 0.0 : u[(i - 1) + (j - 1) * (m - 1)];
        };
        for (int j = 1; j < m; ++j)
            for (int i = 1; i < m; ++i)
                f[(i - 1) + (j - 1) * (m - 1)] =
                    m * m * (at(i - 1, j) + at(i + 1, j) + at(i, j - 1) + at(i, j + 1) - 4 * at(i, j));
    }
    VectorXd start() const {
        VectorXd u((m - 1) * (m - 1));
        for (int j = 1; j < m; ++j)
            for (int i = 1; i < m; ++i)
                u[(i - 1) + (j - 1) * (m - 1)] = std::sin(M_PI * i / m) * std::sin(M_PI * j / m);
        return u;
    }
};

int main() {
    for (const int m : {32, 64, 128}) {
        const heat f{m};
        const auto r =
            stagecraft::integrate(stagecraft::rkc2(), f, f.start(), 0, 0.1, {.rtol = 1e-4, .atol = 1e-5});
        const double half = std::sin(M_PI / (2 * m)), right = std::exp(-8.0 * m * m * half * half * 0.1);
        const double middle = r.y[(m / 2 - 1) * m];
        std::printf("%6d unknowns: %s, %ld steps, about %ld evaluations a step, error %.0e\n",
                    int(r.y.size()), name(r.status), r.report.steps, r.report.f / r.report.steps,
                    std::abs(middle - right));
    }
}
