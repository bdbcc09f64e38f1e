// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>
#include "stagecraft/tableaux/program_groups.hpp"

namespace stagecraft::tableaux::program_text {

/// Lists in `unused` of a program's groups what looks like a coefficient or a claim and is in none of them.
class leftovers {
  public:
    /// `taken` are the variables that groups use.
    leftovers(const variables& v, const std::set<std::size_t>& taken, groups& out);
    void tell();

  private:
    const variable& at(std::size_t k) const { return v_.all[k]; }
    bool is_array(std::size_t k) const { return at(k).is == variable::kind::array; }
    bool is_claim_left(std::size_t k) const;
    bool has_elements(const variable& x) const;
    static std::vector<std::pair<std::size_t, std::string>> numbers_of(const variable& x);
    static bool looks_like_coefficients(const variable& x);

    const variables& v_;
    const std::set<std::size_t>& taken_;
    groups& out_;
    std::set<std::pair<std::size_t, std::string>> with_b_;  ///< scopes and owners of arrays b
    std::set<std::vector<std::pair<std::size_t, std::string>>>
        used_;  ///< lines and texts of the numbers of arrays in use
};

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/program_leftovers-inl.hpp"
#endif
