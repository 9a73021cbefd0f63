// Selects German from a catalogue in the build while the object lives, and English afterwards.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>

#include "engine/language/catalogue.h"

namespace moltact {

struct InGerman {
  /// The German of tests/language/small_german.po, which is only a few texts.
  InGerman() : InGerman(MOLTACT_SMALL_GERMAN) {}
  explicit InGerman(const std::filesystem::path& folder) {
    const auto problem = setLanguage("de", folder);
    REQUIRE_MESSAGE(!problem, problem->text());
  }
  ~InGerman() { setLanguage("en", {}); }
  InGerman(const InGerman&) = delete;
  InGerman& operator=(const InGerman&) = delete;
};

}  // namespace moltact
