// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft {

/// A rooted tree (Butcher 1963; Hairer-Norsett-Wanner I.II.2), unlabelled and unordered, as a value: its
/// level sequence in preorder, the root at level 1, in canonical form, that is the lexicographically largest
/// of all orderings of siblings (Beyer and Hedetniemi 1980). Equal trees compare equal.
class rooted_tree {
  public:
    /// Largest number of vertices. 20! is the largest factorial below 2^63, so densities, symmetries and
    /// numbers of labelings of every tree that can be represented are exact 64-bit integers.
    static constexpr int max_order = 20;

    /// The tree with one vertex, tau.
    constexpr rooted_tree() : size_(1) { levels_[0] = 1; }

    /// The tree with this level sequence, siblings in any order. Throws std::invalid_argument where the
    /// sequence does not begin with the only 1, jumps by more than one level, or is too long.
    explicit constexpr rooted_tree(std::span<const int> levels) : size_(static_cast<int>(levels.size())) {
        if (levels.empty() || levels.size() > static_cast<std::size_t>(max_order))
            throw std::invalid_argument("levels: a rooted tree here has 1 to 20 vertices");
        for (std::size_t i = 0; i < levels.size(); ++i) {
            if (i == 0 ? levels[0] != 1 : levels[i] < 2 || levels[i] > levels[i - 1] + 1)
                throw std::invalid_argument(
                    "levels: a level sequence begins with its only 1 and rises by at most one");
            levels_[i] = static_cast<std::uint8_t>(levels[i]);
        }
        canonicalise(0, size_);
    }
    constexpr rooted_tree(std::initializer_list<int> levels)
        : rooted_tree(std::span<const int>(levels.begin(), levels.size())) {}

    /// The canonical level sequence.
    constexpr std::span<const std::uint8_t> levels() const {
        return {levels_.data(), static_cast<std::size_t>(size_)};
    }

    friend constexpr bool operator==(const rooted_tree&, const rooted_tree&) = default;
    /// By order, then lexicographically by level sequence.
    friend constexpr std::strong_ordering operator<=>(const rooted_tree& a, const rooted_tree& b) {
        if (a.size_ != b.size_) return a.size_ <=> b.size_;
        const auto [x, y] = std::mismatch(a.levels_.begin(), a.levels_.end(), b.levels_.begin());
        return x == a.levels_.end() ? std::strong_ordering::equal : *x <=> *y;
    }

    /// The next tree of the same order, from the tall one [[..[tau]..]] down to the bushy one
    /// [tau, ..., tau]; false (and no change) after the last. Constant amortised time
    /// (Beyer and Hedetniemi, SIAM J. Comput. 9, 1980).
    constexpr bool advance() {
        int p = size_ - 1;
        while (p > 0 && levels_[p] <= 2) --p;
        if (p <= 0) return false;
        int q = p - 1;
        while (levels_[q] != levels_[p] - 1) --q;
        for (int i = p; i < size_; ++i) levels_[i] = levels_[i - (p - q)];
        return true;
    }

    /// u with v attached to its root by a new edge: the Butcher product u∘v. Throws std::invalid_argument
    /// when the result has more than `max_order` vertices.
    friend constexpr rooted_tree butcher_product(const rooted_tree& u, const rooted_tree& v) {
        if (u.size_ + v.size_ > max_order)
            throw std::invalid_argument("butcher_product: the result has more than 20 vertices");
        rooted_tree r = u;
        for (int i = 0; i < v.size_; ++i)
            r.levels_[u.size_ + i] = static_cast<std::uint8_t>(v.levels_[i] + 1);
        r.size_ += v.size_;
        r.canonicalise(0, r.size_);
        return r;
    }

