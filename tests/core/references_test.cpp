// References in comments and pages must exist: a file by its extension .h or .cpp, a member by its type and two colons,
// a name in backticks on a page. A rename that forgets a reference fails here.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/core/source_text.h"
#include "tests/core/source_tree.h"

namespace {

namespace fs = std::filesystem;
using namespace moltact::test;

std::string lineOf(const std::string& text, std::size_t at) {
  return std::to_string(1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
}

// Types of other libraries, whose members are unknown here.
const std::set<std::string> kForeignScopes{"std",   "glm",     "ImGui",
                                           "gemmi", "doctest", "moltact"};  // moltact::haptics is a target of CMake

struct Project {
  std::vector<std::string> files;            // "engine/core/units.h"
  std::map<std::string, std::string> texts;  // where names occur: comments, and whole pages
  Scopes scopes;
  std::set<std::string> words;  // of code and literals

  Project() {
    for (const char* top : {"app", "engine", "tests", "assets", "molecules", "docs"})
      for (const auto& entry : fs::recursive_directory_iterator(kSource / top)) {
        const std::string ending = entry.path().extension().string();
        if (ending == ".py" || ending == ".pyi")
          for (const std::string& token : tokensOf(textOf(entry.path())))
            if (isWord(token)) words.insert(token);
        if (ending != ".h" && ending != ".cpp") continue;
        const std::string file = fs::relative(entry.path(), kSource).generic_string();
        std::string source = textOf(entry.path());
        const Halves halves = halvesOf(source);
        files.push_back(file);
        texts[file] = halves.comments;
        scopes.read(halves.code);
        for (std::size_t k = 0; k < source.size(); ++k)
          if (halves.comments[k] != ' ') source[k] = halves.comments[k] == '\n' ? '\n' : ' ';
        for (const std::string& token : tokensOf(source))
          if (isWord(token)) words.insert(token);
      }
    for (const char* page : {"README.md", "CONTRIBUTING.md"}) texts[page] = textOf(kSource / page);
    for (const auto& entry : fs::directory_iterator(kSource / "docs"))
      if (entry.path().extension() == ".md") texts["docs/" + entry.path().filename().string()] = textOf(entry.path());
  }

  bool hasFile(const std::string& named) const {
    return std::any_of(files.begin(), files.end(),
                       [&](const std::string& file) { return file == named || file.ends_with("/" + named); });
  }
};

const Project& project() {
  static const Project all;
  return all;
}

// Each file that a text names, with where it does so: "servo/clutch.h", not "*_linux.cpp".
std::vector<std::pair<std::string, std::size_t>> filesNamedIn(const std::string& text) {
  std::vector<std::pair<std::string, std::size_t>> out;
  for (const std::string ending : {".h", ".cpp"})
    for (std::size_t at = text.find(ending); at != std::string::npos; at = text.find(ending, at + 1)) {
      if (at + ending.size() < text.size() && isWordPart(text[at + ending.size()])) continue;
      std::size_t from = at;
      while (from > 0 && (isWordPart(text[from - 1]) || text[from - 1] == '/' || text[from - 1] == '-')) --from;
      if (from == at || (from > 0 && (text[from - 1] == '*' || text[from - 1] == '.' || text[from - 1] == '<')))
        continue;
      out.emplace_back(text.substr(from, at + ending.size() - from), from);
    }
  return out;
}

// Each member that a text names by its type, with where it does so.
struct NamedMember {
  std::string scope, member;
  std::size_t at = 0;
};
std::vector<NamedMember> membersNamedIn(const std::string& text) {
  std::vector<NamedMember> out;
  for (std::size_t at = text.find("::"); at != std::string::npos; at = text.find("::", at + 1)) {
    std::size_t from = at, end = at + 2;
    while (from > 0 && isWordPart(text[from - 1])) --from;
    while (end < text.size() && isWordPart(text[end])) ++end;
    if (from < at && end > at + 2)
      out.push_back({text.substr(from, at - from), text.substr(at + 2, end - at - 2), from});
  }
  return out;
}

}  // namespace

TEST_CASE("what this test reads of a source: comments, types, their members and those of what they derive from") {
  const Halves halves = halvesOf(
      "// see Base::first\nstruct Base { int first; /* Base::second */ };\nclass Next final : public Base {\n"
      "  const char* text = \"// Base::third\"; char c = '\"'; void walk();\n};\nvoid Next::run() {}\n"
      "enum class Kind : int { One };\nnamespace outer::inner {}\n\ntemplate <class T> struct Box { T held; };\n");
  CHECK(halves.comments.find("Base::first") != std::string::npos);
  CHECK(halves.comments.find("Base::second") != std::string::npos);
  CHECK(halves.comments.find("third") == std::string::npos);
  Scopes scopes;
  scopes.read(halves.code);
  CHECK(scopes.has("Base", "first"));
  CHECK_FALSE(scopes.has("Base", "second"));
  CHECK(scopes.has("Next", "first"));
  CHECK(scopes.has("Next", "walk"));
  CHECK(scopes.has("Next", "run"));
  CHECK_FALSE(scopes.has("Base", "walk"));
  CHECK(scopes.has("Kind", "One"));
  CHECK(scopes.has("Box", "held"));
  CHECK(scopes.has("outer", "inner"));
  CHECK_FALSE(scopes.knows("T"));
  const auto files = filesNamedIn("in core/units.h, *_linux.cpp, <stdio.h>, page.html and scale.cpp.");
  REQUIRE(files.size() == 2);
  CHECK(files[0].first == "core/units.h");
  CHECK(files[1].first == "scale.cpp");
}

TEST_CASE("every file that a comment or a page names is there") {
  std::size_t named = 0;
  for (const auto& [where, text] : project().texts)
    for (const auto& [file, at] : filesNamedIn(text)) {
      ++named;
      CHECK_MESSAGE(project().hasFile(file), where, ":", lineOf(text, at), " names ", file, ", which is not there");
    }
  CHECK(named > 100);
}

TEST_CASE("every member that a comment or a page names as Type::member is there") {
  std::size_t named = 0;
  for (const auto& [where, text] : project().texts)
    for (const NamedMember& one : membersNamedIn(text)) {
      if (kForeignScopes.contains(one.scope)) continue;
      ++named;
      CHECK_MESSAGE(project().scopes.has(one.scope, one.member), where, ":", lineOf(text, one.at), " names ", one.scope,
                    "::", one.member, ", which is not there");
    }
  CHECK(named > 50);
}

TEST_CASE("every camelCase name that a page has in backticks, and every kConstant that it names, is in the code") {
  // The names of the styles themselves.
  const std::set<std::string> styles{"PascalCase", "camelCase", "kConstant"};
  const auto isCodeName = [](const std::string& word) {
    for (std::size_t k = 1; k < word.size(); ++k)
      if (std::islower(static_cast<unsigned char>(word[k - 1])) && std::isupper(static_cast<unsigned char>(word[k])))
        return true;
    return false;
  };
  std::size_t named = 0;
  for (const auto& [where, text] : project().texts) {
    if (!where.ends_with(".md")) continue;
    std::istringstream lines(text);
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      bool in_code = false;
      for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        while (end < line.size() && isWordPart(line[end])) ++end;
        const std::string word = line.substr(at, end - at);
        const bool constant = word.size() > 1 && word[0] == 'k' && std::isupper(static_cast<unsigned char>(word[1]));
        if (((in_code && isCodeName(word)) || constant) && !styles.contains(word)) {
          ++named;
          CHECK_MESSAGE(project().words.contains(word), where, ":", number, " names ", word,
                        ", which is not in the code");
        }
        if (end < line.size() && line[end] == '`') in_code = !in_code;
        at = end + 1;
      }
    }
  }
  CHECK(named > 100);
}

