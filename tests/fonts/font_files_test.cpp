#include "engine/fonts/font_files.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

using namespace moltact;
namespace fs = std::filesystem;

TEST_CASE(
    "a font beside the program's data takes precedence over the system's; one that is not there is the system's") {
  const fs::path home = fs::temp_directory_path() / ("moltact_fonts_" + std::to_string(getpid()));
  fs::create_directories(home / "fonts");
  std::ofstream(home / "fonts" / "Inter-Italic.otf") << "a font";
  const char* set = std::getenv("MOLTACT_HOME");
  const std::optional<std::string> before = set ? std::optional<std::string>(set) : std::nullopt;
  ::setenv("MOLTACT_HOME", home.c_str(), 1);
  CHECK(interFile("Inter-Italic.otf") == home / "fonts" / "Inter-Italic.otf");
  CHECK(interFile("Inter-Regular.otf") == "/usr/share/fonts/opentype/inter/Inter-Regular.otf");
  CHECK(dejaVuFile() == "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf");
  before ? ::setenv("MOLTACT_HOME", before->c_str(), 1) : ::unsetenv("MOLTACT_HOME");
  fs::remove_all(home);
}
