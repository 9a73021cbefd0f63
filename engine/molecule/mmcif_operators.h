// The operators of an assembly as mmCIF writes them: _pdbx_struct_assembly_gen.oper_expression. Not for the haptic thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/molecule/parsed_structure.h"

namespace moltact {

inline constexpr std::size_t kMaxOperators = 100'000, kMaxCopies = 1'000'000;

/// By their ids.
using MmcifOperators = std::unordered_map<std::string, ParsedOperator>;

/// A whole number and nothing else.
bool parseInteger(std::string_view word, int& value);

/// The operators of an expression such as "1", "1,2", "(1-60)" or "(1-60)(61-88)", where the last bracket acts first.
/// Ids that are not known are passed over. Of an expression with more than kMaxCopies in all, or with too many brackets,
/// the result has kMaxCopies + 1 operators and means nothing.
std::vector<ParsedOperator> operatorsOf(std::string_view expression, const MmcifOperators& known);

}  // namespace moltact
