// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft {

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
    template <class Scalar, class Vector>
    void start(const Scalar& t0, const Vector& y0, const Scalar&) {
        head(y0.size());
        (*this)(t0, y0);
    }
    /// A row. Begins the table where there was no run to do it. std::invalid_argument where y has not as many
    /// components as there are names.
    template <class Scalar, class Vector>
    void operator()(const Scalar& t, const Vector& y) {
        if (!begun_) head(y.size());
        if (static_cast<std::size_t>(y.size()) != names_.size())
            throw std::invalid_argument("table: there must be a name for every component of y");
        std::ostringstream row;
        row.imbue(std::locale::classic());
        row.precision(std::numeric_limits<Scalar>::max_digits10);
        const bool json = form_ == table_form::json_lines;
        row << (json ? "{\"t\": " : "") << t;
        for (Eigen::Index i = 0; i < y.size(); ++i) {
            row << (json ? ", \"" + names_[static_cast<std::size_t>(i)] + "\": " : ",");
            row << y[i];
        }
        *out_ << row.str() << (json ? "}\n" : "\n");
    }

  private:
    void head(Eigen::Index n) {
        begun_ = true;
        if (names_.empty())
            for (Eigen::Index i = 0; i < n; ++i) names_.push_back("y" + std::to_string(i));
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
/// At other times, by hand: auto row = csv(file); for (double t : times) row(t, solution(t)). The stream is not copied.
/// std::invalid_argument for names that need quoting, or as many as do not suit y.
inline table_writer csv(std::ostream& out, std::vector<std::string> names = {}) {
    return {out, std::move(names), table_form::csv};
}

/// The same with an object of JSON on each line, {"t": 0, "y0": 1, ...}.
inline table_writer json_lines(std::ostream& out, std::vector<std::string> names = {}) {
    return {out, std::move(names), table_form::json_lines};
}

}  // namespace stagecraft
