// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft {

/// How long a preconditioner made for one matrix shift M - J serves the next ones: until the iterations it has cost beyond
/// those of its first solve are as many as a new one costs, and for shifts within a factor of two of its own.
class preconditioner_life {
  public:
    /// It has been made for a shift, at a cost counted in iterations.
    void made(double shift, double cost) {
        shift_ = shift;
        cost_ = cost;
        usual_ = excess_ = 0;
    }
    /// A solve has taken so many iterations.
    void used(double iterations) {
        if (usual_ == 0) usual_ = iterations;
        if (iterations > usual_) excess_ += iterations - usual_;
    }
    /// A solve with it has failed.
    void failed() { usual_ = 0; }
    /// False before the first solve as well: no preconditioner has been made, or not successfully.
    bool serves(double shift) const {
        return usual_ > 0 && excess_ < cost_ && shift < 2 * shift_ && shift_ < 2 * shift;
    }

  private:
    double shift_ = 0, cost_ = 0, usual_ = 0, excess_ = 0;
};

}  // namespace stagecraft
