// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <stagecraft/owned_value.hpp>

namespace stagecraft {

namespace detail {

/// Threads that are waited for, whatever happens. (std::jthread is missing from libc++ before 18.)
struct joined_threads {
    std::vector<std::thread> list;
    ~joined_threads() {
        for (auto& t : list) t.join();
    }
};

}  // namespace detail

/// run(0), ..., run(count - 1) in threads, which take the next number as soon as they are free; the results in order:
///
///     const auto ends = ensemble(1000, [&](int k) {
///         return integrate(method, reaction{rates[k]}, y0, t0, t1, options);       // then ends[k].y
///     });
///
/// `threads` of them, one of which is the caller's; 0: as many as there are cores. What run() shares between its calls it
/// must only read. The first exception by number among those thrown is thrown again, when the runs under way have ended;
/// no others are begun then. std::invalid_argument for a negative count or number of threads.
template <class Run>
auto ensemble(int count, Run&& run, int threads = 0) -> std::vector<decltype(run(0))> {
    static_assert(
        detail::owns_numbers<decltype(run(0))>,
        "ensemble: run(k) returns an expression of Eigen's, whose operands may be gone: write its type, "
        "`-> Eigen::Vector2d`, say, or `return (A * y).eval();`");
    if (count < 0) throw std::invalid_argument("ensemble: count must not be negative");
    if (threads < 0) throw std::invalid_argument("ensemble: threads must not be negative");
    if (threads == 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const auto size = static_cast<std::size_t>(count);
    std::vector<std::optional<decltype(run(0))>> found(size);
    std::vector<std::exception_ptr> thrown(size);
    std::atomic<int> next{0};
    std::atomic<bool> failed{false};
    const auto work = [&] {
        while (!failed) {
            const int k = next++;
            if (k >= count) return;
            try {
                found[static_cast<std::size_t>(k)].emplace(run(k));
            } catch (...) {
                thrown[static_cast<std::size_t>(k)] = std::current_exception();
                failed = true;
            }
        }
    };
    {
        detail::joined_threads others;
        for (int k = 1; k < std::min(threads, count); ++k) others.list.emplace_back(work);
        work();
    }
    for (const auto& t : thrown)
        if (t) std::rethrow_exception(t);
    std::vector<decltype(run(0))> results;
    results.reserve(size);
    for (auto& r : found) results.push_back(std::move(*r));
    return results;
}

}  // namespace stagecraft
