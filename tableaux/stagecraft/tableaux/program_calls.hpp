// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
#include "stagecraft/tableaux/array_value.hpp"
#include "stagecraft/tableaux/program_tokens.hpp"

/// The calls, wrappers and methods around the arrays and numbers of a program. What is not yet read is a line here.

namespace stagecraft::tableaux::program_text {

/// What a call does with its numbers.
enum class call_does {
    keep,             ///< np.array([...]), RCONST(0.5): its argument; F(1, 2): a fraction
    list,             ///< SVector(1, 2), c(1, 2): its arguments are the numbers
    list_by_columns,  ///< SMatrix{2, 2}(1, 2, 3, 4)
    by_rows,          ///< np.reshape([...], (2, 2))
    by_columns,       ///< reshape([...], [2, 2])
    transpose,
    zeros,  ///< np.zeros((2, 2)): to be filled
    ones,   ///< np.ones(2), fill(1//2, 2): a list of the same number
    root,   ///< sqrt and what read_entry knows by the same name
    square,
    power  ///< pow(x, 3)
};

struct call_entry {
    std::string_view name;  ///< longer ones before their last parts
    call_does does;
};

/// A library's word for an array or a number is a line here.
inline constexpr std::array calls{
    call_entry{"np.reshape", call_does::by_rows},
    call_entry{"numpy.reshape", call_does::by_rows},
    call_entry{"jnp.reshape", call_does::by_rows},
    call_entry{"torch.reshape", call_does::by_rows},
    call_entry{"reshape", call_does::by_columns},
    call_entry{"transpose", call_does::transpose},
    call_entry{"SVector", call_does::list},
    call_entry{"MVector", call_does::list},
    call_entry{"SMatrix", call_does::list_by_columns},
    call_entry{"MMatrix", call_does::list_by_columns},
    call_entry{"c", call_does::list},
    call_entry{"matrix", call_does::by_columns},
    call_entry{"zeros", call_does::zeros},
    call_entry{"ones", call_does::ones},
    call_entry{"fill", call_does::ones},
    call_entry{"sqrt", call_does::root},
    call_entry{"PetscSqrtReal", call_does::root},
    call_entry{"SUNRsqrt", call_does::root},
    call_entry{"PetscSqr", call_does::square},
    call_entry{"cbrt", call_does::root},
    call_entry{"cos", call_does::root},
    call_entry{"sin", call_does::root},
    call_entry{"pow", call_does::power},
    call_entry{"power", call_does::power},
};

/// Words that wrap numbers or arrays and change nothing, or make a fraction of two numbers. So do words without small
/// letters, as RCONST and Q.
inline constexpr std::array<std::string_view, 53> wrappers{
    "array",    "asarray",     "tensor",   "Tensor",   "as_tensor", "Matrix",   "ImmutableMatrix",
    "SA",       "vec",         "list",     "tuple",    "Array",     "Vector",   "asanyarray",
    "Rational", "Fraction",    "Decimal",  "mpf",      "mpq",       "mpfr",     "big",
    "BigFloat", "float",       "double",   "real",     "dble",      "f64",      "f32",
    "Float64",  "Float32",     "sympify",  "convert",  "parse",     "map",      "longdouble",
    "float64",  "Integer",     "Int",      "number",   "new",       "from",     "to_array",
    "BigInt",   "rational",    "fraction", "from_vec", "SVectorF",  "realtype", "sunrealtype",
    "array2d",  "static_cast", "from_f64", "squeeze"};

/// Methods behind an array, and what they do.
inline constexpr std::array<std::pair<std::string_view, call_does>, 15> methods{
    {{"T", call_does::transpose},
     {"transpose", call_does::transpose},
     {"reshape", call_does::by_rows},
     {"astype", call_does::keep},
     {"copy", call_does::keep},
     {"clone", call_does::keep},
     {"tolist", call_does::keep},
     {"to_vec", call_does::keep},
     {"to", call_does::keep},
     {"eval", call_does::keep},
     {"flatten", call_does::keep},
     {"into", call_does::keep},
     {"map", call_does::keep},  // Rust: a conversion
     {"unwrap", call_does::keep},
     {"double", call_does::keep}}};

/// Whether a word only wraps numbers and arrays.
bool is_wrapper(std::string_view word);

/// What arguments with names say of the shape: "order='F'", "byrow=TRUE" and Fortran's "order=[2, 1]".
struct named_arguments {
    std::size_t stop;  ///< where they begin
    bool by_rows = false, by_columns = false;
};
named_arguments named_arguments_of(const std::vector<token>& tokens, std::size_t open);

/// The value of a call of a wrapper, or of one that `calls` lists. Throws not_understood for other arguments.
value wrapped_value(const std::string& name, std::vector<value> arguments);
value value_of_call(call_does does, const std::string& name, std::vector<value> arguments, std::size_t line);

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/program_calls-inl.hpp"
#endif
