// The source files of this checkout, for tests of coding rules.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace moltact::test {

inline const std::filesystem::path kSource = MOLTACT_SOURCE_DIR;

inline std::string textOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  REQUIRE_MESSAGE(in, file.string());
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace moltact::test
