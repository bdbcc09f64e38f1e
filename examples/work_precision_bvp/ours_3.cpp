// SPDX-License-Identifier: BSL-1.0
#include "ours.hpp"

namespace {
struct first_order : bvp::right_hand_side<3> {};
}  // namespace

bvp::solver bvp::ours_3(const problem& p) { return with_gauss<3, first_order>(p); }
