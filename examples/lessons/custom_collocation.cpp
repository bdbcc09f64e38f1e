// SPDX-License-Identifier: BSL-1.0
// Collocation at nodes of your own (Hairer-Norsett-Wanner I.II.7). The first node moves, the others stay at 2/3 and 1:
// what changes are the order, the stability, and the constant in front of the error; what a run measures is the same
// order again. Edit the nodes. What happens at (4 - sqrt 6)/10 = 0.155..., together with (4 + sqrt 6)/10 = 0.644... and
// 1? (build/stagecraft collocate --nodes takes square roots.)
#include <cmath>
#include <cstdio>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <stagecraft/theory/judging/certify.hpp>

using namespace stagecraft;
using tableaux::rational;

// y' = y^2, y(0) = 1/2 has the solution 1/(2 - t): the error at t = 1 after n equal steps.
double error(const transformed_tableau<double>& method, int n) {
    const auto f = [](double, const auto& y, auto& out) { out[0] = y[0] * y[0]; };
    const auto r = integrate(method, f, Eigen::Matrix<double, 1, 1>(0.5), 0, 1,
                             {.rtol = 1e-12, .atol = 1e-12, .fixed_step = 1.0 / n});
    return std::abs(r.y[0] - 1);
}

int main() {
    std::printf("nodes            order  A-stable  L-stable  |R - e^z|     measured order\n");
    for (const rational& first : std::vector<rational>{{1, 6}, {1, 5}, {1, 3}, {2, 5}, {1, 2}}) {
        const auto w = tableaux::nodal_polynomial::from_nodes({first, rational(2, 3), 1});
        const auto proof = theory::certify(w, tableaux::construction::collocation);
        const auto method = tableaux::transformed<double>(w, tableaux::construction::collocation);
        const double measured = std::log2(error(method, 32) / error(method, 64));
        const auto word = [](const theory::verdict& v) { return v.is_proved() ? "yes" : "no"; };
        std::printf("%-5s 2/3 1        %d      %-8s  %-8s  %-8s z^%d   %.1f\n", first.str().c_str(),
                    proof.order, word(proof.a_stable), word(proof.l_stable),
                    proof.error_constant.str().c_str(), proof.order + 1, measured);
    }
    // The reason for a "no" is a witness that anyone can check.
    const auto w = tableaux::nodal_polynomial::from_nodes({rational(1, 6), rational(2, 3), 1});
    const auto proof = theory::certify(w, tableaux::construction::collocation);
    std::printf("\n1/6 2/3 1 in full:\n%s", proof.text().c_str());
}
