// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <istream>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <stagecraft/options.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>

namespace stagecraft {

/// All that the rest of a run depends on, after an accepted step: integrate(method, problem, point, t1) goes on
/// from there and makes the same steps, bit by bit, that the run would have made if it is given the same method,
/// problem and t1. Its options are those of the run, unless others are given there. A plain value that owns what it needs; one is taken by the observer `save_every`
/// (observe/save_every.hpp), by step_range::save() or by an observer's own member save (observe/observer.hpp).
///
/// t and y are where the run was. `numbers` and `counts` are what it remembers (step size, order, controllers, jumps seen, the
/// last step's polynomial, the Jacobian and for which step it is factored, the report), in an order that may change
/// with the version of the library; factors are made again. `options` are those of the run; without them (in files of
/// version 2, say) options have to be given to go on. Size: n (s + 5) numbers and those of the Jacobian, n more with
/// atol_components.
///
/// Not in it: what observers and the problem itself remember, and what a linear_solver of the problem's own keeps
/// from one factorisation to the next (the preconditioners of krylov_blocks and petsc_blocks, the factors of klu_blocks
/// where they serve several steps): with these the run goes on within the tolerance, not bit by bit.
template <class Vector>
struct checkpoint {
    using scalar = typename Vector::Scalar;
    scalar t{0};
    Vector y;
    std::vector<scalar> numbers;
    std::vector<long> counts;
    std::optional<stagecraft::options<scalar>> options{};
};

/// Not without the type of the state.
template <>
struct checkpoint<detail::unstated> {
    template <class Never = void>
    checkpoint() {
        static_assert(detail::never<Never>,
                      "write checkpoint<Eigen::Vector3d> last, with the type of the state");
    }
    template <class Point>
    void operator=(const Point&);
    friend std::ostream& operator<<(std::ostream&, const checkpoint&);
    friend std::istream& operator>>(std::istream&, checkpoint&);
};
checkpoint()->checkpoint<detail::unstated>;

namespace detail {

inline constexpr const char *checkpoint_header = "stagecraft checkpoint 3",
                            *header_without_options = "stagecraft checkpoint 2";

/// The options of the run that a checkpoint was taken of. std::invalid_argument where it has none.
template <class Point>
const auto& options_of(const Point& point) {
    if (!point.options)
        throw std::invalid_argument(
            "integrate: the checkpoint is without the options of its run: give them, integrate(method, "
            "problem, "
            "checkpoint, t1, options)");
    return *point.options;
}

/// Calls visit with the numbers of some options, and with what they choose and count.
template <class Options, class Numbers, class Choices>
void visit_options(Options& o, Numbers&& numbers, Choices&& choices) {
    auto& [rtol, atol, components, fixed, first, least, largest, control, continuous, jumps, steps,
           iterations, factor, breaks, consistent] =
        o;  // all of them: another one does not compile before it is saved
    static_cast<void>(components), static_cast<void>(breaks), static_cast<void>(consistent);
    numbers(rtol, atol, fixed, first, least, largest, factor);
    choices(control, continuous, jumps, steps, iterations);
}
template <class Scalar>
using bits_of = std::conditional_t<sizeof(Scalar) == 8, std::uint64_t, std::uint32_t>;

/// Puts what a run remembers into a Point, or takes it out of a const one in the same order: carry(*this) of
/// the parts of a run calls it with their members.
template <class Point>
class luggage {
  public:
    using scalar = typename Point::scalar;
    static constexpr bool unpacks = std::is_const_v<Point>;

    explicit luggage(Point& point) : point_(point) {}

    template <class... Parts>
    void operator()(Parts&... parts) {
        (one(parts), ...);
    }
    /// std::invalid_argument where `value` is not what it was when the checkpoint was taken, or where all that
    /// came before it had another size. The latter shows by a mark, a negative number unlike any count.
    void same(long value, const char* what) {
        const long mark = -1 - static_cast<long>(std::char_traits<char>::length(what));
        long found = mark, then = value;
        one(found);
        if (found != mark) refuse("method or problem");
        one(then);
        if (then != value) refuse(what);
    }
    /// std::invalid_argument where the method is another one: of other stages, order or coefficients. Of these the
    /// sum_k k x_k is kept, which tells methods apart and which no compiler changes by more than rounding.
    template <class Method>
    void same_method(const Method& method, long order) {
        using std::abs;
        scalar sum(0);
        int k = 0;
        const auto add = [&](const auto& x) {
            for (Eigen::Index i = 0; i < x.size(); ++i) sum += scalar(++k) * x.data()[i];
        };
        add(method.A), add(method.b), add(method.c), add(method.b_embedded);
        const scalar here = sum;
        const long stages = method.stages();
        long stages_then = stages, order_then = order;
        same(0, "method");
        one(stages_then), one(order_then), one(sum);
        if (stages_then != stages || order_then != order)
            refuse("method: of " + std::to_string(stages_then) + " stages and order " +
                   std::to_string(order_then) + ", and not of " + std::to_string(stages) + " and " +
                   std::to_string(order));
        if (!(abs(sum - here) <= abs(here) / 1000000))
            refuse("method: of as many stages and of the same order, but of other coefficients");
    }
    /// Everything has been taken out.
    void finish() const {
        if (number_ != point_.numbers.size() || count_ != point_.counts.size()) refuse("method or problem");
    }
    [[noreturn]] static void refuse(const std::string& what) {
        throw std::invalid_argument("integrate: checkpoint is of another " + what);
    }

