// SPDX-License-Identifier: BSL-1.0
// says: include stagecraft/linear/sparse_blocks.hpp
// lines: 8
#include <Eigen/SparseCore>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::VectorXd;

struct sparse {
    void operator()(double, const VectorXd& y, VectorXd& f) const { f = -y; }
    Eigen::SparseMatrix<double> sparsity() const;
};
const sparse problem;

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, VectorXd(9), 0, 1); }
