// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/result.hpp>

namespace stagecraft {

namespace detail {

/// The largest eigenvalue of B, symmetric with no negative one and not zero: the trace of P B with P the projector on its
/// eigenvectors, to which B^(2^k) over its trace converges.
template <class Square>
typename Square::Scalar largest_eigenvalue(const Square& B) {
    using scalar = typename Square::Scalar;
    Square P = B / B.trace(), next;
    for (int k = 0; k < 60; ++k) {
        next = P.lazyProduct(P);
        next /= next.trace();
        const scalar change = (P - next).cwiseAbs().maxCoeff();
        P = next;
        if (!(change > 4 * std::numeric_limits<scalar>::epsilon())) break;
    }
    return P.cwiseProduct(B).sum();
}

/// Turns the columns of u into orthogonal ones by rotations of two at a time (Jacobi's one-sided method): their lengths are the
/// singular values then.
template <class Matrix>
void make_orthogonal(Matrix& u) {
    using scalar = typename Matrix::Scalar;
    using std::abs;
    using std::sqrt;
    const int n = static_cast<int>(u.cols()), rows = static_cast<int>(u.rows());
    for (int sweep = 0; sweep < 40; ++sweep) {
        bool rotated = false;
        for (int p = 0; p < n; ++p)
            for (int q = p + 1; q < n; ++q) {
                scalar alpha(0), beta(0), gamma(0);
                for (int k = 0; k < rows; ++k)
                    alpha += u(k, p) * u(k, p), beta += u(k, q) * u(k, q), gamma += u(k, p) * u(k, q);
                if (abs(gamma) <= std::numeric_limits<scalar>::epsilon() * sqrt(alpha * beta) ||
                    gamma == scalar(0))
                    continue;
                rotated = true;
                const scalar zeta = (beta - alpha) / (2 * gamma);
                const scalar root = sqrt(1 + zeta * zeta);
                const scalar t = zeta > scalar(0) ? scalar(1 / (zeta + root)) : scalar(1 / (zeta - root));
                const scalar c = 1 / sqrt(1 + t * t), s = c * t;
                for (int k = 0; k < rows; ++k) {
                    const scalar old = u(k, p);
                    u(k, p) = c * old - s * u(k, q);
                    u(k, q) = s * old + c * u(k, q);
                }
            }
        if (!rotated) break;
    }
}

/// The spectral norm of a small matrix A: of 2 x 2 matrices in closed form, else by the largest eigenvalue of A A^T, relative
/// to the largest entry so that squares do not overflow. Any scalar.
template <class Matrix>
typename Matrix::Scalar spectral_norm(const Matrix& a) {
    using scalar = typename Matrix::Scalar;
    using std::sqrt;
    const scalar largest = a.size() == 0 ? scalar(0) : a.cwiseAbs().maxCoeff();
    if (!(largest > scalar(0)) || !(largest - largest == scalar(0))) return largest;
    const Eigen::Matrix<scalar, Matrix::RowsAtCompileTime, Matrix::ColsAtCompileTime> u = a / largest;
    if constexpr (Matrix::RowsAtCompileTime == 2 && Matrix::ColsAtCompileTime == 2) {
        // |z| + |w| of the rotations z and reflections w of which u is the sum
        const scalar p = u(0, 0), q = u(0, 1), r = u(1, 0), t = u(1, 1);
        return largest *
               (sqrt((p + t) * (p + t) + (r - q) * (r - q)) + sqrt((p - t) * (p - t) + (r + q) * (r + q))) /
               2;
    } else {
        return largest * sqrt(largest_eigenvalue(u.lazyProduct(u.transpose()).eval()));
    }
}

/// The same with all singular `values`, by Jacobi's method.
template <class Matrix>
typename Matrix::Scalar spectral_norm(const Matrix& a, std::vector<typename Matrix::Scalar>* values) {
    using scalar = typename Matrix::Scalar;
    using std::sqrt;
    const int n = static_cast<int>(a.cols()), rows = static_cast<int>(a.rows());
    const scalar largest = a.size() == 0 ? scalar(0) : a.cwiseAbs().maxCoeff();
    values->assign(static_cast<std::size_t>(n), scalar(0));
    if (!(largest > scalar(0)) || !(largest - largest == scalar(0))) return largest;
    Eigen::Matrix<scalar, Matrix::RowsAtCompileTime, Matrix::ColsAtCompileTime> u = a / largest;
    make_orthogonal(u);
    scalar best(0);
    for (int j = 0; j < n; ++j) {
        scalar sum(0);
        for (int k = 0; k < rows; ++k) sum += u(k, j) * u(k, j);
        const scalar norm = largest * sqrt(sum);
        (*values)[j] = norm;
        if (norm > best) best = norm;
    }
    return best;
}

/// The first condition whose derivative (a row) depends on those before it; -1 if none does.
template <class Matrix>
int dependent_condition(Matrix rows) {
    using std::sqrt;
    for (Eigen::Index r = 0; r < rows.rows(); ++r) {
        const auto size = sqrt(rows.row(r).squaredNorm());
        for (Eigen::Index k = 0; k < r; ++k) rows.row(r) -= rows.row(r).dot(rows.row(k)) * rows.row(k);
        const auto left = sqrt(rows.row(r).squaredNorm());
        if (!(left > 1000 * std::numeric_limits<typename Matrix::Scalar>::epsilon() * size))
            return static_cast<int>(r);
        rows.row(r) /= left;
    }
    return -1;
}

}  // namespace detail

/// The condition numbers of the problem linearised at x, with the factors that the equations hold: n solves
/// for Phi, and 2 n for every round of the search for sup |G(t, s)|, which takes the column of blocks G(., s)
/// at its largest t, then the row G(t, .) at its largest s, until it no longer grows (Hager's idea).
template <class Equations>
class conditioning_of {
  public:
    using iterate = typename Equations::iterate;
    using scalar = std::decay_t<decltype(iterate{}.t[0])>;
    using wide = typename Equations::wide;
    using column = typename Equations::column;
    static constexpr int N = wide::RowsAtCompileTime,
                         NP = Equations::parameters::RowsAtCompileTime >= 0 && N > 0
                                  ? N + Equations::parameters::RowsAtCompileTime
                                  : Eigen::Dynamic;
    using square = Eigen::Matrix<scalar, N, N>;
    using matrix = Eigen::Matrix<scalar, N, NP>;