  private:
    template <class Part>
    void one(Part& x) {
        if constexpr (requires { x.carry(*this); }) {
            x.carry(*this);
        } else if constexpr (std::is_same_v<Part, scalar>) {
            several(&x, 1);
        } else if constexpr (std::is_integral_v<Part> || std::is_enum_v<Part>) {
            if constexpr (!unpacks) {
                point_.counts.push_back(static_cast<long>(x));
            } else {
                if (count_ == point_.counts.size()) refuse("method or problem");
                x = static_cast<Part>(point_.counts[count_++]);
            }
        } else if constexpr (requires { x.valuePtr(); }) {
            several(x.valuePtr(), x.nonZeros());
        } else {
            static_assert(
                requires { x.data(); },
                "checkpoint: the type of problem.matrix() needs `template <class Bag> void carry(Bag& bag)` "
                "that calls bag(...) with the members to be saved: scalars, integers, matrices of Eigen's");
            several(x.data(), x.size());
        }
    }
    void several(scalar* x, Eigen::Index count) {
        const std::size_t k = static_cast<std::size_t>(count);
        if constexpr (!unpacks) {
            point_.numbers.insert(point_.numbers.end(), x, x + k);
        } else {
            if (point_.numbers.size() - number_ < k) refuse("method or problem");
            for (std::size_t i = 0; i < k; ++i) x[i] = point_.numbers[number_++];
        }
    }

