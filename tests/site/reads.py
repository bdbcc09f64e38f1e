"""What make/reference.py and make/trees.py read is what stands there, and what make/pictures.py leaves is what was drawn."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "examples/site/make"))
import pictures  # noqa: E402
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

# Bars of two colours stay two areas, and ticks keep their lines and numbers.
bars = "".join(f"<polygon fill = '{fill}' points = '{x},{y} {x + 2},{y} {x + 2},{y - 1} {x},{y - 1}'/>"
               for y in (9, 8) for fill, x in (("red", 0), ("blue", 2)))
drawn = pictures.slim(f"<svg>{bars}</svg>", "a < b")
assert "<title>a &lt; b</title>" in drawn and drawn.count("<path") == 2, drawn
assert "fill='red' stroke='red' d='M0,9" in drawn and "fill='blue' stroke='blue' d='M2,9" in drawn, drawn
ticks = "".join(f"""<g stroke="a">\n<path stroke='b'  d='M0,{y}L9,{y}'/>\t<g transform="translate(1,{y})" fill="c">
<text>{y}</text>\n</g>\n</g>\n""" for y in (1, 2))
drawn = pictures.slim(f"<svg>{ticks}</svg>", "t")
assert "d='M0,1L9,1M0,2L9,2'" in drawn and drawn.count("<path") == 1, drawn
assert "<text x='1' y='1'>1</text><text x='1' y='2'>2</text>" in drawn, drawn
