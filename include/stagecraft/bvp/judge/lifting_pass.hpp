// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft::detail {

/// Is the collocation polynomial of a component lifted once more? `inner` is the local error left between the mesh points,
/// `local` the largest one at the mesh point, `size` that of y and the threshold. It is where `inner` counts beside the
/// tolerance and beside `local`: interpolated Jacobians have left it.
template <class Scalar>
bool lifts_again(const Scalar& inner, const Scalar& local, const Scalar& size, const Scalar& negligible) {
    constexpr int small_beside_local = 20;
    return inner > negligible * size && small_beside_local * inner > local;
}

}  // namespace stagecraft::detail
