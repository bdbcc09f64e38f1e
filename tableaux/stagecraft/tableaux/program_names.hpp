// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The words by which programs name a tableau's parts. A dialect that is not yet read is a line here.

namespace stagecraft::tableaux::program_text {

/// A library's names of the arrays of one tableau; without one for b it is the last row of A. Blanks separate the names for
/// the same array, the likelier first. Arrays belong to one tableau where what stands before and behind these words is the
/// same: "heun_A" and "heun_b", "At" and "bt".
struct dialect {
    std::string_view A, b, c, embedded;
    std::string_view diagonal{};    ///< of A, where it has an array of its own
    std::size_t embedded_from = 0;  ///< how many numbers stand before the first embedded weight
    bool needs_embedded = false;    ///< the words mean this only beside embedded weights
    bool nested = false;            ///< the words mean other things too: A is written in rows
};

inline constexpr std::string_view embedded_words =
    "b_embedded b_embed bembed b_emb b_hat bhat b_tilde btilde b_star bstar b_alt b_low b_error b_err berr "
    "b_diff "
    "db b2 bh bt b\xCC\x82 b\xCC\x83 E e d";

inline constexpr std::array<dialect, 15> dialects{{
    {"a", "c", "b", "c_prime", {}, 0, true},  // Octave
    {"A a", "b B", "c C", embedded_words},
    {"A a", "\xCE\xB1", "c",
     "\xCE\xB1"
     "EEst \xCE\xB1_EEst"},                              // Julia: DiffEqDevTools
    {"A a", "alpha", "c", "alphaEEst alpha_embedded"},   // the same in ASCII
    {"beta", "c_sol", "alpha", "c_error"},               // torchdiffeq
    {"a_lower", "b_sol", "c", "b_error", "a_diagonal"},  // diffrax
    {"A a", "b_sol w weights", "c nodes", embedded_words},
    {"matrix", "weights", "nodes abscissae", "embedded_weights weights_embedded"},
    {"alpha", "b beta", "c gamma", "b_hat bhat", {}, 0, false, true},
    {"B", "C_sol", "A", "C_err"},            // torchdiffeq, Prince-Dormand
    {"b", "c", "ah", "ec", {}, 1, true},     // GSL
    {"b", "Abar", "ah", "A", {}, 0, true},   // GSL, Prince-Dormand
    {"b", "c", "a", "e d"},                  // Fehlberg's letters
    {"BT", "", "eval_stages", "TR"},         // PathSim
    {"a_exp a_imp", "", "c_exp c_imp", ""},  // ClimaTimeSteppers, where b is left out
}};

/// How programs write the dense output of a tableau: for each stage the coefficients of theta, theta^2, ..., or those of the highest
/// power first, or the weights at theta = 1/2 from which a polynomial of degree 4 is made.
struct dense_word {
    enum class written { ascending, descending, at_half };
    std::string_view words;
    written as;
};
inline constexpr std::array<dense_word, 3> dense_words{
    {{"b_theta P binterp", dense_word::written::ascending},  // SciPy
     {"eval_coeffs", dense_word::written::descending},       // diffrax: numpy's polyval, times theta
     {"c_mid mid C_mid", dense_word::written::at_half}}};    // diffrax, torchdiffeq

/// A claim of a tableau file, and what programs call it.
struct claim_word {
    std::string_view word, key;
};

/// In capital letters or not. `q` and `p` are claims only where a point or an arrow stands before them, `o` only by itself.
inline constexpr std::array<claim_word, 18> claim_words{{{"order", "order"},
                                                         {"embedded_order", "embedded_order"},
                                                         {"order_embedded", "embedded_order"},
                                                         {"embeddedorder", "embedded_order"},
                                                         {"adaptiveorder", "embedded_order"},
                                                         {"error_estimator_order", "embedded_order"},
                                                         {"stage_order", "stage_order"},
                                                         {"->q", "order"},
                                                         {"->p", "embedded_order"},
                                                         {"=o", "order"},  // RungeKutta.jl
                                                         {"A_stable", "A_stable"},
                                                         {"L_stable", "L_stable"},
                                                         {"algebraically_stable", "algebraically_stable"},
                                                         {"symplectic", "symplectic"},
                                                         {"symmetric", "symmetric"},
                                                         {"stiffly_accurate", "stiffly_accurate"},
                                                         {"name", "name"},
                                                         {"label", "name"}}};

inline constexpr std::size_t no_argument = static_cast<std::size_t>(-1);

/// A function that is called with the arrays of a tableau: which argument, from 0, is what. In place of b there may be NULL:
/// the last row of the array that the argument `last_row_of` names.
struct register_call {
    std::string_view function;
    std::size_t name, order;
    std::size_t A, b, c, embedded, last_row_of;
    std::string_view part{};                                  ///< of an additive method
    std::size_t dense = no_argument, or_dense = no_argument;  ///< in place of the former there may be NULL
};

inline constexpr std::array<register_call, 5> register_calls{
    {{"TSRKRegister", 0, 1, 3, 4, 5, 6, 3, {}, 8},
     {"TSDIRKRegister", 0, 1, 3, 4, 5, 6, 3, {}, 8},
     {"TSARKIMEXRegister", 0, 1, 6, 7, 8, 10, 3, " explicit", 13, 12},
     {"TSARKIMEXRegister", 0, 1, 3, 4, 5, 9, 3, " implicit", 12},
     {"ExplicitRKTableau", no_argument, 3, 0, 2, 1, no_argument, no_argument}}};

/// A word at the beginning of a line that opens a scope, and which word names it.
struct section_word {
    std::string_view word;
    enum class named { by_next_word, by_text, by_next_word_or_text } by = named::by_next_word;
};

inline constexpr std::array<section_word, 12> section_words{
    {{"class"},
     {"def"},
     {"function"},
     {"subroutine"},
     {"module"},
     {"fn"},
     {"case", section_word::named::by_next_word_or_text},
     {"default"},
     {"if", section_word::named::by_text},
     {"elif", section_word::named::by_text},
     {"elseif", section_word::named::by_text},
     {"else", section_word::named::by_text}}};

/// Words that may stand before them.
inline constexpr std::array<std::string_view, 7> section_modifiers{"pub",       "static", "export",   "pure",
                                                                   "recursive", "async",  "constexpr"};

/// No longer name is looked at for words within it.
inline constexpr std::size_t longest_name = 100;

/// The words of a list that blanks separate.
std::vector<std::string_view> words_of(std::string_view list);
/// Without capital letters.
std::string lower(std::string_view text);

/// The claim that a name makes, and what stands before and behind its word.
struct claim_name {
    std::string key, before, behind;
};

/// Of several words in it the longest.
std::optional<claim_name> claim_in(std::string_view name);

/// Whether an array of a tableau may have this name.
bool is_coefficient(std::string_view name);
/// How an array of this name writes dense output; nothing where it does not.
std::optional<dense_word::written> dense_as(std::string_view name);
/// What programs call the diagonal of A of diagonally implicit methods.
bool is_diagonal_word(std::string_view name);
/// a21, a_2_1, b3, c2, bhat1.
bool is_single_coefficient(std::string_view name);

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/program_names-inl.hpp"
#endif
