// Every text of the engine for a person must be translatable. Checked in the sources: a literal of two words or more is
// an argument of tr() or a similar function, or is at a place listed here.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct Token {
  enum class Kind { Name, Literal, Sign } kind;
  std::string text;  // of a literal: what stands between its quotation marks
  std::size_t line;
};

// Names, string literals and signs of a source; comments, preprocessor lines, raw strings and numbers are left out.
std::vector<Token> tokensOf(const std::string& s) {
  std::vector<Token> out;
  std::size_t line = 1;
  const auto name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t k = 0; k < s.size();) {
    const std::size_t begin = k;
    if (s[k] == '\n') {
      ++line, ++k;
      const std::size_t first = s.find_first_not_of(" \t", k);
      if (first != std::string::npos && s[first] == '#') k = std::min(s.find('\n', first), s.size());
    } else if (s.compare(k, 2, "//") == 0) {
      k = std::min(s.find('\n', k), s.size());
    } else if (s.compare(k, 2, "R\"") == 0) {
      const std::size_t open = s.find('(', k);
      const std::string end = ")" + s.substr(k + 2, open - k - 2) + "\"";
      k = std::min(s.find(end, open), s.size() - end.size()) + end.size();
    } else if (s[k] == '"' || s[k] == '\'') {
      for (++k; k < s.size() && s[k] != s[begin]; ++k) k += s[k] == '\\';
      ++k;
      if (s[begin] == '"') out.push_back({Token::Kind::Literal, s.substr(begin + 1, k - begin - 2), line});
    } else if (std::isdigit(static_cast<unsigned char>(s[k]))) {
      while (k < s.size() && (name(s[k]) || s[k] == '.' || (s[k] == '\'' && name(s[k + 1])))) ++k;  // 20'000
    } else if (name(s[k])) {
      while (k < s.size() && name(s[k])) ++k;
      out.push_back({Token::Kind::Name, s.substr(begin, k - begin), line});
    } else {
      if (!std::isspace(static_cast<unsigned char>(s[k])))
        out.push_back({Token::Kind::Sign, std::string(1, s[k]), line});
      ++k;
    }
    line += static_cast<std::size_t>(std::count(s.begin() + std::ptrdiff_t(begin) + (s[begin] == '\n'),
                                                s.begin() + std::ptrdiff_t(std::min(k, s.size())), '\n'));
  }
  return out;
}

