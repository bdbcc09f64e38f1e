// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <stagecraft/method/order_conditions.hpp>
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

/// The largest order up to `most` of weights b_bar, b (of q, of v) on the stages of a Nystrom method: every N-tree is
/// looked at (Hairer-Norsett-Wanner I.II.14). `A` of size 0: of f(t, q). The condition of a tree is that
/// the stages integrate a monomial kappa theta^d, d its degree, exactly: once for v, twice for q. Cost: s^2 a tree.
template <class Scalar>
class nystrom_trees {
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    using square = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    struct tree {
        column stages;
        Scalar kappa;
    };

  public:
    nystrom_trees(const column& c, const square& A_bar, const square& A, int most) {
        const Eigen::Index s = c.size();
        trees_.push_back({{column::Ones(s), Scalar(1)}});
        branches_.emplace_back();
        for (int d = 1; d < most; ++d) {
            branches_.emplace_back();
            auto& now = branches_.back();
            if (d == 1) now.push_back({c, Scalar(1)});
            if (A.size() > 0)
                for (const tree& t : trees_[d - 1]) now.push_back({A * t.stages, t.kappa / Scalar(d)});
            if (d > 1)
                for (const tree& t : trees_[d - 2])
                    now.push_back({A_bar * t.stages, t.kappa / Scalar(d * (d - 1))});
            trees_.emplace_back();
            grow({column::Ones(s), Scalar(1)}, d, d, now.size());
        }
    }

    int order(const column& b_bar, const column& b) const {
        int p = 0;
        for (; p < static_cast<int>(trees_.size()); ++p) {
            for (const tree& t : trees_[p])
                if (!detail::holds<Scalar>(b.dot(t.stages), t.kappa / Scalar(p + 1))) return p;
            if (p > 0)
                for (const tree& t : trees_[p - 1])
                    if (!detail::holds<Scalar>(b_bar.dot(t.stages), t.kappa / Scalar(p * (p + 1)))) return p;
        }
        return p;
    }

  private:
    /// All products of `from` and branches of together `left` degrees, none after branch `last` of degree `degree`.
    void grow(const tree& from, int left, int degree, std::size_t last) {
        if (left == 0) {
            trees_.back().push_back(from);
            return;
        }
        for (int d = std::min(degree, left); d > 0; --d) {
            const std::size_t end = d == degree ? std::min(last, branches_[d].size()) : branches_[d].size();
            for (std::size_t k = 0; k < end; ++k)
                grow({from.stages.cwiseProduct(branches_[d][k].stages), from.kappa * branches_[d][k].kappa},
                     left - d, d, k + 1);
        }
    }
    std::vector<std::vector<tree>> trees_, branches_;  // by degree
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
