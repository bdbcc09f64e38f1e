// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

#include <stagecraft/linear/norms.hpp>

namespace stagecraft {

/// The border of the domain of f, beyond which f is not finite, in a run that has met it. The solution stays inside, but
/// what decays towards the border (a concentration towards zero) is by no method kept from passing it by less than the
/// tolerance: at the stages, where f is needed, and at the end of a step, where it may not be.
///   - Beyond the border, within a tolerance of it, f is continued linearly, by reflection at a point c inside:
///     f(y) := 2 f(c) - f(2 c - y).
///   - An end of a step beyond the border by less than a tolerance moves to such a c. Where f(c) leads out again as
///     far as the end was outside, the solution itself leaves the domain, and the step is refused.
///
/// Nothing is done before watch(), and no storage taken.
template <class Vector>
class domain_border {
  public:
    using scalar = typename Vector::Scalar;

    /// Near which states: where steps begin, with the inverse tolerances; both are kept by reference.
    void lies_near(const Vector& from, const Vector& weights) {
        from_ = &from;
        weights_ = &weights;
    }
    bool watched() const { return watched_; }
    void watch() {
        watched_ = true;
        value_ = *from_;
    }

    /// f, which is f(t, y), made finite if it is not and y lies within a tolerance of the border.
    template <class System>
    [[gnu::noinline, gnu::cold]] void extend(System& system, const scalar& t, const Vector& y, Vector& f) {
        if (all_finite(f, size()) || !find_inside(system, t, y)) return;
        f = 2 * value_;
        inside_ += inside_ - y;
        system.evaluate_inside(t, inside_, value_);
        f -= value_;
    }

    /// Whether a step of h may end at (t1, y1), or at a point inside less than a tolerance away: end() then, with f there.
    template <class System>
    [[gnu::noinline, gnu::cold]] bool admits(System& system, const scalar& t1, const Vector& y1,
                                             const scalar& h) {
        inside_ = value_ = y1;
        system.evaluate_inside(t1, inside_, value_);
        moved_ = !all_finite(value_, size());
        if (!moved_) return true;
        watched_ = true;
        if (!find_inside(system, t1, y1)) return false;
        scalar outwards(0), distance(0);
        for (int i = 0; i < size(); ++i) {
            const scalar way = (y1[i] - inside_[i]) * (*weights_)[i];
            outwards += way * (h * value_[i] * (*weights_)[i]);
            distance += way * way;
        }
        return outwards < distance / 2;
    }
    bool moved() const { return moved_; }
    const Vector& end() const { return inside_; }
    const Vector& value() const { return value_; }

    /// Some component passes zero, as at the border of most domains, by less than a tolerance.
    static bool may_be_passed(const Vector& y, const Vector& y1, const Vector& weights) {
        using std::abs;
        bool any = false;
        for (Eigen::Index i = 0; i < y.size(); ++i)
            any = any ||
                  (y[i] * y1[i] <= scalar(0) && abs(y1[i]) * weights[i] < scalar(1) && !(y[i] == scalar(0)));
        return any;
    }

  private:
    int size() const { return static_cast<int>(from_->size()); }

    /// inside_ := a point at which f is finite, a tolerance from y at most, value_ := f there. Components that have passed
    /// zero go back to a little of what they were, in the second attempt those to zero that began there; in the third
    /// all go a tenth of a tolerance back.
    template <class System>
    [[gnu::noinline, gnu::cold]] bool find_inside(System& system, const scalar& t, const Vector& y) {
        using std::abs;
        for (int attempt = 0; attempt < 3; ++attempt) {
            const Vector back = *from_ - y;
            const scalar far = 10 * weighted_norm(back, *weights_, size());
            inside_ = y;
            for (int i = 0; i < size(); ++i) {
                const scalar& was = (*from_)[i];
                const bool near = abs(y[i]) * (*weights_)[i] < scalar(1);
                const bool passed = was * y[i] <= scalar(0) && (attempt > 0 || !(was == scalar(0)));
                if (attempt == 2)
                    inside_[i] += back[i] / (far < scalar(1) ? scalar(1) : far);
                else if (near && passed)
                    inside_[i] = was / scalar(1 << 30);
            }
            if (inside_ == y) continue;
            system.evaluate_inside(t, inside_, value_);
            if (all_finite(value_, size())) return true;
        }
        return false;
    }

    bool watched_ = false, moved_ = false;
    const Vector *from_ = nullptr, *weights_ = nullptr;
    Vector inside_, value_;
};

/// Of a run on several processes: there is none.
struct no_domain_border {
    template <class Vector>
    static void lies_near(const Vector&, const Vector&) {}
    static constexpr bool watched() { return false; }
    static void watch() {}
};

}  // namespace stagecraft
