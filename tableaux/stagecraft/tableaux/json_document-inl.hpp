// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/json_document.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/tableaux/tableau_file.hpp"

namespace stagecraft::tableaux {

namespace json_reader {

STAGECRAFT_INLINE std::string in_quotes(std::string_view text) {
    std::string shown;
    for (const char ch : text.substr(0, 60)) shown += ch >= ' ' && ch < 127 ? ch : '?';
    return "'" + shown + (text.size() > 60 ? "..." : "") + "'";
}

/// Input iterator that counts the line ends before the character last read.
struct line_counting_iterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at = nullptr;
    int* line = nullptr;

    reference operator*() const { return *at; }
    line_counting_iterator& operator++() {
        if (line && *at == '\n') ++*line;
        ++at;
        return *this;
    }
    line_counting_iterator operator++(int) {
        auto old = *this;
        ++*this;
        return old;
    }
    friend bool operator==(const line_counting_iterator& x, const line_counting_iterator& y) {
        return x.at == y.at;
    }
    friend bool operator!=(const line_counting_iterator& x, const line_counting_iterator& y) {
        return x.at != y.at;
    }
};

/// SAX handler that stops at the value with a given path, to find its line; also finds repeated keys.
class path_finder {
  public:
    path_finder(std::string wanted, const int& line)
        : wanted_(std::move(wanted)),
          depth_(static_cast<std::size_t>(std::count(wanted_.begin(), wanted_.end(), '/'))),
          line_(line) {}

    int line() const { return found_; }
    const std::string& repeated_key() const { return repeated_; }

    bool null() { return value(); }
    bool boolean(bool) { return value(); }
    bool number_integer(json::number_integer_t) { return value(); }
    bool number_unsigned(json::number_unsigned_t) { return value(); }
    bool number_float(json::number_float_t, const std::string&) { return value(); }
    bool string(std::string&) { return value(); }
    bool binary(json::binary_t&) { return value(); }
    bool start_object(std::size_t) { return open(); }
    bool end_object() { return close(); }
    bool start_array(std::size_t) { return open(); }
    bool end_array() { return close(); }
    bool key(std::string& k) {
        if (!levels_.back().keys.insert(k).second) {
            repeated_ = k;
            found_ = line_;
            return false;
        }
        levels_.back().current = k;
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const json::exception&) { return false; }

  private:
    struct level {
        std::size_t index = 0;
        std::string current;
        std::set<std::string> keys;
    };

    /// False where the walk has arrived.
    bool match() {
        std::string here;
        if (levels_.size() <= depth_)
            for (const level& l : levels_)
                here += "/" + (l.keys.empty() ? std::to_string(l.index) : l.current);
        if (here != wanted_) return true;
        found_ = line_;
        return false;
    }
    bool advance() {
        if (!levels_.empty()) ++levels_.back().index;
        return true;
    }
    bool value() { return match() && advance(); }
    bool open() {
        if (!match()) return false;
        levels_.emplace_back();
        return true;
    }
    bool close() {
        levels_.pop_back();
        return advance();
    }

    std::string wanted_;
    std::size_t depth_;
    const int& line_;
    int found_ = 0;
    std::string repeated_;
    std::vector<level> levels_;
};

STAGECRAFT_INLINE path_finder find_path(std::string_view text, const std::string& path, int& line) {
    line = 1;
    path_finder finder(path, line);
    json::sax_parse(line_counting_iterator{text.data(), &line},
                    line_counting_iterator{text.data() + text.size(), nullptr}, &finder);
    return finder;
}

STAGECRAFT_INLINE document document::part(const std::string& path, const std::string& part_name,
                                          const json& value) const {
    return {text, value, at + path, within + part_name + "."};
}

STAGECRAFT_INLINE void reject(const document& d, const std::string& path, const std::string& entry_name,
                              const std::string& what) {
    int line = 1;
    const int found = find_path(d.text, d.at + path, line).line();
    const std::string where = d.within + entry_name;
    throw unusable_input("line " + std::to_string(std::max(found, 1)) + (where.empty() ? "" : ", ") + where +
                         ": " + what);
}

/// What stands in the text where a parser stopped, from the beginning of its word to the end of its line.
STAGECRAFT_INLINE std::string around(std::string_view text, std::size_t stopped) {
    const auto in_word = [&](std::size_t k) {
        return std::isalnum(static_cast<unsigned char>(text[k])) != 0;
    };
    std::size_t start = stopped;
    while (start > 0 && in_word(start) && in_word(start - 1)) --start;
    const auto shown = text.substr(start, 60);
    return in_quotes(shown.substr(0, std::max<std::size_t>(shown.find('\n'), 1)));
}

STAGECRAFT_INLINE document parse(std::string_view text) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw unusable_input("line 1: the text is empty");
    int line = 1;
    const path_finder finder = find_path(text, "never", line);
    if (!finder.repeated_key().empty())
        throw unusable_input("line " + std::to_string(finder.line()) + ": key " +
                             in_quotes(finder.repeated_key()) + " appears twice");
    try {
        return {text, json::parse(text), {}, {}};
    } catch (const json::parse_error& e) {
        const auto upto = text.substr(0, std::min(e.byte, text.size()));
        const auto breaks = std::count(upto.begin(), upto.end(), '\n');
        const bool end = e.byte > text.size();
        throw unusable_input(
            "line " + std::to_string(breaks + 1) + ": not JSON: " +
            (end ? "the text ends too early" : "unexpected " + around(text, e.byte == 0 ? 0 : e.byte - 1)));
    } catch (const json::exception&) {
        throw unusable_input("line " + std::to_string(line) + ": non-finite number");
    }
}