    Point& point_;
    std::size_t number_ = 0, count_ = 0;  // taken out so far
};

template <class Numbers>
void write_bits(std::ostream& out, const char* name, const Numbers& x) {
    using scalar = std::remove_cvref_t<decltype(x[0])>;
    using bits = bits_of<scalar>;
    out << name << ' ' << x.size() << '\n';
    for (const scalar& number : x) {
        std::string digits(2 * sizeof(bits), '0');
        bits rest = std::bit_cast<bits>(number);
        for (std::size_t i = digits.size(); i-- > 0; rest >>= 4) digits[i] = "0123456789abcdef"[rest & 15];
        out << digits << '\n';
    }
}

inline std::size_t read_size(std::istream& in, const char* name) {
    std::string word;
    std::size_t size = 0;
    if (!(in >> word >> size) || word != name)
        throw std::invalid_argument(std::string("checkpoint: the text should go on with ") + name +
                                    " and their number");
    return size;
}

inline void write_counts(std::ostream& out, const char* name, const std::vector<long>& counts) {
    out << name << ' ' << counts.size() << '\n';
    for (const long count : counts) out << std::to_string(count) << '\n';
}
inline void read_counts(std::istream& in, const char* name, std::vector<long>& counts) {
    for (std::size_t size = read_size(in, name); size > 0; --size) {
        long count = 0;
        if (!(in >> count))
            throw std::invalid_argument(std::string("checkpoint: one of ") + name + " is missing");
        counts.push_back(count);
    }
}

/// Calls take(x) with every number of the list.
template <class Scalar, class Take>
void read_bits(std::istream& in, const char* name, Take&& take) {
    using bits = bits_of<Scalar>;
    for (std::size_t size = read_size(in, name); size > 0; --size) {
        std::string digits;
        in >> digits;
        if (digits.size() != 2 * sizeof(bits) ||
            digits.find_first_not_of("0123456789abcdef") != std::string::npos)
            throw std::invalid_argument(std::string("checkpoint: a number of ") + name +
                                        " is not the bits of one");
        take(std::bit_cast<Scalar>(static_cast<bits>(std::stoull(digits, nullptr, 16))));
    }
}

/// FNV-1a of 64 bits, which any change of one character changes.
inline std::string checksum(const std::string& lines) {
    std::uint64_t sum = 14695981039346656037U;
    for (const char c : lines) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return std::to_string(sum);
}

/// The lines of a checkpoint behind its header, up to the one with their checksum; whether options are among them.
inline std::pair<std::string, bool> checked_lines(std::istream& in) {
    std::string line;
    std::getline(in >> std::ws, line);
    const bool with_options = line == checkpoint_header;
    if (!with_options && line != header_without_options)
        throw std::invalid_argument(std::string("checkpoint: the text should begin with ") +
                                    checkpoint_header);
    std::string lines = line + '\n';
    const std::size_t header = lines.size();
    while (std::getline(in, line) && !line.starts_with("checksum ")) lines += line + '\n';
    if (line != "checksum " + checksum(lines))
        throw std::invalid_argument("checkpoint: the text is not as it was written: its checksum is another");
    return {lines.substr(header), with_options};
}

template <class Scalar>
void write_options(std::ostream& out, const std::optional<options<Scalar>>& given) {
    std::vector<Scalar> numbers;
    std::vector<long> choices;
    if (given)
        visit_options(
            *given, [&](const auto&... x) { (numbers.push_back(x), ...); },
            [&](const auto&... x) { (choices.push_back(static_cast<long>(x)), ...); });
    write_bits(out, "options", numbers);
    write_counts(out, "choices", choices);
    write_bits(out, "atol_components", given ? given->atol_components : numbers_of_components<Scalar>());
    if (given && !given->break_points.empty()) write_bits(out, "break_points", given->break_points.numbers());
    if (given && given->consistent_start) write_counts(out, "consistent_start", {1});
}
/// Reads the same. std::invalid_argument where there are fewer or more than there are options.
template <class Scalar>
std::optional<options<Scalar>> read_options(std::istream& in) {
    std::vector<Scalar> numbers, components;
    std::vector<long> choices;
    read_bits<Scalar>(in, "options", [&](const Scalar& x) { numbers.push_back(x); });
    read_counts(in, "choices", choices);
    read_bits<Scalar>(in, "atol_components", [&](const Scalar& x) { components.push_back(x); });
    if (numbers.empty()) return std::nullopt;
    options<Scalar> read;
    std::size_t number = 0, choice = 0;
    const auto next = [](const auto& list, std::size_t& k) {
        if (k == list.size()) throw std::invalid_argument("checkpoint: an option is missing");
        return list[k++];
    };
    visit_options(
        read, [&](auto&... x) { ((x = next(numbers, number)), ...); },
        [&](auto&... x) {
            ((x = static_cast<std::remove_cvref_t<decltype(x)>>(next(choices, choice))), ...);
        });
    read.atol_components =
        numbers_of_components<Scalar>(Eigen::Map<const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>>(
            components.data(), static_cast<Eigen::Index>(components.size())));
    const auto begins_with = [&](char first) { return in >> std::ws && in.peek() == first; };
    if (begins_with('b'))
        read_bits<Scalar>(in, "break_points",
                          [&](const Scalar& x) { read.break_points.numbers().push_back(x); });
    if (begins_with('c')) {
        std::vector<long> asked;
        read_counts(in, "consistent_start", asked);
        read.consistent_start = !asked.empty();
    }
    return read;
}

}  // namespace detail

/// Writes a checkpoint of doubles or floats as text that reads back to the same bits everywhere: the line
/// "stagecraft checkpoint 3" (the version of the form), then the lists t, y, numbers, counts, options (rtol, atol,
/// fixed_step, initial_step, min_step, max_step, newton_factor; none where there are no options), choices (control,
/// continuous, jumps, max_steps, newton_iterations), atol_components and, where there are any, break_points and consistent_start, each as a line with its
/// name and size and a line for every entry, then "checksum" and the FNV-1a hash (64 bits, decimal) of all lines
/// before. A floating-point number is the hexadecimal digits of its IEEE 754 bits, most significant first (Python:
/// struct.unpack('>d', bytes.fromhex(line))); a count is decimal.
template <class Vector>
std::ostream& operator<<(std::ostream& out, const checkpoint<Vector>& point) {
    static_assert(std::is_floating_point_v<typename Vector::Scalar> && sizeof(typename Vector::Scalar) <= 8,
                  "checkpoint: only those of float and double are written; copy the members of others");
    std::ostringstream text;
    text << detail::checkpoint_header << '\n';
    detail::write_bits(text, "t", Eigen::Matrix<typename Vector::Scalar, 1, 1>(point.t));
    detail::write_bits(text, "y", point.y);
    detail::write_bits(text, "numbers", point.numbers);
    detail::write_counts(text, "counts", point.counts);
    detail::write_options(text, point.options);
    const std::string lines = text.str();
    return out << lines << "checksum " << detail::checksum(lines) << '\n';
}

/// Reads what operator<< has written, and version 2, which has no options. Throws std::invalid_argument where it is something else, or not all of it as it
/// was written.
template <class Vector>
std::istream& operator>>(std::istream& in, checkpoint<Vector>& point) {
    using scalar = typename Vector::Scalar;
    const auto [lines, with_options] = detail::checked_lines(in);
    std::istringstream text(lines);
    std::vector<scalar> y;
    checkpoint<Vector> read;
    detail::read_bits<scalar>(text, "t", [&](const scalar& x) { read.t = x; });
    detail::read_bits<scalar>(text, "y", [&](const scalar& x) { y.push_back(x); });
    if (Vector::SizeAtCompileTime >= 0 && static_cast<Eigen::Index>(y.size()) != Vector::SizeAtCompileTime)
        throw std::invalid_argument("checkpoint: y has another size");
    read.y = Eigen::Map<const Vector>(y.data(), static_cast<Eigen::Index>(y.size()));
    detail::read_bits<scalar>(text, "numbers", [&](const scalar& x) { read.numbers.push_back(x); });
    detail::read_counts(text, "counts", read.counts);
    if (with_options) read.options = detail::read_options<scalar>(text);
    point = std::move(read);
    return in;
}

}  // namespace stagecraft
