// SPDX-License-Identifier: BSL-1.0
// Counts what a test program takes from the heap, by operator new and by malloc (Eigen's way): the program is
// linked with --wrap for the functions below (tests/CMakeLists.txt) and includes this once.
#pragma once

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations{0};
// The bytes of those that are no smaller than this.
std::atomic<std::size_t> large{~std::size_t{0}}, large_bytes{0};

inline void count_allocation(std::size_t size) {
    ++allocations;
    if (size >= large) large_bytes += size;
}
}  // namespace

extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* p, std::size_t size);
void* __real_aligned_alloc(std::size_t alignment, std::size_t size);
int __real_posix_memalign(void** p, std::size_t alignment, std::size_t size);

void* __wrap_malloc(std::size_t size) {
    count_allocation(size);
    return __real_malloc(size);
}
void* __wrap_calloc(std::size_t count, std::size_t size) {
    count_allocation(count * size);
    return __real_calloc(count, size);
}
void* __wrap_realloc(void* p, std::size_t size) {
    count_allocation(size);
    return __real_realloc(p, size);
}
void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
    count_allocation(size);
    return __real_aligned_alloc(alignment, size);
}
int __wrap_posix_memalign(void** p, std::size_t alignment, std::size_t size) {
    count_allocation(size);
    return __real_posix_memalign(p, alignment, size);
}
}

// GCC 12 pairs the library's allocations with the inlined free below and warns.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif

// The operators come down to the functions above, and so are counted there.
void* operator new(std::size_t size) {
    if (void* p = std::malloc(size)) return p;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto a = static_cast<std::size_t>(alignment);
    if (void* p = std::aligned_alloc(a, (size + a - 1) / a * a)) return p;
    throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
