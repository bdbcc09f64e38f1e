// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <stagecraft/linear/packet.hpp>

namespace stagecraft {

/// A rectangular matrix that vectors are multiplied by, without its zeros where most of its entries are zero: springs
/// between neighbours, say.
template <class Scalar>
class coupling {
    using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  public:
    coupling(int rows, int columns)
        : rows_(rows),
          columns_(columns),
          start_(static_cast<std::size_t>(columns) + 1),
          row_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns)),
          value_(row_.size()) {}

    /// Becomes the block of so many rows and columns at `from`, kept by columns `stride` numbers apart.
    void take(const Scalar* from, int stride) {
        int entries = 0;
        for (int j = 0; j < columns_; ++j, from += stride) {
            start_[j] = entries;
            for_nonzeros(from, [&](int i) {
                row_[entries] = i;
                value_[entries++] = from[i];
            });
        }
        start_[columns_] = entries;
    }
    /// f(i, j, value) for the entries that are not zero.
    template <class F>
    void each(F&& f) const {
        for (int j = 0; j < columns_; ++j)
            for (int t = start_[j]; t < start_[j + 1]; ++t) f(row_[t], j, value_[t]);
    }
    /// r += C q.
    void add_product(const Scalar* q, Scalar* r) const {
        if (start_[columns_] == rows_ * columns_) {  // no zeros: values_ is the matrix
            Eigen::Map<vector>(r, rows_).noalias() +=
                Eigen::Map<const matrix>(value_.data(), rows_, columns_) *
                Eigen::Map<const vector>(q, columns_);
            return;
        }
        each([&](int i, int j, const Scalar& v) { r[i] += v * q[j]; });
    }

  private:
    template <class F>
    void for_nonzeros(const Scalar* x, F&& f) const {
        using pack = std::conditional_t<built_in<Scalar>, packet<Scalar>, single<Scalar>>;
        int i = 0;
        for (; i + 2 * pack::size <= rows_; i += 2 * pack::size) {
            const typename pack::type zeros =
                pack::one_if_zero(pack::load(x + i)) * pack::one_if_zero(pack::load(x + i + pack::size));
            if (pack::sum(zeros) == Scalar(pack::size)) continue;
            for (int k = i; k < i + 2 * pack::size; ++k)
                if (!(x[k] == Scalar(0))) f(k);
        }
        for (; i < rows_; ++i)
            if (!(x[i] == Scalar(0))) f(i);
    }

    int rows_, columns_;
    std::vector<int> start_, row_;
    std::vector<Scalar> value_;
};

}  // namespace stagecraft