    conditioning_of(Equations& equations, const iterate& x) : equations_(equations), x_(x) {}

    bvp_conditioning<scalar> run() {
        fundamental();
        bvp_conditioning<scalar> c;
        const int L = x_.intervals();
        scalar integral(0);
        std::vector<scalar> norms(static_cast<std::size_t>(L + 1));
        for (int i = 0; i <= L; ++i) {
            norms[i] = detail::spectral_norm(phi(i));
            if (norms[i] > c.kappa1) c.kappa1 = norms[i];
            if (i > 0) integral += x_.h(i - 1) * (norms[i - 1] + norms[i]) / 2;
        }
        c.gamma1 = integral / (x_.t.back() - x_.t.front());
        c.sigma = c.gamma1 > scalar(0) ? scalar(c.kappa1 / c.gamma1) : scalar(0);
        search(c, norms);
        return c;
    }

    /// Phi(t_i) = X(t_i) M^-1, n x (n + n_p).
    matrix phi(int i) const {
        const int m = equations_.n() + equations_.np();
        matrix value(equations_.n(), m);
        for (int k = 0; k < m; ++k) value.col(k) = phi_[k].col(i);
        return value;
    }

    /// The answer of y at the mesh points to condition k: column k of Phi.
    const wide& response(int k) const { return phi_[k]; }

    /// P, n_p x (n + n_p): a change d of the conditions moves the parameters by P d.
    const Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>& parameters() const { return parameters_; }

    /// The largest spectral norm of the Phi(t_i) and of P, the conditions being scaled to coefficients of at most 1: their
    /// units are none of the problem's. Matrices of a norm below `least` are passed over.
    scalar norm(const scalar& least) const {
        scalar most(0);
        const column sizes = largest_coefficients();
        const auto look = [&](auto response) {
            for (Eigen::Index k = 0; k < response.cols(); ++k) response.col(k) *= sizes[k];
            if (response.size() == 0 ||
                response.cwiseAbs().maxCoeff() * scalar(static_cast<int>(response.cols())) < least)
                return;
            const scalar size = detail::spectral_norm(response);
            if (!(size <= most)) most = size;
        };
        for (int i = 0; i <= x_.intervals(); ++i) look(phi(i));
        if constexpr (NP != N || N < 0) look(parameters_);
        return most;
    }

