// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <vector>

#include <stagecraft/method/order_conditions.hpp>

namespace stagecraft::detail {

/// An orthonormal basis of vectors that are given one by one (Gram and Schmidt). Their first `size` components
/// are the vector; what follows, such as the right-hand sides of an equation, is carried along.
template <class Scalar>
class orthonormal_basis {
  public:
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

    explicit orthonormal_basis(Eigen::Index size) : size_(size) {}

    /// x := its part orthogonal to the first `count` vectors, computed twice to remove rounding errors.
    void project_out(column& x, std::size_t count) const {
        for (int repeat = 0; repeat < 2; ++repeat)
            for (std::size_t k = 0; k < count; ++k)
                x -= vectors_[k].head(size_).dot(x.head(size_)) * vectors_[k];
    }

    /// Reduces x to its part orthogonal to all vectors. Adds that part, with norm 1, and returns true if x does not
    /// follow from them up to rounding errors.
    bool add(column& x) {
        using std::sqrt;
        const Scalar before = sqrt(x.head(size_).dot(x.head(size_)));
        project_out(x, vectors_.size());
        const Scalar size = sqrt(x.head(size_).dot(x.head(size_)));
        if (!(size > condition_tolerance<Scalar>() * before)) return false;
        x /= size;
        vectors_.push_back(x);
        return true;
    }

    std::size_t count() const { return vectors_.size(); }

  private:
    Eigen::Index size_;
    std::vector<column> vectors_;
};

}  // namespace stagecraft::detail
