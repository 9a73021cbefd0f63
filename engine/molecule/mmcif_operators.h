// Parses the operators of an mmCIF assembly: _pdbx_struct_assembly_gen.oper_expression. Not for the haptic thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/molecule/parsed_structure.h"

namespace moltact {

inline constexpr std::size_t kMaxOperators = 100'000, kMaxCopies = 1'000'000;

/// Operators by their ids.
using MmcifOperators = std::unordered_map<std::string, ParsedOperator>;

/// Parses a whole number without any other characters.
bool parseInteger(std::string_view word, int& value);

/// Expands an expression such as "1", "1,2", "(1-60)" or "(1-60)(61-88)", in which the last bracket acts first. Unknown
/// ids are ignored. An expression with more than kMaxCopies copies, or with too many brackets, gives a meaningless list
/// of kMaxCopies + 1 operators.
std::vector<ParsedOperator> operatorsOf(std::string_view expression, const MmcifOperators& known);

}  // namespace moltact
