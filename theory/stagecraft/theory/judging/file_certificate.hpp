// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stagecraft/tableaux/tableau_json.hpp>
#include <stagecraft/theory/judging/error_metrics.hpp>
#include <stagecraft/theory/judging/principal_error.hpp>
#include <stagecraft/theory/judging/spectrum_json.hpp>
#include <stagecraft/theory/judging/verdict_json.hpp>
#include <stagecraft/theory/statements/verdict.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// The order that the conditions have but for small residuals.
struct numerical_order {
    int order = 0;
    std::string residual;  ///< the largest
    int digits = 0;        ///< decimals to which everything agrees
};

/// "order 5 up to 1.3e-26, what rounding to 26 digits explains".
std::string in_words(const numerical_order& n);

/// What to try where entries may be off by more than they are taken to be.
inline constexpr const char* larger_errors =
    "for entries that were computed, --ulps or --tolerance allows more";

/// What the checker found of one statement on a tableau file. `truth` is the verdict on the statement itself,
/// `judgement` the one on the claim, which is the negation where the file claims that it does not hold; empty
/// where nothing is claimed.
struct finding {
    std::string name;
    std::optional<std::string> claimed;  ///< as JSON: "5", "true"
    std::optional<int> value;  ///< for orders: the true one, for rounded data the largest not refuted
    std::optional<verdict> truth;
    std::optional<verdict> judgement;
    std::optional<numerical_order> numerical;  ///< for orders, where it exceeds the exact one
    /// For orders of data known by enclosures: the largest bound in parts of the 1/gamma (stage order: of the
    /// right-hand side) of its condition; from 1/10 the claim is inconclusive.
    std::string relative_bound;
};

/// A condition that fails.
struct failure {
    std::string condition;  ///< "dot(b, c*c*(A*c)) == 1/15", "A[3][1] + ... = c[3]"
    std::string tree;       ///< bracket notation, empty for row sums and simplifying conditions
    std::string residual;
    std::string in_words;  ///< the residual, shortened
};

/// A single entry whose change alone restores every claim.
struct suspect {
    std::string entry;    ///< "A[6][3]", counted from 1
    std::string written;  ///< what the file has there
    std::string suggest;  ///< the repaired value; exact unless the data leave it uncertain
};

/// The member of the known families next to rounded data.
struct nearest_family {
    std::string family;
    int stages = 0;
    std::string error;  ///< largest deviation over all entries, in units of the last digit given
    std::string entry;  ///< where it occurs
};

/// Exact or rounded data that the claims refute as they are written, and keep as what they are meant for.
struct taken_as {
    std::string what;        ///< "quotients of 13 digits", "doubles computed to 4 units in the last place"
    std::string residual;    ///< the largest of the orders
    std::string resolution;  ///< a larger change of one entry shows, but of those that no claim sees
};

/// The outcome for a tableau file.
struct file_certificate {
    std::string name;
    std::string source;
    std::string data;  ///< name of the tableaux::number_kind
    int stages = 0;
    std::vector<finding> findings;
    std::optional<theory::principal_error> principal_error;
    std::optional<theory::error_metrics> error_metrics;  ///< of an embedded pair
    std::vector<failure> failures;
    std::vector<suspect> suspects;
    std::string suspects_note;
    std::vector<std::string> notes;  ///< how the file was read, and what is remarkable
    std::optional<nearest_family> nearest;
    std::optional<theory::taken_as> taken_as;
    theory::spectra spectra;
    tableaux::tableau_file file;             ///< what was judged, where it is a single tableau
    nlohmann::ordered_json tableau;          ///< what was judged, as JSON that the command reads
    std::vector<file_certificate> partners;  ///< of a method of several tableaux, each for itself

    /// Refuted where any claim is, else inconclusive where any is, proved where all are, consistent otherwise.
    standing overall() const;
    /// Whether there was nothing to judge.
    bool nothing_claimed() const;
    /// The verdict in words: name(overall()), or that nothing was claimed.
    std::string verdict() const;
    /// The same with how the data were taken: "consistent up to 1.7e-26 (quotients of 13 digits)".
    std::string verdict_in_words() const;
    /// 0 nothing claimed is refuted, 1 something is, 3 something could not be tested (2 is unusable input).
    int exit_code() const;

    const finding* find(std::string_view finding_name) const;
};

/// The certificate as JSON: name, source, data, stages, verdict; one object for each finding with `value` for
/// orders, `verdict` on the statement (for orders: on the one claimed), `claimed` and the verdict `claim` on
/// that; eigenvalues of A, poles of R and spectrum_note; failures, suspects and nearest; the tableau as it was
/// read, so that this JSON is a tableau file as well.
nlohmann::ordered_json to_json(const file_certificate& c);

/// to_json, written out; what is not UTF-8 in a name is replaced.
std::string json_text(const file_certificate& c);

/// The certificate for a reader, several lines.
std::string to_text(const file_certificate& c);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/file_certificate-inl.hpp"
#endif
