// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/judge/evidence.hpp>

/// An attempt at a step as a judge sees it, all numbers given: what a run would have to measure, a test says. `asked`
/// counts the questions that cost something.
struct attempt : stagecraft::step_facts<double> {
    double left = 0, again = 0, right = 0;  ///< the estimates, before ratio
    double raised = 0;                      ///< the part of them in components of index 2 and 3
    double across = 1;                      ///< ratio across a jump
    double between = 0, output = 0, sign = 0;
    int spots = 0, spot_power = 3;
    bool watched = false;  ///< an observer looks between the ends, and M is singular
    double watched_output = 0, watched_between = 0;
    bool constant_slope = false, identity = true, from_start = false;
    double rounding = 0, longest_step = 1;
    long at_rounding = 0;
    int asked = 0;

    double measured = 0;
    double sized(double x) const { return (x < share * raised ? share * raised : x) * ratio; }
    double estimate() { return sized(measured = left); }
    double estimate_again() {
        once = sized(left);
        ++asked;
        return sized(measured = again);
    }
    double estimate_right() const { return right * ratio; }
    double size() const { return sized(measured); }
    double size_with_share_one() const { return (measured > raised ? measured : raised) * ratio; }
    static double further() { return 0; }

    static bool may_have_index() { return true; }
    bool estimates_from_start() const { return from_start; }
    bool has_identity_mass() const { return identity; }
    double ratio_across_jump() const { return across; }
    bool has_constant_slope() const { return constant_slope; }
    int blind_spots() const { return spots; }
    int power_at_blind_spots() const { return spot_power; }
    bool knows_slopes() const { return true; }
    double sign_at_blind_spots(double) {
        ++asked;
        return sign;
    }
    static bool knows_output_error() { return true; }
    double output_error() {
        ++asked;
        return output;
    }
    bool is_watched_between() const { return watched; }
    double watched_output_error() {
        ++asked;
        return watched_output;
    }
    double watched_error_between(bool all) {
        ++asked;
        return all ? between : watched_between;
    }
    double rounding_of_estimate() {
        ++asked;
        return rounding;
    }
    double longest() const { return longest_step; }
    void count_at_rounding() { ++at_rounding; }
    double error_between_nodes() {
        ++asked;
        return between;
    }
};