    /// The roots of u and v made one: all children of both at one root. The stage vectors multiply, g(r) =
    /// g(u) g(v). Throws std::invalid_argument when the result has more than `max_order` vertices.
    friend constexpr rooted_tree merge_roots(const rooted_tree& u, const rooted_tree& v) {
        if (u.size_ + v.size_ - 1 > max_order)
            throw std::invalid_argument("merge_roots: the result has more than 20 vertices");
        rooted_tree r = u;
        for (int i = 1; i < v.size_; ++i) r.levels_[u.size_ + i - 1] = v.levels_[i];
        r.size_ += v.size_ - 1;
        r.canonicalise(0, r.size_);
        return r;
    }

    /// The subtree that hangs at vertex i of the preorder, 0 <= i < order.
    constexpr rooted_tree subtree(int i) const {
        rooted_tree r;
        r.size_ = end_of(i) - i;
        for (int k = 0; k < r.size_; ++k)
            r.levels_[k] = static_cast<std::uint8_t>(levels_[i + k] - levels_[i] + 1);
        return r;
    }

    /// One past the last vertex of the subtree at vertex i.
    constexpr int end_of(int i) const {
        int e = i + 1;
        while (e < size_ && levels_[e] > levels_[i]) ++e;
        return e;
    }

  private:
    // Sorts the children of the vertex `first` (whose subtree ends at `last`), largest sequence first.
    constexpr void canonicalise(int first, int last) {
        for (int i = first + 1; i < last; i = end_of(i)) canonicalise(i, std::min(end_of(i), last));
        for (bool sorted = false; !sorted;) {
            sorted = true;
            for (int i = first + 1; i < last;) {
                const int j = end_of(i);
                if (j >= last) break;
                const int k = end_of(j);
                const auto at = [this](int n) { return levels_.begin() + n; };
                if (std::lexicographical_compare(at(i), at(j), at(j), at(k))) {
                    std::rotate(at(i), at(j), at(k));
                    sorted = false;
                    i += k - j;
                } else {
                    i = j;
                }
            }
        }
    }

    int size_;
    std::array<std::uint8_t, max_order> levels_{};
};

/// Number of vertices, Butcher's r(t).
constexpr int order(const rooted_tree& t) { return static_cast<int>(t.levels().size()); }

/// Density gamma(t): the product over all vertices of the number of vertices of the subtree there
/// (Hairer-Norsett-Wanner I.II.2, Definition 2.10). The order condition of t is b^T g(t) = 1/gamma(t).
constexpr std::int64_t density(const rooted_tree& t) {
    std::int64_t r = 1;
    for (int i = 0; i < order(t); ++i) r *= t.end_of(i) - i;
    return r;
}

/// Symmetry sigma(t): the order of the automorphism group.
constexpr std::int64_t symmetry(const rooted_tree& t) {
    const auto levels = t.levels();
    std::int64_t r = 1;
    for (int i = 1; i < order(t); ++i) {
        // Equal siblings are adjacent in canonical form: the m-th of a run contributes the factor m.
        std::int64_t m = 1;
        const int n = t.end_of(i) - i;
        for (int j = i - n; j > 0 && levels[j] == levels[i] && t.end_of(j) == j + n; j -= n, ++m)
            if (!std::equal(levels.begin() + j, levels.begin() + j + n, levels.begin() + i)) break;
        r *= m;
    }
    return r;
}

/// n!, 0 <= n <= 20.
constexpr std::int64_t factorial(int n) {
    if (n < 0 || n > 20) throw std::invalid_argument("factorial: 0 to 20 fit 64 bits");
    std::int64_t r = 1;
    for (int i = 2; i <= n; ++i) r *= i;
    return r;
}

/// Number of monotonic labelings, alpha(t) = n! / (gamma(t) sigma(t)) (Hairer-Norsett-Wanner I.II.2,
/// Definition 2.5); over all trees of order n they sum to (n-1)!.
constexpr std::int64_t labelings(const rooted_tree& t) {
    return factorial(order(t)) / density(t) / symmetry(t);
}