STAGECRAFT_INLINE entry number(const document& d, const json& value, const std::string& path,
                               const std::string& entry_name) {
    try {
        if (value.is_string()) return read_entry(value.get_ref<const std::string&>());
        entry e;
        if (value.is_number_unsigned())
            e = expression_grammar::from_exact(rational(value.get<std::uint64_t>()));
        else if (value.is_number_integer())
            e = expression_grammar::from_exact(rational(value.get<std::int64_t>()));
        else if (value.is_number_float())
            e = entry_from_double(value.get<double>(), value.dump());
        else
            throw std::invalid_argument("must be a number written as a string");
        e.text = value.dump();
        return e;
    } catch (const std::invalid_argument& error) {
        const std::string shown =
            value.is_string() ? in_quotes(value.get_ref<const std::string&>()) + " " : "";
        reject(d, path, entry_name, shown + error.what());
    }
}

STAGECRAFT_INLINE std::vector<entry> numbers(const document& d, const json& value, const std::string& path,
                                             const std::string& vector_name, std::size_t expected) {
    if (!value.is_array()) reject(d, path, vector_name, "must be a list of numbers");
    if (expected != 0 && value.size() != expected)
        reject(d, path, vector_name,
               "has " + std::to_string(value.size()) + " entries, b has " + std::to_string(expected));
    std::vector<entry> all;
    for (std::size_t i = 0; i < value.size(); ++i)
        all.push_back(number(d, value[i], path + "/" + std::to_string(i),
                             vector_name + "[" + std::to_string(i + 1) + "]"));
    return all;
}

STAGECRAFT_INLINE void require_keys(const document& d, const std::set<std::string>& known,
                                    std::initializer_list<const char*> required) {
    for (const auto& [key, value] : d.root.items())
        if (!known.contains(key)) reject(d, "/" + key, in_quotes(key), "unknown key");
    for (const char* key : required)
        if (!d.root.contains(key)) reject(d, "", "", std::string(key) + " is missing");
}

STAGECRAFT_INLINE std::vector<entry> weights(const document& d) {
    auto b = numbers(d, d.root["b"], "/b", "b", 0);
    if (b.empty()) reject(d, "/b", "b", "is empty");
    if (b.size() > most_stages)
        reject(d, "/b", "b", "has more than " + std::to_string(most_stages) + " entries");
    return b;
}

STAGECRAFT_INLINE std::vector<std::vector<entry>> rows(const document& d, const std::string& key,
                                                       std::size_t s) {
    const auto& A = d.root[key];
    if (!A.is_array() || A.size() != s)
        reject(d, "/" + key, key,
               "must be a list of " + std::to_string(s) + " rows, as many as b has entries");
    std::vector<std::vector<entry>> all;
    for (std::size_t i = 0; i < s; ++i)
        all.push_back(numbers(d, A[i], "/" + key + "/" + std::to_string(i),
                              key + "[" + std::to_string(i + 1) + "]", s));
    return all;
}

STAGECRAFT_INLINE std::vector<std::vector<entry>> polynomials(const document& d, std::size_t s) {
    const auto& all = d.root["b_theta"];
    if (!all.is_array() || all.size() != s)
        reject(d, "/b_theta", "b_theta", "must be a list of " + std::to_string(s) + " lists of coefficients");
    std::vector<std::vector<entry>> polynomials;
    for (std::size_t i = 0; i < s; ++i) {
        const std::string path = "/b_theta/" + std::to_string(i);
        const std::string name = "b_theta[" + std::to_string(i + 1) + "]";
        polynomials.push_back(numbers(d, all[i], path, name, 0));
        if (polynomials.back().size() > largest_dense_degree)
            reject(d, path, name, "has more than " + std::to_string(largest_dense_degree) + " coefficients");
    }
    return polynomials;
}

STAGECRAFT_INLINE std::string text_field(const document& d, const char* key) {
    if (!d.root.contains(key)) return {};
    if (!d.root[key].is_string()) reject(d, std::string("/") + key, key, "must be a text");
    return d.root[key].get<std::string>();
}

STAGECRAFT_INLINE reading with_tolerance_of(const document& d, reading how) {
    if (!d.root.contains("tolerance")) return how;
    const json& given = d.root["tolerance"];
    try {
        if (!given.is_string() && !given.is_number()) throw std::invalid_argument("no number");
        const auto e =
            read_entry(given.is_string() ? given.get<std::string>() : given.dump(), exact_decimals::all());
        if (!e.exact || !e.exact->is_rational() || e.exact->rational_part() < 0)
            throw std::invalid_argument("no number");
        how.tolerance = std::max(how.tolerance, e.exact->rational_part());
    } catch (const std::invalid_argument&) {
        reject(d, "/tolerance", "tolerance", "must be a number that is not negative");
    }
    return how;
}

}  // namespace json_reader

}  // namespace stagecraft::tableaux