namespace {

// The files of the tree, but what is built and what git keeps.
std::vector<fs::path> filesOfTree() {
  std::vector<fs::path> out;
  for (fs::recursive_directory_iterator it(kSource), end; it != end; ++it) {
    const std::string name = it->path().filename().string();
    if (it->is_directory() && it.depth() == 0 && (name == "build" || name == ".git" || name == "shared"))
      it.disable_recursion_pending();
    else if (it->is_regular_file() && name != ".git")
      out.push_back(it->path());
  }
  return out;
}

// As a page's headings become anchors: small letters, a stroke for each blank, no punctuation.
std::string anchorOf(std::string_view heading) {
  std::string out;
  for (const char c : heading)
    if (c == ' ')
      out += '-';
    else if (isWordPart(c) || c == '-' || static_cast<unsigned char>(c) >= 0x80)
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::set<std::string> anchorsOf(const fs::path& page) {
  std::set<std::string> out;
  std::istringstream lines(textOf(page));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with('#'))
      out.insert(anchorOf(std::string_view(line).substr(std::min(line.find_first_not_of("# "), line.size()))));
  return out;
}

}  // namespace

TEST_CASE("no file of the tree holds the marks of a merge that was left half done") {
  std::size_t looked = 0;
  for (const fs::path& file : filesOfTree()) {
    std::ifstream in(file, std::ios::binary);
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
      ++number;
      for (const char sign : {'<', '>', '|'}) {
        const std::string mark(7, sign);
        CHECK_MESSAGE(!(line == mark || line.starts_with(mark + ' ')), fs::relative(file, kSource).generic_string(),
                      ":", number, " is a mark of a merge");
      }
    }
    ++looked;
  }
  CHECK(looked > 500);
}