bool oneOf(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Whether a person reads it as words: not markup, a path of a picture, a format or a shader.
bool prose(const std::string& literal) {
  static const std::regex words(R"([A-Za-z]{2,} [a-z]+)"), other(R"([<>%]|=\\"|#version)");
  return std::regex_search(literal, words) && !std::regex_search(literal, other);
}

// Whether the literal at `k` is an argument of a function that translates, or text that remains English: an assertion,
// or the meaning of a key, which only the authors' reference shows.
bool looked(const std::vector<Token>& t, std::size_t k) {
  int depth = 0;
  for (std::size_t at = k; at-- > 0;) {
    const std::string& sign = t[at].text;
    if (t[at].kind == Token::Kind::Literal) continue;
    if (depth == 0 && t[at].text == "meaning") return true;
    if (t[at].kind != Token::Kind::Sign) continue;
    if (oneOf(sign, {")", "]", "}"})) ++depth;
    if (sign == ";" && depth == 0) return false;
    if (oneOf(sign, {"(", "[", "{"}) && depth-- == 0)
      return at > 0 && sign == "(" &&
             oneOf(t[at - 1].text, {"tr", "trf", "trn", "trc", "trcf", "trnf", "N_", "NC_", "static_assert"});
  }
  return false;
}

}  // namespace

TEST_CASE(
    "what the engine's rooms say of two words or more is marked for translation, in all but the places named here") {
  // File, and how many of its literals stay English.
  const std::map<std::string, int> english = {
      {"engine/lesson/new_lesson.cpp", 99},       // the lesson that an author begins with
      {"engine/lesson/reference.cpp", 99},        // a page of docs
      {"engine/lesson/minutes.cpp", 1},           // a row of that page
      {"engine/lesson/facts.cpp", 16},            // the table of its kinds on that page
      {"engine/lesson/selection_parser.cpp", 9},  // words of the selection language, explained on that page
      {"engine/lesson/selection_slips.cpp", 2},   // words of it
      {"engine/lesson/keys.cpp", 2},              // keys that authors write
      {"engine/lesson/step_rules.cpp", 3},        // the same, and words of theirs
      {"engine/lesson/answer_reader.cpp", 2},
      {"engine/lesson/values.cpp", 1},
      {"engine/lesson/second_state.cpp", 2},  // keys in which they stand
      {"engine/results/write_attempt_lines.cpp", 1},
      {"engine/lesson/block_readers.cpp", 1},                      // words of a scene's key
      {"engine/lesson/scripted_learner/scripted_learner.cpp", 1},  // an answer
      {"engine/device/hid/space_mouse.cpp", 1},                    // a maker's name
      {"engine/servo/device_check.cpp", 99},                       // `moltact device check`, in a terminal
      {"engine/servo/hand_path.cpp", 99},   // `moltact device path` and `moltact bench`, in a terminal
      {"engine/servo/force_monitor.h", 9},  // its findings
      {"engine/servo/playback_device.h", 1},
      {"engine/molecule/molecule_key.cpp", 1},          // part of a key
      {"engine/platform/shared_library_linux.cpp", 1},  // a message of the system
      {"engine/render/gl.h", 1},                        // in a shader
      {"engine/render/contact_shadow.cpp", 2},
      {"engine/render/edge_filter.cpp", 1},
      {"engine/render/lighting.cpp", 1},
      {"engine/render/gltf_export.cpp", 2},  // in a file
      {"engine/render/solid_mesh.cpp", 1},   // names of shaders
      {"engine/render/sphere_impostors.cpp", 3},
      {"engine/lesson/prose_reader.cpp", 4},  // how authors begin a note
      {"engine/structure/map_file.cpp", 4},   // lines of AutoGrid's files
      {"engine/results/study_csv.cpp", 99},   // columns and their codebook, the same in every language
      {"engine/results/study_page.cpp", 4},   // references
  };
  std::size_t seen = 0;
  for (const char* room : {"device", "gltf", "haptics", "lesson", "molecule", "platform", "render", "results", "servo",
                           "sound", "structure"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(MOLTACT_SOURCE_DIR) / "engine" / room)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      const std::string file = fs::relative(entry.path(), MOLTACT_SOURCE_DIR).generic_string();
      std::ifstream in(entry.path());
      std::string source{std::istreambuf_iterator<char>(in), {}};
      // A kind of task ends with the table of its keys, and what it is for; both are for the reference.
      if (file.starts_with("engine/lesson/tasks/"))
        if (const std::size_t table = source.find("\nTaskKind "); table != std::string::npos) source.resize(table);
      const std::vector<Token> tokens = tokensOf(source);
      std::string found;
      int count = 0;
      for (std::size_t k = 0; k < tokens.size(); ++k) {
        if (tokens[k].kind != Token::Kind::Literal || !prose(tokens[k].text)) continue;
        ++seen;
        if (looked(tokens, k)) continue;
        ++count;
        found += "\n" + file + ":" + std::to_string(tokens[k].line) + ": " + tokens[k].text;
      }
      const auto allowed = english.find(file);
      CHECK_MESSAGE(count <= (allowed == english.end() ? 0 : allowed->second), "not marked for translation:" << found);
    }
  CHECK(seen > 700);  // or the sentences are looked for in the wrong way
}

TEST_CASE(
    "the search for sentences distinguishes a bare one, one in a condition and one in a table from "
    "those that are marked") {
  const auto bare = [](const std::string& source) {
    const std::vector<Token> tokens = tokensOf(source);
    int count = 0;
    for (std::size_t k = 0; k < tokens.size(); ++k)
      count += tokens[k].kind == Token::Kind::Literal && prose(tokens[k].text) && !looked(tokens, k);
    return count;
  };
  CHECK(bare("return \"a bare sentence\";") == 1);
  CHECK(bare("return few ? \"a bare one\" : tr(\"a marked one\");") == 1);
  CHECK(bare("f(tr(\"marked once\"), \"and bare\");") == 1);
  CHECK(bare("Problem{file, 0, 0, \"in \" + x, tr(\"mend it\")};") == 0);  // one word: it could be a name
  CHECK(bare("const Row k[] = {{N_(\"in a table\")}, {20'000, \"not marked\"}};") == 1);
  CHECK(bare("trf(\"two {0} \"\n \"lines of it\", x(\"k\")); // \"a comment\" \n#include \"no such file\"\n") == 0);
  CHECK(bare("out += R\"(<p>raw text here)\"; out += \"<td class=\\\"left\\\">\";") == 0);
}