/// The subtrees at the root's children, the largest level sequence first.
inline std::vector<rooted_tree> children(const rooted_tree& t) {
    std::vector<rooted_tree> r;
    for (int i = 1; i < order(t); i = t.end_of(i)) r.push_back(t.subtree(i));
    return r;
}

/// [t1, ..., tm]: the tree whose root has these subtrees; tau for none. Throws std::invalid_argument when
/// it has more than `rooted_tree::max_order` vertices.
constexpr rooted_tree join(std::span<const rooted_tree> subtrees) {
    rooted_tree r;
    for (const rooted_tree& t : subtrees) r = butcher_product(r, t);
    return r;
}
/// The same for subtrees written out: join({tau, tau}).
constexpr rooted_tree join(std::initializer_list<rooted_tree> subtrees) {
    return join(std::span<const rooted_tree>(subtrees.begin(), subtrees.size()));
}

/// The tall tree [[..[tau]..]] with n vertices, the first of its order. Throws std::invalid_argument for
/// n outside 1..20.
constexpr rooted_tree tall_tree(int n) {
    std::array<int, rooted_tree::max_order> levels{};
    for (int i = 0; i < rooted_tree::max_order; ++i) levels[static_cast<std::size_t>(i)] = i + 1;
    if (n < 1 || n > rooted_tree::max_order) throw std::invalid_argument("tall_tree: order outside 1..20");
    return rooted_tree(std::span<const int>(levels.data(), static_cast<std::size_t>(n)));
}

/// Number of rooted trees with n vertices: 1, 1, 2, 4, 9, 20, 48, ... (OEIS A000081), by the recurrence that
/// Euler's transform gives: n T(n+1) = sum_k (sum_{d|k} d T(d)) T(n-k+1). Throws std::invalid_argument for n
/// outside 1..20.
constexpr std::int64_t number_of_trees(int n) {
    if (n < 1 || n > rooted_tree::max_order)
        throw std::invalid_argument("number_of_trees: order outside 1..20");
    std::array<std::int64_t, rooted_tree::max_order + 1> count{}, weighted{};
    count[1] = 1;
    for (int m = 1; m < n; ++m) {
        for (int d = 1; d <= m; ++d)
            if (m % d == 0) weighted[static_cast<std::size_t>(m)] += d * count[static_cast<std::size_t>(d)];
        std::int64_t sum = 0;
        for (int k = 1; k <= m; ++k)
            sum += weighted[static_cast<std::size_t>(k)] * count[static_cast<std::size_t>(m - k + 1)];
        count[static_cast<std::size_t>(m + 1)] = sum / m;
    }
    return count[static_cast<std::size_t>(n)];
}

/// The trees of one order, each once and in canonical form, as a range:
/// `for (const rooted_tree& t : trees_of_order(5))`.
class trees_of_order {
  public:
    class iterator {
      public:
        using iterator_category = std::forward_iterator_tag;
        using value_type = rooted_tree;
        using difference_type = std::ptrdiff_t;
        using pointer = const rooted_tree*;
        using reference = const rooted_tree&;

        constexpr iterator() = default;
        explicit constexpr iterator(const rooted_tree& t) : tree_(t), done_(false) {}
        constexpr reference operator*() const { return tree_; }
        constexpr pointer operator->() const { return &tree_; }
        constexpr iterator& operator++() {
            done_ = !tree_.advance();
            if (done_) tree_ = rooted_tree{};
            return *this;
        }
        constexpr iterator operator++(int) {
            iterator old = *this;
            ++*this;
            return old;
        }
        friend constexpr bool operator==(const iterator&, const iterator&) = default;

      private:
        rooted_tree tree_{};
        bool done_ = true;
    };

    /// Throws std::invalid_argument for n outside 1..20.
    explicit constexpr trees_of_order(int n) : first_(tall_tree(n)) {}
    constexpr iterator begin() const { return iterator(first_); }
    constexpr iterator end() const { return iterator(); }

  private:
    rooted_tree first_;
};

}  // namespace stagecraft
