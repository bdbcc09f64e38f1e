// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>

#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// A Nystrom method for q'' = f(t, q) (Hairer-Norsett-Wanner I.II.14):
///
///     k_i = f(t + c_i h, q + c_i h v + h^2 sum_j A_bar_ij k_j)
///     q1 = q + h v + h^2 sum_i b_bar_i k_i,  v1 = v + h sum_i b_i k_i
///
/// A plain value, as a tableau is; the embedded weights have size 0 where there are none. A_bar is strictly lower triangular.
template <class Scalar, int Stages = dynamic>
struct nystrom_method {
    using scalar = Scalar;
    static constexpr int stages_at_compile_time = Stages;
    using matrix = Eigen::Matrix<Scalar, Stages, Stages>;
    using vector = Eigen::Matrix<Scalar, Stages, 1>;

    vector c;
    matrix A_bar;
    vector b_bar, b;
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> b_bar_embedded, b_embedded;
    int order = 0;  ///< as claimed; 0: not known

    int stages() const { return static_cast<int>(b.size()); }
};

/// The same for q'' = f(t, q, v) as well, whose stages have the velocities v + h sum_j A_ij k_j. Of a method that is read
/// from a file A may be missing (size 0): it serves f(t, q) alone then.
template <class Scalar, int Stages = dynamic>
struct velocity_nystrom_method : nystrom_method<Scalar, Stages> {
    typename nystrom_method<Scalar, Stages>::matrix A;
};

namespace detail {

/// std::invalid_argument where sizes differ, or a stage would need later ones.
template <class Scalar, int Stages, class Velocity>
void check_nystrom(const nystrom_method<Scalar, Stages>& m, const Velocity& A) {
    const int s = m.stages();
    const auto demand = [](bool good, const char* what) {
        if (!good) throw std::invalid_argument(std::string("integrate: Nystrom method: ") + what);
    };
    demand(s > 0 && m.c.size() == s && m.b_bar.size() == s && m.A_bar.rows() == s && m.A_bar.cols() == s,
           "c, A_bar, b_bar and b must have the same number of stages");
    demand(A.size() == 0 || (A.rows() == s && A.cols() == s), "A must have the size of A_bar");
    demand(m.b_embedded.size() == m.b_bar_embedded.size() &&
               (m.b_embedded.size() == 0 || m.b_embedded.size() == s),
           "b_bar_embedded and b_embedded belong together, one weight a stage");
    bool lower = true;
    for (int i = 0; i < s; ++i)
        for (int j = i; j < s; ++j)
            lower = lower && m.A_bar(i, j) == Scalar(0) && (A.size() == 0 || A(i, j) == Scalar(0));
    demand(lower, "A_bar and A must be strictly lower triangular");
}

}  // namespace detail

}  // namespace stagecraft
