// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>
#include "stagecraft/tableaux/program_tokens.hpp"

namespace stagecraft::tableaux::program_text {

/// Whether numbers and hardly anything else stand in the brackets that open at `open`, two of them or more; but no index
/// and no sizes. Constant time.
class number_brackets {
  public:
    explicit number_brackets(const std::vector<token>& tokens);
    bool at(std::size_t open) const;

  private:
    const std::vector<token>& tokens_;
    std::vector<std::size_t> numbers_, fractions_, words_, others_;  ///< how many stand before each token
};

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/number_brackets-inl.hpp"
#endif
