// Values of reading options other than their defaults, for tests of all options.
#pragma once

#include <string>
#include <variant>

#include "engine/molecule/molecule_key.h"

namespace moltact::test {

/// A text that readText accepts: the last of its words, "yes", or "7".
inline std::string otherThanDefault(const ReadingOption& option) {
  if (option.words) return std::string(option.words().back().name);
  return std::holds_alternative<bool ReadOptions::*>(option.member) ? "yes" : "7";
}

}  // namespace moltact::test
