// SPDX-License-Identifier: BSL-1.0
// Your own linear algebra: a thousand reactions that know nothing of each other have a diagonal Jacobian, and
// the systems (shift M - J) x = b take n divisions. Real and complex shifts both occur.
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>

struct diagonal_block {
    Eigen::VectorXcd d;
    explicit diagonal_block(int n) : d(n) {}
    template <class Mass, class Matrix>  // here M is the identity
    bool factor_shifted(const Mass&, const Matrix& J, double re, double im = 0) {
        for (int i = 0; i < d.size(); ++i) d[i] = std::complex<double>(re, im) - J.coeff(i, i);
        return d.allFinite() && (d.array() != 0.0).all();
    }
    void solve(double* x) { Eigen::Map<Eigen::ArrayXd>(x, d.size()) /= d.real().array(); }
    void solve(double* re, double* im) {
        for (int i = 0; i < d.size(); ++i) {
            const auto z = std::complex<double>(re[i], im[i]) / d[i];
            re[i] = z.real(), im[i] = z.imag();
        }
    }
};
struct reactions {
    static constexpr int n = 1000;
    struct linear_solver {
        using real = diagonal_block;
        using complex = diagonal_block;
    };
    void operator()(double, const Eigen::VectorXd& y, Eigen::VectorXd& f) const {
        for (int i = 0; i < y.size(); ++i) f[i] = -(i + 1) * y[i] * y[i];
    }
    Eigen::SparseMatrix<double> sparsity() const { return Eigen::MatrixXd::Identity(n, n).sparseView(); }
};
int main() {
    const auto r = stagecraft::integrate(stagecraft::radau_iia<3>(), reactions{},
                                         Eigen::VectorXd::Ones(reactions::n), 0, 1);  // y_i = 1/(1 + i t)
    std::printf("%s: y_1 = %.5f, y_n = %.4e\n", name(r.status), r.y[0], r.y[reactions::n - 1]);
}
