// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <complex>
#include <cstddef>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace stagecraft {

namespace detail {
template <class T>
inline constexpr bool is_complex_number = false;
template <class T>
inline constexpr bool is_complex_number<std::complex<T>> = true;

/// Calls take(x) with every real number of a state: it is a number, or has several; a complex one is two, real part first.
template <class State, class Take>
void each_number(const State& y, const Take& take) {
    if constexpr (is_complex_number<State>) {
        take(y.real());
        take(y.imag());
    } else if constexpr (requires { y[0]; }) {
        for (const auto& component : y) each_number(component, take);
    } else {
        take(y);
    }
}
}  // namespace detail

/// How a table_writer writes a row.
enum class table_form { csv, json_lines };

/// An observer that writes the accepted states to a stream; made by csv() and json_lines(). See there.
class table_writer {
  public:
    table_writer(std::ostream& out, std::vector<std::string> names, table_form form)
        : out_(&out), names_(std::move(names)), form_(form) {
        for (const auto& name : names_)
            if (name.empty() || name.find_first_of("\",\\\n\r\t") != std::string::npos)
                throw std::invalid_argument(
                    "table: names must have no quotes, commas, backslashes or line ends: " + name);
    }

    /// The head of the table, and the row of the initial state.
    template <class Scalar, class State>
    void start(const Scalar& t0, const State& y0, const Scalar&) {
        head(y0);
        (*this)(t0, y0);
    }
    /// A row. Begins the table where there was no run to do it. std::invalid_argument where y has not as many
    /// numbers as there are names.
    template <class Scalar, class State>
    void operator()(const Scalar& t, const State& y) {
        if (!begun_) head(y);
        if (count(y) != names_.size())
            throw std::invalid_argument(
                "table: there must be a name for every component of y, two for a complex one");
        std::ostringstream row;
        row.imbue(std::locale::classic());
        const bool json = form_ == table_form::json_lines;
        const auto write = [&](const auto& x) {
            using number = std::remove_cvref_t<decltype(x)>;
            row.precision(std::numeric_limits<number>::max_digits10);
            if (json && !(x - x == number(0)))
                row << "null";  // JSON has no other numbers than finite ones
            else
                row << x;
        };
        row << (json ? "{\"t\": " : "");
        write(t);
        auto name = names_.begin();
        detail::each_number(y, [&](const auto& x) {
            row << (json ? ", \"" + *name++ + "\": " : ",");
            write(x);
        });
        *out_ << row.str() << (json ? "}\n" : "\n");
    }

    /// Another row where the run has changed y.
    template <class Scalar, class State>
    void changed(const Scalar& t, const State& y) {
        (*this)(t, y);
    }

  private:
    template <class State>
    static std::size_t count(const State& y) {
        std::size_t n = 0;
        detail::each_number(y, [&](const auto&) { ++n; });
        return n;
    }
    template <class State>
    void head(const State& y) {
        begun_ = true;
        if (names_.empty())
            for (std::size_t i = 0; i < count(y); ++i) names_.push_back("y" + std::to_string(i));
        if (form_ == table_form::json_lines) return;
        *out_ << 't';
        for (const auto& name : names_) *out_ << ',' << name;
        *out_ << '\n';
    }

    std::ostream* out_;
    std::vector<std::string> names_;
    table_form form_;
    bool begun_ = false;
};

/// An observer that writes t and y as comma-separated values after every step: a line of names (t, then those given,
/// or y0, y1, ...) and a line for every state, with all digits that a number needs to be read back:
///
///     std::ofstream file("run.csv");
///     integrate(method, problem, y0, t0, t1, options, csv(file, {"position", "speed"}));
///
/// y is a state of any kind. A complex number is two columns, its real part and its imaginary part, with a name each: {"re z",
/// "im z"}. At other times, by hand: auto row = csv(file); for (double t : times) row(t, solution(t)). The stream is not copied.
/// std::invalid_argument for names that need quoting, or as many as do not suit y.
inline table_writer csv(std::ostream& out, std::vector<std::string> names = {}) {
    return {out, std::move(names), table_form::csv};
}

/// The same with an object of JSON on each line, {"t": 0, "y0": 1, ...}; null stands for numbers that are not finite.
inline table_writer json_lines(std::ostream& out, std::vector<std::string> names = {}) {
    return {out, std::move(names), table_form::json_lines};
}

}  // namespace stagecraft