TEST_CASE("every place that a page or a comment names as FILE:LINE is there") {
  const std::regex place(R"(([A-Za-z0-9_./-]+\.[a-z]+):([0-9]+))");
  std::map<std::string, std::vector<std::size_t>> lines;  // of each file's name, behind its last "/"
  for (const fs::path& file : filesOfTree())
    if (const std::string ending = file.extension().string(); ending == ".cpp" || ending == ".h" || ending == ".md") {
      const std::string text = textOf(file);
      lines[file.filename().string()].push_back(std::size_t(std::count(text.begin(), text.end(), '\n')) + 1);
    }
  for (const auto& [where, text] : project().texts)
    for (std::sregex_iterator it(text.begin(), text.end(), place), end; it != end; ++it) {
      const fs::path file = (*it)[1].str();
      // Examples may name the reader's own files; only files of the tree are examined.
      const auto known = lines.find(file.filename().string());
      if (known == lines.end()) continue;
      const std::size_t longest = *std::max_element(known->second.begin(), known->second.end());
      CHECK_MESSAGE(std::stoul((*it)[2]) <= longest, where, ":", lineOf(text, std::size_t(it->position())), " names ",
                    it->str(), ", which has fewer lines");
    }
}

TEST_CASE("every path of the tree that a page has in backticks is there, and every file and heading that it links to") {
  const std::set<std::string> tops{"app",       "engine", "tests",   "docs",  "lessons",
                                   "molecules", "assets", "package", "cmake", ".ci"};
  const std::regex code("`([A-Za-z0-9_.-]+(/[A-Za-z0-9_.-]+)*/?)`"), link(R"(\]\(<?([^)>\s]+)>?\))");
  std::size_t paths = 0, links = 0;
  std::vector<std::string> pages;
  for (const auto& [where, text] : project().texts)
    if (where.ends_with(".md")) pages.push_back(where);
  for (const char* more : {"lessons/README.md", "molecules/README.md", "CHANGELOG.md"}) pages.push_back(more);
  for (const std::string& where : pages) {
    const std::string text = textOf(kSource / where);
    for (std::sregex_iterator it(text.begin(), text.end(), code), end; it != end; ++it) {
      const std::string named = (*it)[1];
      const std::size_t slash = named.find('/');
      const bool placeholder =
          std::any_of(named.begin(), named.end(), [](char c) { return std::isupper(static_cast<unsigned char>(c)); }) &&
          named.find("README") == std::string::npos && named.find("CMake") == std::string::npos;
      if (slash == std::string::npos || placeholder || !tops.contains(named.substr(0, slash))) continue;
      ++paths;
      // A target's name, a class's file without its ending.
      const bool there =
          fs::exists(kSource / named) || fs::exists(kSource / (named + ".h")) || fs::exists(kSource / (named + ".cpp"));
      CHECK_MESSAGE(there, where, ":", lineOf(text, std::size_t(it->position())), " names ", named,
                    ", which is not there");
    }
    bool block = false;
    std::istringstream lines(text);
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (line.starts_with("```")) block = !block;
      if (block || line.starts_with("    ")) continue;
      // Text in backticks is an example.
      line = std::regex_replace(line, std::regex("`[^`]*`"), "x");
      for (std::sregex_iterator it(line.begin(), line.end(), link), end; it != end; ++it) {
        const std::string to = (*it)[1];
        if (to.find(':') != std::string::npos) continue;
        ++links;
        const std::size_t sign = to.find('#');
        const fs::path file = sign == 0 ? kSource / where : (kSource / where).parent_path() / to.substr(0, sign);
        CHECK_MESSAGE(fs::exists(file), where, ":", number, " links to ", to, ", which is not there");
        if (sign != std::string::npos && file.extension() == ".md" && fs::exists(file))
          CHECK_MESSAGE(anchorsOf(file).contains(to.substr(sign + 1)), where, ":", number, " links to ", to,
                        ", and no heading is so");
      }
    }
  }
  CHECK(paths > 50);
  CHECK(links > 100);
}

