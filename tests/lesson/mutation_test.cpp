// Mutations of every sort in the program's lessons: no crash, no silently incomplete reading, and every problem has a
// place inside the file. The oracle is the file itself: its lines and their lengths are counted here byte by byte.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "engine/lesson/check.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/lesson/reader.h"

using namespace moltact;

namespace {

std::vector<std::string> shippedLessons() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(MOLTACT_SOURCE_DIR "/lessons"))
    if (entry.path().extension() == ".md" && entry.path().stem() != "README") {
      std::ifstream in(entry.path(), std::ios::binary);
      std::ostringstream text;
      text << in.rdbuf();
      out.push_back(text.str());
    }
  REQUIRE_FALSE(out.empty());
  return out;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text)
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string out;
  for (std::size_t i = 0; i < lines.size(); ++i) out += (i ? "\n" : "") + lines[i];
  return out;
}

std::size_t charactersIn(const std::string& line) {
  return static_cast<std::size_t>(
      std::count_if(line.begin(), line.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; }));
}

/// The result is consistent, and each of its positions lies in the text. With molecules, this includes all their
/// messages.
void checkReading(const std::string& text, const MoleculeByName& molecules = {}) {
  const LessonReading read = readLessonText("lesson.md", text);
  const std::vector<std::string> lines = linesOf(text);
  CHECK(read.lesson.has_value() == read.errors.empty());
  CHECK_FALSE((read.lesson && read.partial));
  LessonCheck check{{}, read.errors, read.warnings};
  if (molecules) {
    check = checkLesson("lesson.md", text, molecules);
    CHECK(check.lesson.has_value() == read.lesson.has_value());
    CHECK(check.errors.size() >= read.errors.size());
  }
  for (const auto* list : {&check.errors, &check.warnings})
    for (const Problem& p : *list) {
      CAPTURE(p.text());
      CHECK(p.file == "lesson.md");
      CHECK_FALSE(p.message.empty());
      REQUIRE((p.line >= 1 && p.line <= lines.size()));
      CAPTURE(lines[p.line - 1]);
      REQUIRE((p.column >= 1 && p.column <= charactersIn(lines[p.line - 1]) + 1));
    }
  if (read.lesson) CHECK_FALSE(read.lesson->steps.empty());
}

}  // namespace

TEST_CASE(
    "every single line deleted, doubled, misspelt or swapped with its neighbour leaves no crash and no place outside "
    "the file") {
  LessonMolecules library;
  std::map<NamedMolecule, Expected<std::shared_ptr<const Molecule>>> known;
  const MoleculeByName molecules = [&](const NamedMolecule& name) {
    const auto found = known.find(name);
    return found != known.end() ? found->second : known.emplace(name, library.find("lesson.md", name)).first->second;
  };
  // One mutation in 127 is checked with the molecules: it reaches every kind of line, and every kind of change because
  // 127 is prime.
  std::size_t count = 0;
  const auto check = [&](const std::string& text) {
    checkReading(text, count++ % 127 == 0 ? molecules : MoleculeByName());
  };
  std::set<std::string> seen;  // a line after the same line, in this lesson or in another one, is changed once
  for (const std::string& text : shippedLessons()) {
    const std::vector<std::string> lines = linesOf(text);
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      if (i > 0 && !seen.insert(lines[i - 1] + '\n' + lines[i]).second) continue;
      std::vector<std::string> changed = lines;
      changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(i));
      check(joined(changed));
      changed = lines;
      changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(i), lines[i]);
      check(joined(changed));
      changed = lines;
      std::swap(changed[i], changed[i + 1]);
      check(joined(changed));
      // Two letters of its first word, and two of its last.
      for (const bool first : {true, false}) {
        const std::size_t start = first ? lines[i].find_first_not_of(" ") : lines[i].find_last_of(' ') + 1;
        if (start >= lines[i].size() || lines[i].size() - start < 3) continue;
        changed = lines;
        std::swap(changed[i][start + 1], changed[i][start + 2]);
        check(joined(changed));
      }
    }
  }
}

TEST_CASE("500 times 1 to 8 misspellings, 500 times random bytes put in, and every 37th truncation are read safely") {
  const unsigned seed = 20260721;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (const std::string& text : shippedLessons()) {
    for (int n = 0; n < 500; ++n) {
      std::string changed = text;
      for (unsigned k = 0, count = static_cast<unsigned>(1 + random() % 8); k < count; ++k) {
        const std::size_t at = random() % (changed.size() - 1);
        switch (random() % 4) {
          case 0:
            changed.erase(at, 1);
            break;
          case 1:
            changed.insert(at, 1, changed[at]);
            break;
          case 2:
            std::swap(changed[at], changed[at + 1]);
            break;
          default:
            changed[at] = "`#>-[](){}:*_\n \t\"!x0"[random() % 19];
            break;
        }
      }
      checkReading(changed);
    }
    for (int n = 0; n < 500; ++n) {
      std::string changed = text;
      for (unsigned k = 0, count = static_cast<unsigned>(1 + random() % 20); k < count; ++k)
        changed.insert(random() % changed.size(), 1, static_cast<char>(random() % (n % 2 ? 128 : 256)));
      checkReading(changed);
    }
    for (std::size_t length = 0; length < text.size(); length += 37) checkReading(text.substr(0, length));
  }
}

TEST_CASE("100000 quotes, brackets, backticks or list marks, 300 random files and a 2 MiB file are read safely") {
  const std::string head = "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: m\nauthor: A\nlicence: L\n---\n## S\n";
  for (const std::string part : {">", "[", "`", "- ", "(", "*_", "![", "<a>", "\n>", "\n- ", "\n```touch\n",
                                 "\n### Question:\n", "&#x41;", "|a"}) {
    std::string text = head;
    while (text.size() < 100000) text += part;
    checkReading(text);
    std::string wrapped = head;
    for (int line = 0; line < 100; ++line) {
      for (std::size_t k = 0; k < 1000 / part.size(); ++k) wrapped += part;
      wrapped += '\n';
    }
    checkReading(wrapped);
  }
  const unsigned seed = 3;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int n = 0; n < 300; ++n) {
    std::string text = n % 2 ? head : std::string();
    for (unsigned k = 0, size = static_cast<unsigned>(random() % 3000); k < size; ++k)
      text += static_cast<char>(n % 3 ? 9 + random() % 118 : random() % 256);
    checkReading(text);
  }
  const LessonReading huge = readLessonText("lesson.md", std::string(std::size_t{2} << 20, 'a'));
  REQUIRE(huge.errors.size() == 1);
  CHECK(huge.errors[0].text() == "lesson.md: a lesson of more than 1 MiB; split it into several lessons");
}
