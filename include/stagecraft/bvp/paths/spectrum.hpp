// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <vector>

namespace stagecraft::detail {

/// The eigenvalues of A by decreasing real part, how far each may be off where A is known to `relative` of its norm (the norm of
/// its spectral projection times that), and the eigenvectors.
template <class Scalar>
struct known_spectrum {
    using dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using complex = std::complex<Scalar>;
    std::vector<complex> values;
    std::vector<Scalar> errors;
    Eigen::Matrix<complex, Eigen::Dynamic, Eigen::Dynamic> vectors;

    /// Of two eigenvalues whose sum is least beside what they are: a pair that passes the imaginary axis, or real ones that
    /// pass each other's negative.
    struct pair {
        std::size_t first = 0, second = 0;
        complex sum{};
        Scalar error{0};
    };

    known_spectrum() = default;
    known_spectrum(const dense& A, const Scalar& relative) {
        const Eigen::EigenSolver<dense> solver(A, true);
        if (solver.info() != Eigen::Success) return;
        const auto n = static_cast<std::size_t>(A.rows());
        const auto V = solver.eigenvectors();
        const auto W = V.partialPivLu().inverse().eval();
        std::vector<Eigen::Index> order(n);
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) {
            const complex a = solver.eigenvalues()[i], b = solver.eigenvalues()[j];
            return a.real() > b.real() || (a.real() == b.real() && a.imag() > b.imag());
        });
        vectors.resize(A.rows(), A.rows());
        for (std::size_t k = 0; k < n; ++k) {
            const Eigen::Index i = order[k];
            values.push_back(solver.eigenvalues()[i]);
            errors.push_back(relative * A.norm() * W.row(i).norm() * V.col(i).norm());
            vectors.col(static_cast<Eigen::Index>(k)) = V.col(i);
        }
    }
    /// The product of the sums of all pairs, each divided by the moduli: it changes its sign where a complex pair passes the
    /// imaginary axis (the determinant of the bialternate product, Kuznetsov 2004, section 10.2).
    Scalar pair_test() const {
        complex product(1);
        for_pairs([&](std::size_t i, std::size_t j) {
            const Scalar size = std::abs(values[i]) + std::abs(values[j]);
            if (size > Scalar(0)) product *= (values[i] + values[j]) / size;
        });
        return product.real();
    }
    pair least_pair() const {
        pair found;
        Scalar least = std::numeric_limits<Scalar>::infinity();
        for_pairs([&](std::size_t i, std::size_t j) {
            const complex sum = values[i] + values[j];
            const Scalar part = std::abs(sum) / (std::abs(values[i]) + std::abs(values[j]));
            if (part < least) least = part, found = {i, j, sum, errors[i] + errors[j]};
        });
        return found;
    }
    /// Is every sum of a pair known better than to its distance from zero?
    bool decides_pairs() const {
        bool known = true;
        for_pairs([&](std::size_t i, std::size_t j) {
            known &= std::abs(values[i] + values[j]) > 2 * (errors[i] + errors[j]);
        });
        return known;
    }
    int unstable() const {
        return static_cast<int>(std::count_if(values.begin(), values.end(),
                                              [](const complex& v) { return v.real() > Scalar(0); }));
    }

  private:
    template <class Act>
    void for_pairs(const Act& act) const {
        for (std::size_t j = 0; j < values.size(); ++j)
            for (std::size_t i = 0; i < j; ++i) act(i, j);
    }
};

}  // namespace stagecraft::detail
