// Compares docs/pages.md and the scripts that draw its pictures with the existing files.
#include <doctest/doctest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/core/source_tree.h"

using moltact::test::kSource;
using moltact::test::textOf;

namespace {

std::set<std::string> pagesAllOf(const std::string& text, const char* what) {
  const std::regex pattern(what);
  std::set<std::string> out;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) out.insert((*it)[1]);
  return out;
}

}  // namespace

TEST_CASE("every picture that docs/pages.md shows is there") {
  const std::set<std::string> pictures =
      pagesAllOf(textOf(kSource / "docs/pages.md"), R"(\(pictures/([a-z0-9-]+)\.png\))");
  CHECK(pictures.size() > 20);
  for (const std::string& picture : pictures)
    CHECK_MESSAGE(std::filesystem::exists(kSource / "docs/pictures" / (picture + ".png")), picture);
}

TEST_CASE("every picture of docs/pages.md but the class's report is drawn by a script of docs/pictures") {
  std::string scripts;
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "docs/pictures"))
    if (const auto ending = entry.path().extension(); ending == ".script" || ending == ".sh")
      scripts += textOf(entry.path());
  for (const std::string& picture :
       pagesAllOf(textOf(kSource / "docs/pages.md"), R"(\(pictures/([a-z0-9-]+)\.png\))")) {
    // Those of the three themes are drawn by one script with THEME in their place.
    const std::string themed = std::regex_replace(picture, std::regex("(light|dark|high-contrast)$"), "THEME");
    CHECK_MESSAGE((scripts.find("/" + picture + ".png") != std::string::npos ||
                   scripts.find("/" + themed + ".png") != std::string::npos),
                  picture);
  }
}
