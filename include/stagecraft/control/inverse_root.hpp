// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace stagecraft {

/// x^(-1/q) for x > 0, which every accepted step asks for, and the next one waits for.
template <class Scalar>
struct inverse_root {
    Scalar operator()(const Scalar& x, int q) {
        using std::pow;
        return pow(x, Scalar(-1) / Scalar(q));
    }
};

/// To four digits and more, of which a step size needs one or two, in a third of the time of pow: with x = 1.5 m 2^-k
/// it is (1.5 2^-k)^(-1/q), of a table, times m^(-1/q), of whose binomial series in m - 1, at most 1/3 in size, seven
/// powers are taken.
template <>
class inverse_root<double> {
  public:
    double operator()(double x, int q) {
        if (q != q_) prepare(q);
        const auto bits = std::bit_cast<std::uint64_t>(x), one = std::bit_cast<std::uint64_t>(1.0);
        const std::uint64_t k = (one >> 52) - (bits >> 52);
        if (k >= powers_.size()) return std::pow(x, -1.0 / q);  // x >= 2 among them
        const double y = std::bit_cast<double>((bits & fraction) | one) * (1 / 1.5) - 1, y2 = y * y;
        const double low = (c_[0] + c_[1] * y) + y2 * (c_[2] + c_[3] * y),
                     high = (c_[4] + c_[5] * y) + y2 * (c_[6] + c_[7] * y);
        return powers_[k] * (low + y2 * y2 * high);
    }

  private:
    void prepare(int q) {
        q_ = q;
        powers_[0] = std::pow(1.5, -1.0 / q);
        const double two = std::pow(2.0, 1.0 / q);
        for (std::size_t k = 1; k < powers_.size(); ++k) powers_[k] = powers_[k - 1] * two;
        c_[0] = 1;
        for (std::size_t j = 1; j < c_.size(); ++j) c_[j] = c_[j - 1] * (1 - 1.0 / q - j) / j;
    }
    static constexpr std::uint64_t fraction = (std::uint64_t(1) << 52) - 1;
    int q_ = 0;
    std::array<double, 28> powers_{};  // down to 1e-8
    std::array<double, 8> c_{};
};

}  // namespace stagecraft