TEST_CASE(
    "every source of the program that starts a thread is named in docs/inside.md, under Threads, and every row there "
    "starts one") {
  const std::string& page = project().texts.at("docs/inside.md");
  const std::size_t begin = page.find("\n## Threads\n");
  REQUIRE(begin != std::string::npos);
  const std::string section = page.substr(begin, page.find("\n## ", begin + 1) - begin);
  std::size_t found = 0;
  std::set<std::string> started;
  for (const std::string& file : project().files) {
    if (file.starts_with("tests/")) continue;
    const std::string code = halvesOf(textOf(kSource / file)).code;
    if (code.find("std::async(") == std::string::npos && code.find("inBackground(") == std::string::npos &&
        code.find("= std::thread(") == std::string::npos && code.find("std::jthread>") == std::string::npos &&
        code.find("<std::thread>") == std::string::npos)
      continue;
    ++found;
    const fs::path path(file);
    // The class of "engine/servo/servo_thread.cpp" is ServoThread; a file of functions is named itself.
    std::string name;
    bool upper = true;
    for (const char c : path.stem().string()) {
      if (c != '_') name += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      upper = c == '_';
    }
    // What is the operating system's or a library's own has its name behind the class's.
    std::vector<std::string> names{path.stem().string() + ".h"};
    for (std::size_t length = name.size(); length >= 6; --length) names.push_back(name.substr(0, length));
    const auto at = std::find_if(names.begin(), names.end(), [&](const std::string& one) {
      return section.find("`" + one + "`") != std::string::npos;
    });
    const bool named = at != names.end();
    if (named) started.insert(*at);
    CHECK_MESSAGE(named, file, " starts a thread, and ", name, " is not in the table of docs/inside.md");
  }
  CHECK(found >= 15);
  std::istringstream rows(section);
  for (std::string row; std::getline(rows, row);)
    if (row.starts_with("| `")) {
      const std::string of_row = row.substr(3, row.find('`', 3) - 3);
      CHECK_MESSAGE(started.contains(of_row), "docs/inside.md names ", of_row, ", which starts no thread");
    }
}
