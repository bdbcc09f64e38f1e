"""What make/reference.py and make/trees.py read is what stands there."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "examples/site/make"))
import reference  # noqa: E402
import trees  # noqa: E402

HEADER = '''
namespace a {

/// A class. It's said with an apostrophe.
///
///     widget<int> w;
template <class T>
requires(sizeof(T) > 1 && requires(T t) { t.x(); }) class widget {
  public:
    /// Sized.
    explicit widget(int n) : n_(n), list_{1, 2} { fill("}"); }
    int size() const { return n_; }  ///< of them

  private:
    int n_ = 1'000;
};

namespace detail {
/// Nobody's business.
void hidden();
}  // namespace detail

/// A concept.
template <class P>
concept good = requires(P& p) {
    { p.f() } -> std::same_as<int>;
};

/// A function.
template <class T>
requires requires(const T& t) { t.f(); }
auto apply(const T& t, options o = {}) -> int {
    return t.f();
}

/// A value.
inline constexpr int zeros[] = {0, 0};

/// An enumeration.
enum class colour { red, blue };
}  // namespace a
'''

found = {name: (kind, doc, text) for name, kind, doc, text in reference.entries(HEADER)}
assert list(found) == ["widget", "good", "apply", "zeros", "colour"], list(found)
widget = found["widget"][2]
assert "explicit widget(int n);" in widget and "int size() const;  ///< of them" in widget, widget
assert "n_" not in widget and "fill" not in widget and "/// Sized." in widget, widget
assert found["good"][2].endswith("-> std::same_as<int>;\n};"), found["good"][2]
assert found["apply"][2].endswith("auto apply(const T& t, options o = {}) -> int;"), found["apply"][2]
assert found["zeros"][0] == "value" and "{0, 0}" in found["zeros"][2], found["zeros"]
assert found["colour"][2] == "enum class colour { red, blue };", found["colour"][2]
assert reference.markdown(found["widget"][1]) == "A class. It's said with an apostrophe.\n\n```cpp\nwidget<int> w;\n```"
assert reference.escaped("a_ij < [b] `a_ij`") == "a\\_ij \\< \\[b\\] `a_ij`"

place, children = trees.positions([0, 1, 2, 1])  # [tau,[tau]]
assert children == {0: [1, 3], 1: [2], 2: [], 3: []} and place[0][0] == (place[1][0] + place[3][0]) / 2
