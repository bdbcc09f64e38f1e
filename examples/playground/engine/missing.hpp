// SPDX-License-Identifier: BSL-1.0
#pragma once

// What the standard library of emscripten 3.1.6 (libc++ 14) lacks of C++20 and the steppers use. Included before all else.
#include <bit>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace std {

#ifndef __cpp_lib_bit_cast
template <class To, class From>
requires(sizeof(To) == sizeof(From)) constexpr To bit_cast(const From& x) noexcept {
    return __builtin_bit_cast(To, x);
}
#endif

#ifndef __cpp_lib_smart_ptr_for_overwrite
template <class Array>
unique_ptr<Array> make_unique_for_overwrite(size_t n) {
    return unique_ptr<Array>(new remove_extent_t<Array>[n]);
}
#endif

}  // namespace std
