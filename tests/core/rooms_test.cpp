// Compares the rooms in docs/architecture.md with the sources' includes and the linked libraries of the engine.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/core/source_tree.h"

namespace {

namespace fs = std::filesystem;
using moltact::test::kSource;
using moltact::test::textOf;

struct Room {
  std::string name;  // "engine/servo"
  std::set<std::string> uses;
  bool uses_all = false;  // every room below it
};

std::vector<std::string> quotedIn(const std::string& text, const std::regex& what) {
  std::vector<std::string> out;
  for (std::sregex_iterator it(text.begin(), text.end(), what), end; it != end; ++it) out.push_back((*it)[1]);
  return out;
}

// The rows "| `room` | `used`, `used` | what it is |" of the page, from the highest room to the lowest.
std::vector<Room> roomsOfPage() {
  static const std::regex row(R"(^\| `((?:app|engine)[a-z_/]*)` \| ([^|]*) \|)"), name("`([a-z_/]+)`");
  std::vector<Room> out;
  std::istringstream page(textOf(kSource / "docs/architecture.md"));
  for (std::string line; std::getline(page, line);) {
    std::smatch m;
    if (!std::regex_search(line, m, row)) continue;
    const std::vector<std::string> uses = quotedIn(m[2], name);
    out.push_back({m[1], {uses.begin(), uses.end()}, m[2] == "all below"});
  }
  return out;
}

// The room of a file such as "engine/servo/servo_loop.h": the longest one that is a prefix of its path.
std::string roomOf(const std::vector<Room>& rooms, const std::string& file) {
  std::string best;
  for (const Room& r : rooms)
    if (file.starts_with(r.name + "/") && r.name.size() > best.size()) best = r.name;
  return best;
}

std::vector<std::string> sourcesIn(const char* top) {
  std::vector<std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(kSource / top)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".h" || ending == ".cpp") out.push_back(fs::relative(entry.path(), kSource).generic_string());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<std::string> includesOf(const std::string& file) {
  static const std::regex include(R"re(#\s*include\s+"((?:app|engine)/[^"]+)")re");
  return quotedIn(textOf(kSource / file), include);
}

// The engine's libraries as its CMakeLists.txt makes them.
struct Libraries {
  std::map<std::string, std::string> of_file;          // "engine/servo/servo_loop.cpp": "moltact_servo"
  std::map<std::string, std::set<std::string>> links;  // directly

  Libraries() {
    const std::string text = textOf(kSource / "engine/CMakeLists.txt");
    static const std::regex add(R"(add_library\((moltact_\w+) STATIC([^)]*)\))"),
        link(R"(target_link_libraries\((moltact_\w+)([^)]*)\))"), cpp(R"(([\w/]+\.cpp))"), library(R"((moltact_\w+))");
    for (std::sregex_iterator it(text.begin(), text.end(), add), end; it != end; ++it)
      for (const std::string& file : quotedIn((*it)[2], cpp)) of_file["engine/" + file] = (*it)[1];
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it)
      for (const std::string& other : quotedIn((*it)[2], library)) links[(*it)[1]].insert(other);
  }
  std::set<std::string> reached(const std::string& library) const {
    std::set<std::string> out{library};
    std::vector<std::string> next{library};
    while (!next.empty()) {
      const std::string now = next.back();
      next.pop_back();
      if (const auto found = links.find(now); found != links.end())
        for (const std::string& other : found->second)
          if (out.insert(other).second) next.push_back(other);
    }
    return out;
  }
};

// The .cpp files that a CMakeLists.txt compiles several at a time, by target.
std::map<std::string, std::vector<std::string>> compiledTogether(const std::string& folder) {
  static const std::regex light(R"(moltact_light\((\w+) \d+\))"),
      add(R"(add_(?:library|executable)\((moltact\w*)([^)]*)\))"), cpp(R"(([\w/]+\.cpp))");
  const std::string text = textOf(kSource / folder / "CMakeLists.txt");
  std::map<std::string, std::vector<std::string>> out;
  for (const std::string& target : quotedIn(text, light)) out[target];
  for (std::sregex_iterator it(text.begin(), text.end(), add), end; it != end; ++it)
    if (const auto found = out.find((*it)[1]); found != out.end())
      for (const std::string& file : quotedIn((*it)[2], cpp)) found->second.push_back(folder + "/" + file);
  return out;
}

}  // namespace

TEST_CASE("no room includes from a room above it, nor from one that docs/architecture.md does not let it use") {
  const std::vector<Room> rooms = roomsOfPage();
  REQUIRE(rooms.size() >= 20);
  const auto place = [&](const std::string& name) {
    return std::find_if(rooms.begin(), rooms.end(), [&](const Room& r) { return r.name == name; }) - rooms.begin();
  };
  for (const Room& r : rooms)
    for (const std::string& used : r.uses) {
      CAPTURE(r.name);
      CAPTURE(used);
      CHECK(place(used) > place(r.name));
      CHECK(place(used) < std::ptrdiff_t(rooms.size()));
    }
  std::size_t includes = 0;
  std::map<std::string, std::set<std::string>> really_used;
  for (const char* top : {"engine", "app"})
    for (const std::string& file : sourcesIn(top)) {
      const std::string here = roomOf(rooms, file);
      CHECK_MESSAGE(!here.empty(), file, " stands in no room of docs/architecture.md");
      if (here.empty()) continue;
      const Room& room = rooms[std::size_t(place(here))];
      for (const std::string& included : includesOf(file)) {
        ++includes;
        const std::string there = roomOf(rooms, included);
        if (there == here) continue;
        really_used[here].insert(there);
        CHECK_MESSAGE(place(there) > place(here), file, " includes ", included, ", which stands above it");
        CHECK_MESSAGE((room.uses_all || room.uses.contains(there)), file, " includes ", included, ", but ", here,
                      " does not use ", there, " by docs/architecture.md");
      }
    }
  CHECK(includes > 1000);
  // What the page lets a room use is used.
  for (const Room& r : rooms)
    for (const std::string& used : r.uses) CHECK_MESSAGE(really_used[r.name].contains(used), r.name, ": ", used);
}

TEST_CASE("the picture of docs/architecture.md shows every room of its table, in that order, and no other") {
  static const std::regex title(R"(<g><title>([a-z_/]+)</title>)");
  std::vector<std::string> of_page;
  for (const Room& r : roomsOfPage()) of_page.push_back(r.name);
  CHECK(quotedIn(textOf(kSource / "docs/pictures/architecture.svg"), title) == of_page);
}

TEST_CASE("above the bench, references that judge a method are created by makeInteraction like the method itself") {
  static const std::regex tracker(R"((?:referenceMethod\(\)\.|\bmethod(?:\(\))?(?:\.|->)|\bm\.)make\()");
  std::size_t looked_at = 0;
  for (const char* top : {"engine", "app"})
    for (const std::string& file : sourcesIn(top)) {
      if (file.starts_with("engine/haptics/") || file.starts_with("engine/bench/")) continue;
      ++looked_at;
      CHECK_MESSAGE(!std::regex_search(textOf(kSource / file), tracker), file);
    }
  CHECK(looked_at > 300);
}

TEST_CASE("a library of the engine links what its files include, directly or through what it links") {
  const std::vector<Room> rooms = roomsOfPage();
  const Libraries libraries;
  REQUIRE(libraries.of_file.size() > 100);
  std::map<std::string, std::set<std::string>> of_room;
  for (const auto& [file, library] : libraries.of_file) of_room[roomOf(rooms, file)].insert(library);
  for (const auto& [file, library] : libraries.of_file) {
    const std::set<std::string> reached = libraries.reached(library);
    std::vector<std::string> includes = includesOf(file);
    if (const fs::path header = fs::path(file).replace_extension(".h"); fs::exists(kSource / header))
      for (std::string& more : includesOf(header.generic_string())) includes.push_back(std::move(more));
    for (const std::string& included : includes) {
      const std::set<std::string>& there = of_room[roomOf(rooms, included)];
      const bool linked = there.empty() || std::any_of(there.begin(), there.end(),
                                                       [&](const std::string& l) { return reached.contains(l); });
      CHECK_MESSAGE(linked, file, " includes ", included, ", but ", library, " links none of its room's libraries");
    }
  }
}

TEST_CASE("the engine never sees ImGui, and no haptic method uses the inside of another") {
  static const std::regex imgui(R"re(#\s*include\s+[<"]imgui)re"), method(R"(^engine/haptics/([a-z_]+)/)");
  for (const std::string& file : sourcesIn("engine")) {
    CHECK_MESSAGE(!std::regex_search(textOf(kSource / file), imgui), file);
    std::smatch own, other;
    if (!std::regex_search(file, own, method)) continue;
    for (const std::string& included : includesOf(file))
      if (std::regex_search(included, other, method)) CHECK_MESSAGE(own[1] == other[1], file, " includes ", included);
  }
}

