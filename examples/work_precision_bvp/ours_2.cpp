// SPDX-License-Identifier: BSL-1.0
#include "ours.hpp"

bvp::solver bvp::ours_2(const problem& p) { return with_gauss<2, second_order_right_hand_side>(p); }
