// docs/data-protection.md against the code: every folder, storage and value that the program names stands there.
#include <doctest/doctest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/core/source_tree.h"

using moltact::test::kSource;
using moltact::test::textOf;

namespace {

const std::string& page() {
  static const std::string text = textOf(kSource / "docs/data-protection.md");
  return text;
}

void collect(const std::string& text, const char* what, std::set<std::string>& into) {
  const std::regex pattern(what);
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) into.insert((*it)[1]);
}

bool says(const std::string& part) { return page().find(part) != std::string::npos; }

const char* const kScripts[] = {"page.js", "platform.js", "cmi5.js", "classroom.js", "devices.js", "simulation.js"};

}  // namespace

TEST_CASE("every name under which a script of the page stores something stands in docs/data-protection.md") {
  std::set<std::string> keys, storages;
  for (const char* script : kScripts) {
    const std::string text = textOf(kSource / "app/web" / script);
    collect(text, R"re(["`](moltact/[a-z]+))re", keys);
    collect(text, R"((localStorage|sessionStorage|indexedDB|document\.cookie|caches\.open))", storages);
  }
  keys.erase("moltact/molecules");  // a folder of the program's own files, in memory
  CHECK(keys.size() >= 8);
  for (const std::string& key : keys) CHECK_MESSAGE(says('`' + key), key);
  CHECK(storages == std::set<std::string>{"indexedDB", "localStorage", "sessionStorage"});
  for (const char* name : {"IndexedDB", "localStorage", "sessionStorage"}) CHECK(says(name));
}

TEST_CASE("every folder of the user that the program names stands in docs/data-protection.md") {
  std::set<std::string> folders;
  for (const char* room : {"app", "engine"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kSource / room)) {
      if (entry.path().extension() != ".cpp") continue;
      const std::string text = textOf(entry.path());
      if (text.find("userDataFolder()") != std::string::npos)
        collect(text, R"re((?:data|userDataFolder\(\)) / "([a-z]+)")re", folders);
    }
  folders.erase("moltact");
  CHECK(folders.size() >= 5);
  for (const std::string& folder : folders) CHECK_MESSAGE(says("`~/.local/share/moltact/" + folder + '`'), folder);
  for (const char* other : {"`~/.config/moltact/settings.json`", "`~/.cache/moltact`"}) CHECK(says(other));
}

TEST_CASE("every value of SCORM and verb of cmi5 that the page reads or writes stands in docs/data-protection.md") {
  const std::string scorm = textOf(kSource / "app/web/platform.js"), cmi5 = textOf(kSource / "app/web/cmi5.js");
  std::set<std::string> values, verbs, states;
  collect(scorm, R"re(["`](cmi\.[a-z_]+(?:\.[a-z_]+)?))re", values);
  CHECK(values.size() > 15);
  for (std::string value : values) {
    // Parts of a list or a score stand there by the list's name.
    for (const char* list : {"cmi.objectives", "cmi.interactions"})
      if (value.starts_with(list)) value = list;
    CHECK_MESSAGE(says('`' + value), value);
  }
  collect(cmi5, R"re((?:defined|statement)\("([a-z]+)")re", verbs);
  collect(cmi5, R"re(record\.score >= mastery \? "([a-z]+)")re", verbs);
  CHECK(verbs.size() >= 7);
  for (const std::string& verb : verbs) CHECK_MESSAGE(says('`' + verb + '`'), verb);
  CHECK(says("`failed`"));
  collect(cmi5, R"re(this\.state\("([A-Za-z.]+)"\))re", states);
  CHECK(states == std::set<std::string>{"LMS.LaunchData"});
  CHECK(scorm.find("learner_name") == std::string::npos);
  CHECK(scorm.find("student_name") == std::string::npos);
}

TEST_CASE("the page sends and fetches in the five places that docs/data-protection.md describes, and nowhere else") {
  for (const char* script : kScripts) {
    const std::string text = textOf(kSource / "app/web" / script);
    const std::regex call(R"(\bfetch\(|XMLHttpRequest|sendBeacon|WebSocket|EventSource)");
    const auto calls = std::distance(std::sregex_iterator(text.begin(), text.end(), call), std::sregex_iterator());
    const std::string name = script;
    if (name == "classroom.js") {
      std::set<std::string> places;
      collect(text, R"re(\b(?:post|ask)\("([a-z]+)")re", places);
      CHECK(places == std::set<std::string>{"join", "lines", "scene"});
      CHECK(says("small pictures of it"));
      CHECK(says("keeps the latest in memory"));
    }
    CHECK_MESSAGE(calls == (name == "cmi5.js" || name == "page.js" ? 2 : name == "classroom.js" ? 1 : 0), name);
  }
}