TEST_CASE("all of app uses imgui_versions.h and key_focus.h for what differs between versions of ImGui") {
  static const std::regex differs("IMGUI_VERSION_NUM|SetKeyboardFocusHere *\\(|ImGui::ActivateItem");
  for (const std::string& file : sourcesIn("app"))
    if (!file.starts_with("app/ui/widgets/imgui_versions."))
      CHECK_MESSAGE(!std::regex_search(textOf(kSource / file), differs), file);
}

TEST_CASE("sources that are compiled together have no constant and no type of their own by the same name") {
  static const std::regex own(
      R"((?:^|\n)(?:(?:static |inline )?constexpr [^=({;\n]*?|struct |class |enum class )(\w+)(?:\[\])?(?: final)?(?: = |\{| \{| : ))");
  std::size_t files = 0, names = 0;
  for (const char* folder : {"engine", "app", "app/ui"})
    for (const auto& [target, sources] : compiledTogether(folder)) {
      std::map<std::string, std::string> first;
      CHECK_MESSAGE(!sources.empty(), target);
      for (const std::string& file : sources) {
        ++files;
        for (const std::string& name : quotedIn(textOf(kSource / file), own)) {
          ++names;
          const auto [at, is_new] = first.emplace(name, file);
          CHECK_MESSAGE(is_new, target, ": ", name, " in ", at->second, " and ", file);
        }
      }
    }
  CHECK(files > 150);
  CHECK(names > 200);
}

TEST_CASE("only background.h starts background work, and its threads have a signal stack") {
  for (const char* folder : {"engine", "app"})
    for (const std::string& file : sourcesIn(folder))
      if (file != "engine/platform/background.h")
        CHECK_MESSAGE(textOf(kSource / file).find("std::async(") == std::string::npos, file);
}
