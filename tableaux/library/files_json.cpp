// SPDX-License-Identifier: BSL-1.0
// Reading and writing files.
#include "stagecraft/tableaux/json_document-inl.hpp"
#include "stagecraft/tableaux/program_text-inl.hpp"
#include "stagecraft/tableaux/read-inl.hpp"
#include "stagecraft/tableaux/read_partitioned-inl.hpp"
#include "stagecraft/tableaux/stage_forms-inl.hpp"
#include "stagecraft/tableaux/tableau_json-inl.hpp"
