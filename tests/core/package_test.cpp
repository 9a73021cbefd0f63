// What package/linux tells the system of the program, held against the program's sources: which devices a person may
// open, which files it opens.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;
const fs::path kSource = MOLTACT_SOURCE_DIR;

std::string textOf(const fs::path& file) {
  std::ifstream in(file);
  REQUIRE_MESSAGE(in, file.string());
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

// What the first group matches, in all of the text.
std::set<std::string> allOf(const std::string& text, const char* what) {
  const std::regex pattern(what);
  std::set<std::string> out;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) out.insert((*it)[1]);
  return out;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  return text;
}

}  // namespace

TEST_CASE("every vendor and product that a HID driver takes for its own has a udev rule, and no rule names others") {
  std::set<std::string> known;
  for (const auto& entry : fs::directory_iterator(kSource / "engine/device/hid")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = textOf(entry.path());
    // The functions that judge an entry of the system's list: "bool isSpaceMouse(const HidEntry& entry) { … }".
    static const std::regex judge(R"(bool is\w+\(const HidEntry[^)]*\) \{[\s\S]*?(?:\n\}|; \})(?:  //[^\n]*)?\n)");
    for (std::sregex_iterator it(text.begin(), text.end(), judge), end; it != end; ++it)
      for (const std::string& id : allOf((*it).str(), "0x([0-9a-f]{4})")) known.insert(upper(id));
  }
  CHECK(known.size() >= 20);  // 4 vendors, 16 products of theirs
  std::set<std::string> allowed;
  const std::string rules = textOf(kSource / "package/linux/70-moltact.rules");
  for (const char* part : {R"(\*:([0-9A-F]{4}):)", R"(:([0-9A-F]{4})\.\*)"}) allowed.merge(allOf(rules, part));
  CHECK(known == allowed);
}

TEST_CASE(
    "every ending of a file that the window opens, but that of attempts, is one of a file type that the menu entry "
    "takes") {
  const std::string types = textOf(kSource / "package/linux/moltact.xml");
  const std::string entry = textOf(kSource / "package/linux/org.moltact.Moltact.desktop");
  std::set<std::string> globs;
  static const std::regex type(R"re(<mime-type type="([^"]+)">[\s\S]*?</mime-type>)re");
  for (std::sregex_iterator it(types.begin(), types.end(), type), end; it != end; ++it) {
    CAPTURE((*it)[1].str());
    CHECK(entry.find((*it)[1].str() + ";") != std::string::npos);
    globs.merge(allOf((*it).str(), R"re(pattern="\*([^"]+)")re"));
  }
  // Attempts end in .jsonl, which is the name of a format and not theirs.
  std::set<std::string> opened{".md"};
  opened.merge(allOf(textOf(kSource / "engine/pack/pack_file.h"), R"re(kPackEnding = "([^"]+)")re"));
  opened.merge(allOf(textOf(kSource / "app/ui/files/file_kinds.h"), R"re(kRecordingEnding = "([^"]+)")re"));
  opened.merge(allOf(textOf(kSource / "engine/molecule/reader.cpp"), R"re(X\("(\.[a-z]+)", read)re"));
  CHECK(opened.size() >= 8);
  CHECK(globs == opened);
}
