// What a way of reading can be besides its default, for tests that go over all.
#pragma once

#include <string>
#include <variant>

#include "engine/molecule/molecule_key.h"

namespace moltact::test {

/// A text that readText takes: the last of its words, or "yes", or "7".
inline std::string otherThanDefault(const ReadingOption& option) {
  if (option.words) return std::string(option.words().back().name);
  return std::holds_alternative<bool ReadOptions::*>(option.member) ? "yes" : "7";
}

}  // namespace moltact::test