    /// The largest entry of |Phi(t)| and |P|, every row relative to threshold + the size of that component of y or p, and the
    /// conditions scaled as in norm().
    scalar relative(const scalar& threshold) const {
        using std::abs;
        scalar kappa(0);
        const column sizes = largest_coefficients();
        for (Eigen::Index j = 0; j < parameters_.rows(); ++j)
            for (Eigen::Index k = 0; k < parameters_.cols(); ++k)
                kappa =
                    std::max(kappa, scalar(sizes[k] * abs(parameters_(j, k)) / (threshold + abs(x_.p[j]))));
        for (int c = 0; c < equations_.n(); ++c) {
            const scalar size = threshold + x_.y.row(c).cwiseAbs().maxCoeff();
            for (Eigen::Index k = 0; k < sizes.size(); ++k)
                kappa = std::max(kappa, scalar(sizes[k] * phi_[k].row(c).cwiseAbs().maxCoeff() / size));
        }
        return kappa;
    }

    /// The effect of one rounding error on y, relative to threshold + |y|, where that is worst (at a mesh point or a
    /// zero of y), and of p: epsilon times the largest terms that a condition can have on this solution, carried on
    /// by Phi and P.
    scalar rounding(const scalar& threshold) const {
        using std::abs;
        const int n = equations_.n(), m = n + equations_.np();
        const auto& B = equations_.conditions();
        const scalar epsilon = std::numeric_limits<scalar>::epsilon();
        const int L = x_.intervals();
        wide error = wide::Zero(n, L + 1);
        column shift = column::Zero(m);  // the first n_p, of the parameters
        typename Equations::state sizes(n);
        for (int c = 0; c < n; ++c) sizes[c] = x_.y.row(c).cwiseAbs().maxCoeff();
        for (int k = 0; k < m; ++k) {
            scalar size(0);
            for (int j = 0; j < 2 * n; ++j) size += abs(B(k, j)) * sizes[j % n];
            for (int j = 0; j < m - n; ++j) size += abs(B(k, 2 * n + j) * x_.p[j]);
            for (int i = 0; i <= L; ++i)
                for (int c = 0; c < n; ++c) error(c, i) += epsilon * size * abs(phi_[k](c, i));
            for (int j = 0; j < m - n; ++j) shift[j] += epsilon * size * abs(parameters_(j, k));
        }
        scalar worst(0);
        for (int i = 0; i <= L; ++i)
            for (int c = 0; c < n; ++c) {
                const scalar here = error(c, i) / (threshold + abs(x_.y(c, i)));
                if (!(here <= worst)) worst = here;
            }
        for (int j = 0; j < m - n; ++j)
            worst = std::max(worst, scalar(shift[j] / (threshold + abs(x_.p[j]))));
        for (int i = 0; i < L; ++i)
            for (int c = 0; c < n; ++c)
                if ((x_.y(c, i) < scalar(0)) != (x_.y(c, i + 1) < scalar(0)))
                    worst = std::max(worst, scalar(std::max(error(c, i), error(c, i + 1)) / threshold));
        return worst;
    }

    /// The largest |y_c| at a mesh point by threshold + the smallest, of the component c where that is most.
    scalar range(const scalar& threshold) const {
        scalar most(0);
        for (int c = 0; c < equations_.n(); ++c) {
            const auto sizes = x_.y.row(c).cwiseAbs();
            most = std::max(most, scalar(sizes.maxCoeff() / (threshold + sizes.minCoeff())));
        }
        return most;
    }

    /// The factors are those of another matrix from now on.
    void forget() { known_ = false; }

    /// Solves for X(t) M^-1 and P, unless they are known.
    void fundamental() {
        if (std::exchange(known_, true)) return;
        const int n = equations_.n(), m = n + equations_.np(), L = x_.intervals();
        typename Equations::parameters p(equations_.np());
        parameters_.resize(equations_.np(), m);
        phi_.resize(static_cast<std::size_t>(m));
        const wide none = wide::Zero(n, L);
        for (int k = 0; k < m; ++k) {
            const column unit = column::Unit(m, k);
            phi_[k].resize(n, L + 1);
            equations_.factors().solve(none, unit, phi_[k], p);
            parameters_.col(k) = p;
            ++solves_;
        }
    }

