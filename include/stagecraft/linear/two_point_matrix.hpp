// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include <stagecraft/linear/almost_block_diagonal.hpp>
#include <stagecraft/linear/cyclic_blocks.hpp>

namespace stagecraft {

/// The matrix of a linear two-point problem on L intervals,
///
///     E_i y_i + F_i y_{i+1} + P_i p = g_i,   i = 0 ... L - 1,       B_0 y_0 + B_L y_L + B_p p = beta,
///
/// n unknowns y_i at each of L + 1 points, n_p parameters, n + n_p conditions. Conditions that are separated
/// (each with zeros at one end, no parameters) are eliminated by rows, all others orthogonally.
template <class Scalar, int N>
class two_point_matrix {
  public:
    using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

    /// Takes the conditions, (n + n_p) x (2 n + n_p) with columns y_0, y_L, p, and room for the intervals.
    void start(int n, int intervals, const matrix& conditions) {
        n_ = n, intervals_ = intervals;
        parameters_ = static_cast<int>(conditions.cols()) - 2 * n;
        left_.clear(), right_.clear();
        separated_ = parameters_ == 0;
        for (int r = 0; r < n && separated_; ++r) {
            const bool at_left = !is_zero(conditions, r, 0), at_right = !is_zero(conditions, r, n);
            if (at_left && at_right) separated_ = false;
            (at_left ? left_ : right_).push_back(r);
        }
        if (separated_) {
            const int k = static_cast<int>(left_.size());
            rows_.resize(n, intervals, k, 0);
            auto head = rows_.head_rows();
            for (int r = 0; r < k; ++r) head.row(r) = conditions.row(left_[r]).head(n);
            auto last = rows_.last_rows();
            for (int r = 0; r < n - k; ++r) last.row(r) = conditions.row(right_[r]).segment(n, n);
        } else {
            const int q = n + parameters_;
            cyclic_.resize(n, intervals - 1, n, q);
            auto last = cyclic_.last_rows();
            last.leftCols(n) = conditions.middleCols(n, n);
            last.middleCols(n, n) = conditions.leftCols(n);
            last.rightCols(parameters_) = conditions.rightCols(parameters_);
        }
    }

    bool separated() const { return separated_; }

    /// E_i, F_i, P_i as one n x (2 n + n_p) matrix.
    template <class Block>
    void set(int i, const Block& block) {
        if (separated_) {
            rows_.link_rows(i) = block;
        } else if (i > 0) {
            auto link = cyclic_.link_rows(i - 1);
            link.leftCols(2 * n_) = block.leftCols(2 * n_);
            link.middleCols(2 * n_, n_).setZero();
            link.rightCols(parameters_) = block.rightCols(parameters_);
        } else {
            auto head = cyclic_.head_rows();
            head.leftCols(n_) = block.middleCols(n_, n_);
            head.middleCols(n_, n_) = block.leftCols(n_);
            head.rightCols(parameters_) = block.rightCols(parameters_);
        }
    }

    /// The number of pivots that were zero and replaced by rounding errors.
    int factor() { return separated_ ? rows_.factor() : cyclic_.factor(); }

    /// g is n x L, beta n + n_p; y becomes n x (L + 1), p n_p.
    template <class G, class Beta, class Y, class P>
    void solve(const G& g, const Beta& beta, Y& y, P& p) {
        if (separated_) {
            gather(beta);
            rows_.solve(head_, g, last_, y, p);
        } else {
            border_.resize(n_ + parameters_);
            auto rest = y.rightCols(intervals_);
            cyclic_.solve(g.col(0), g.rightCols(intervals_ - 1), beta, rest, border_);
            y.col(0) = border_.head(n_);
            for (int k = 0; k < parameters_; ++k) p[k] = border_[n_ + k];
        }
    }

    /// The transposed system: weights of y (n x (L + 1)) and p in, weights of the equations g and beta out.
    template <class Y, class P, class G, class Beta>
    void solve_transposed(const Y& y, const P& p, G& g, Beta& beta) {
        if (separated_) {
            head_.resize(left_.size());
            last_.resize(right_.size());
            rows_.solve_transposed(y, p, head_, g, last_);
            for (std::size_t r = 0; r < left_.size(); ++r) beta[left_[r]] = head_[r];
            for (std::size_t r = 0; r < right_.size(); ++r) beta[right_[r]] = last_[r];
        } else {
            border_.resize(n_ + parameters_);
            border_.head(n_) = y.col(0);
            for (int k = 0; k < parameters_; ++k) border_[n_ + k] = p[k];
            head_.resize(n_);
            auto rest = g.rightCols(intervals_ - 1);
            cyclic_.solve_transposed(y.rightCols(intervals_), border_, head_, rest, beta);
            g.col(0) = head_;
        }
    }

  private:
    bool is_zero(const matrix& m, int row, int first) const {
        for (int j = 0; j < n_; ++j)
            if (!(m(row, first + j) == Scalar(0))) return false;
        return true;
    }
    template <class Beta>
    void gather(const Beta& beta) {
        head_.resize(left_.size());
        last_.resize(right_.size());
        for (std::size_t r = 0; r < left_.size(); ++r) head_[r] = beta[left_[r]];
        for (std::size_t r = 0; r < right_.size(); ++r) last_[r] = beta[right_[r]];
    }

    int n_ = 0, intervals_ = 0, parameters_ = 0;
    bool separated_ = true;
    std::vector<int> left_, right_;
    almost_block_diagonal<Scalar, N> rows_;
    cyclic_blocks<Scalar, N> cyclic_;
    vector head_, last_, border_;
};

}  // namespace stagecraft
