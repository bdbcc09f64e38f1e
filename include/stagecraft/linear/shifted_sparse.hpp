// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <vector>

#include <stagecraft/linear/mass.hpp>

namespace stagecraft {

/// The sparse matrix shift M - J, kept from one shift and one J to the next: the union of both patterns is
/// found once, afterwards values are written to places found then and nothing is allocated. T is the type of
/// the shift, real or complex.
template <class T>
class shifted_sparse {
  public:
    /// Writes shift M - J if M and J have the kept pattern. False if not, that is if an entry is missing, is
    /// new or stands elsewhere (each is compared with its place while it is written); the values are then
    /// unspecified.
    template <class Mass, class Scalar>
    bool fill(const Mass& mass, const Eigen::SparseMatrix<Scalar>& J, const T& shift) {
        if (matrix_.rows() != J.rows()) return false;
        std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), T(0));
        std::size_t k = 0;
        bool fits = true;
        const auto add = [&](int i, int j, const T& value) {
            fits = fits && k < places_.size() && holds(places_[k], i, j);
            if (fits) matrix_.valuePtr()[places_[k++]] += value;
        };
        visit(
            mass, J, [&](int i, int j, const Scalar& m) { add(i, j, shift * m); },
            [&](int i, int j, const Scalar& d) { add(i, j, T(-d)); });
        return fits && k == places_.size();
    }

    /// Takes the pattern of M and J, explicit zeros included.
    template <class Mass, class Scalar>
    void adopt(const Mass& mass, const Eigen::SparseMatrix<Scalar>& J) {
        std::vector<Eigen::Triplet<T>> entries;
        const auto note = [&](int i, int j, const Scalar&) { entries.emplace_back(i, j); };
        visit(mass, J, note, note);
        matrix_.resize(J.rows(), J.cols());
        matrix_.setFromTriplets(entries.begin(), entries.end());
        places_.clear();
        for (const auto& e : entries) {
            const int* rows = matrix_.innerIndexPtr();
            const int* outer = matrix_.outerIndexPtr();
            const auto at = std::lower_bound(rows + outer[e.col()], rows + outer[e.col() + 1], e.row());
            places_.push_back(static_cast<int>(at - rows));
        }
    }

    bool finite() const {
        const T* values = matrix_.valuePtr();
        return std::all_of(values, values + matrix_.nonZeros(), [](const T& v) { return v - v == T(0); });
    }
    const Eigen::SparseMatrix<T>& matrix() const { return matrix_; }  ///< compressed

  private:
    bool holds(int place, int i, int j) const {
        return matrix_.innerIndexPtr()[place] == i && matrix_.outerIndexPtr()[j] <= place &&
               place < matrix_.outerIndexPtr()[j + 1];
    }
    /// The entries of M and of J, in the order in which places are kept.
    template <class Mass, class Scalar, class OfMass, class OfJacobian>
    static void visit(const Mass& mass, const Eigen::SparseMatrix<Scalar>& J, const OfMass& of_mass,
                      const OfJacobian& of_jacobian) {
        const int n = static_cast<int>(J.rows());
        if constexpr (Mass::identity) {
            for (int i = 0; i < n; ++i) of_mass(i, i, Scalar(1));
        } else {
            for (const auto& e : mass.entries()) of_mass(e.row, e.column, e.value);
        }
        for (int j = 0; j < n; ++j)
            for (typename Eigen::SparseMatrix<Scalar>::InnerIterator it(J, j); it; ++it)
                of_jacobian(static_cast<int>(it.row()), j, it.value());
    }

    Eigen::SparseMatrix<T> matrix_;
    std::vector<int> places_;  // of the entries of M, then of J, among the values
};

}  // namespace stagecraft
