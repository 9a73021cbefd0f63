// Checks which keys of a lesson's scene a command offers as options of the same names.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/lesson/keys.h"
#include "tests/app/command_place.h"

namespace moltact::test {

/// Every key of a scene must be an option in the command's --help or be in `without`, with the reason. Every entry of
/// `without` must be a key and not an option.
inline void checkSceneKeysInHelp(const std::string& command, const std::map<std::string_view, const char*>& without) {
  const Run run = CommandPlace().run(command + " --help");
  REQUIRE(run.status == 0);
  const std::vector<KeySpec>& keys = keysOf(KeyBlock::Scene);
  for (const KeySpec& key : keys) {
    CAPTURE(std::string(key.name));
    const std::size_t at = run.out.find("--" + std::string(key.name));
    const bool there = at != std::string::npos &&
                       std::string_view(" ,\n[").find(run.out[at + 2 + key.name.size()]) != std::string_view::npos;
    CHECK(there != without.contains(key.name));
  }
  for (const auto& [name, why] : without) {
    CAPTURE(std::string(name));
    CHECK(std::any_of(keys.begin(), keys.end(), [&](const KeySpec& key) { return key.name == name; }));
  }
}

}  // namespace moltact::test
