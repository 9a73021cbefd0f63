// Compares package/linux with the program's sources: the devices that a user may open, and the files that the program
// opens.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/core/source_tree.h"

namespace {

namespace fs = std::filesystem;
using moltact::test::kSource;
using moltact::test::textOf;

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

struct HidSource {
  std::string text;
  std::set<std::string> judges;  // what its kinds of device are known by: "isSpaceMouse"
  std::string judged_by;         // the bodies of the functions that judge an entry of the system's list
};

// The sources of engine/device/hid that have a kind of device.
std::vector<HidSource> hidSources() {
  std::vector<HidSource> out;
  for (const auto& entry : fs::directory_iterator(kSource / "engine/device/hid")) {
    if (entry.path().extension() != ".cpp") continue;
    HidSource one{.text = textOf(entry.path()), .judges = {}, .judged_by = {}};
    const std::set<std::string> kinds = allOf(one.text, R"re(\bHidKind \w+\{([^,]*,\s*\S+?),)re");
    if (kinds.empty()) continue;
    CAPTURE(entry.path().string());
    for (const std::string& kind : kinds) one.judges.insert(kind.substr(kind.find_last_of(" \n") + 1));
    // "bool isSpaceMouse(const HidEntry& entry) { … }", and what these call.
    static const std::regex judge(R"(bool (\w+)\(const HidEntry[^)]*\) \{[\s\S]*?(?:\n\}|; \})(?:  //[^\n]*)?\n)");
    std::set<std::string> found;
    for (std::sregex_iterator it(one.text.begin(), one.text.end(), judge), end; it != end; ++it) {
      found.insert((*it)[1]);
      one.judged_by += (*it).str();
    }
    for (const std::string& name : one.judges) {
      CAPTURE(name);
      CHECK_MESSAGE(found.contains(name), "a kind is known by a function 'bool name(const HidEntry&)' of its own file");
    }
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace

TEST_CASE("every vendor and product that a HID driver takes for its own has a udev rule, and no rule names others") {
  std::set<std::string> known;
  for (const HidSource& source : hidSources())
    for (const std::string& id : allOf(source.judged_by, "0x([0-9a-f]{4})")) known.insert(upper(id));
  CHECK(known.size() >= 20);  // 4 vendors, 16 products of theirs
  std::set<std::string> allowed;
  const std::string rules = textOf(kSource / "package/linux/70-moltact.rules");
  for (const char* part : {R"(\*:([0-9A-F]{4}):)", R"(:([0-9A-F]{4})\.\*)"}) allowed.merge(allOf(rules, part));
  CHECK(known == allowed);
}

TEST_CASE("the browser edition asks for the vendors of the HID drivers that it has, and for no others") {
  const std::string drivers = textOf(kSource / "engine/device/drivers.cpp");
  const std::string in_browser = drivers.substr(0, drivers.find("#else"));
  std::set<std::string> wanted;
  int of_the_browser = 0;
  for (const std::string& name : allOf(in_browser, R"(X\((\w+)\) )"))
    for (const HidSource& source : hidSources()) {
      if (source.text.find("DeviceDriver k" + name + "Driver") == std::string::npos) continue;
      ++of_the_browser;
      wanted.merge(allOf(source.judged_by, R"(vendor == (0x[0-9a-f]{4}))"));
    }
  CHECK(of_the_browser == 2);
  CHECK(wanted.size() == 2);
  const std::string page = textOf(kSource / "app/web/devices.js");
  CHECK(wanted == allOf(page, R"(vendorId: (0x[0-9a-f]{4}))"));
}

TEST_CASE(
    "every ending of a file that the window opens, but those of attempts and trajectories, is one of a file type that "
    "the menu entry takes") {
  const std::string types = textOf(kSource / "package/linux/moltact.xml");
  const std::string entry = textOf(kSource / "package/linux/org.moltact.Moltact.desktop");
  std::set<std::string> globs;
  static const std::regex type(R"re(<mime-type type="([^"]+)">[\s\S]*?</mime-type>)re");
  for (std::sregex_iterator it(types.begin(), types.end(), type), end; it != end; ++it) {
    CAPTURE((*it)[1].str());
    CHECK(entry.find((*it)[1].str() + ";") != std::string::npos);
    globs.merge(allOf((*it).str(), R"re(pattern="\*([^"]+)")re"));
  }
  // Attempts end in .jsonl, which is the name of a format and not theirs; a trajectory needs its molecule beside it.
  std::set<std::string> opened{".md"};
  opened.merge(allOf(textOf(kSource / "engine/pack/pack_file.h"), R"re(kPackEnding = "([^"]+)")re"));
  opened.merge(allOf(textOf(kSource / "app/ui/files/file_kinds.h"), R"re(kRecordingEnding = "([^"]+)")re"));
  opened.merge(allOf(textOf(kSource / "engine/molecule/reader.cpp"), R"re(X\("(\.[a-z0-9]+)", read)re"));
  CHECK(opened.size() >= 8);
  CHECK(globs == opened);
}

TEST_CASE("README.md, molecules/README.md and the metainfo name the format of every ending of a molecule's file") {
  const std::set<std::string> endings =
      allOf(textOf(kSource / "engine/molecule/reader.cpp"), R"re(X\("\.([a-z0-9]+)", read)re");
  REQUIRE(endings.size() >= 11);
  // Each line of the metainfo is one language.
  std::vector<std::string> lists{textOf(kSource / "README.md"), textOf(kSource / "molecules/README.md")};
  for (const std::string& line :
       allOf(textOf(kSource / "package/linux/org.moltact.Moltact.metainfo.xml.in"), R"re((<li[^\n]*mmCIF[^\n]*))re"))
    lists.push_back(line);
  CHECK(lists.size() == 4);
  for (const std::string& list : lists) {
    CAPTURE(list.substr(0, 80));
    for (const std::string& ending : endings) {
      CAPTURE(ending);
      const std::string name = ending == "ent" ? "PDB" : upper(ending);  // another ending of the same files
      CHECK(std::regex_search(upper(list), std::regex("(^|[^A-Z0-9])" + name + "($|[^A-Z0-9])")));
    }
  }
}
