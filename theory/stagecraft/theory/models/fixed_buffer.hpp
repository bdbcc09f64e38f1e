// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <utility>

namespace stagecraft::theory {

/// A block of K whose length is chosen once, its entries K(). What std::vector would do, at a third of the
/// constant-evaluation steps per entry: compile-time proofs spend a good part of their time in storage.
template <class K>
class fixed_buffer {
  public:
    constexpr fixed_buffer() = default;
    constexpr explicit fixed_buffer(int size) : size_(size), entries_(new K[static_cast<unsigned>(size)]()) {}
    constexpr fixed_buffer(const fixed_buffer& o) : fixed_buffer(o.size_) {
        for (int i = 0; i < size_; ++i) entries_[i] = o.entries_[i];
    }
    constexpr fixed_buffer(fixed_buffer&& o) noexcept { swap(o); }
    constexpr fixed_buffer& operator=(fixed_buffer o) noexcept {
        swap(o);
        return *this;
    }
    constexpr ~fixed_buffer() { delete[] entries_; }

    constexpr K* data() { return entries_; }
    constexpr const K* data() const { return entries_; }
    constexpr int size() const { return size_; }

  private:
    constexpr void swap(fixed_buffer& o) noexcept {
        std::swap(size_, o.size_);
        std::swap(entries_, o.entries_);
    }

    int size_ = 0;
    K* entries_ = nullptr;
};

}  // namespace stagecraft::theory