    /// G(t_i, t_{j+1}) for all i, in columns of n x n blocks: what a unit jump of y at t_{j+1} does, with
    /// the value after the jump at i = j + 1.
    wide green_column(int j) {
        const int n = equations_.n(), L = x_.intervals();
        wide all(n, n * (L + 1)), g = wide::Zero(n, L), y(n, L + 1);
        const column none = column::Zero(n + equations_.np());
        typename Equations::parameters p(equations_.np());
        const auto F = equations_.right_block(j);
        for (int k = 0; k < n; ++k) {
            g.col(j) = F.col(k);
            equations_.factors().solve(g, none, y, p);
            ++solves_;
            for (int i = 0; i <= L; ++i) all.col(i * n + k) = y.col(i);
        }
        return all;
    }

    /// G(t_i, t_{j+1}) for all j, with factors transposed; block j of n x n.
    wide green_row(int i) {
        const int n = equations_.n(), L = x_.intervals();
        wide all(n, n * L), v = wide::Zero(n, L + 1), g(n, L);
        column beta(n + equations_.np());
        const typename Equations::parameters none = Equations::parameters::Zero(equations_.np());
        for (int k = 0; k < n; ++k) {
            v.col(i).setZero();
            v(k, i) = scalar(1);
            equations_.factors().solve_transposed(v, none, g, beta);
            ++solves_;
            for (int j = 0; j < L; ++j)
                all.block(k, j * n, 1, n) = g.col(j).transpose().lazyProduct(equations_.right_block(j));
        }
        return all;
    }

    int solves() const { return solves_; }

  private:
    /// Of every condition; 1 where it has none.
    column largest_coefficients() const {
        column sizes = equations_.conditions().cwiseAbs().rowwise().maxCoeff();
        for (scalar& size : sizes)
            if (!(size > scalar(0))) size = scalar(1);
        return sizes;
    }
    /// The norm of G(t_i, s) at s = t_{j+1}; where that is t_i, the larger of the limits from both sides, which
    /// differ by the identity.
    template <class Block>
    scalar norm_at(int i, int j, const Block& block) const {
        const scalar after = detail::spectral_norm(square(block));
        if (i != j + 1) return after;
        const scalar before =
            detail::spectral_norm(square(block - square::Identity(block.rows(), block.cols())));
        return after > before ? after : before;
    }

    void search(bvp_conditioning<scalar>& c, const std::vector<scalar>& norms) {
        const int n = equations_.n(), L = x_.intervals();
        for (int i = 0; i <= L; ++i) {  // s = a
            const scalar norm =
                detail::spectral_norm(square(phi(i).lazyProduct(equations_.conditions().leftCols(n))));
            if (norm > c.kappa2) c.kappa2 = norm;
        }
        int row = static_cast<int>(std::max_element(norms.begin(), norms.end()) - norms.begin());
        for (int round = 0; round < 4; ++round) {
            const wide row_blocks = green_row(row);
            scalar integral(0), largest(0);
            int at = 0;
            for (int j = 0; j < L; ++j) {
                const scalar norm = norm_at(row, j, row_blocks.middleCols(j * n, n));
                integral += x_.h(j) * norm;
                if (norm > largest) largest = norm, at = j;
            }
            if (norms[row] + integral > c.kappa) c.kappa = norms[row] + integral;
            const bool grew = largest > c.kappa2 * (1 + scalar(1) / 1000);
            if (largest > c.kappa2) c.kappa2 = largest;
            if (!grew || round == 3) break;
            const wide down = green_column(at);
            largest = scalar(0);
            int next = row;
            for (int i = 0; i <= L; ++i) {
                const scalar norm = norm_at(i, at, down.middleCols(i * n, n));
                if (norm > largest) largest = norm, next = i;
            }
            if (largest > c.kappa2) c.kappa2 = largest;
            if (next == row) break;
            row = next;
        }
    }

    Equations& equations_;
    const iterate& x_;
    std::vector<wide> phi_;
    Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic> parameters_;
    int solves_ = 0;
    bool known_ = false;
};

}  // namespace stagecraft
