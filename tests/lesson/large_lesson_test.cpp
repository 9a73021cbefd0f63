// Lessons at the reader's size limit that repeat one element: messages and work stay bounded. The work is counted, not
// timed: each molecule is requested once.
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "engine/lesson/check.h"
#include "engine/lesson/problem_list.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/suggestion.h"

using namespace moltact;

namespace {

const std::string kLargeLessonHead =
    "---\ntitle: Large\nlevel: beginner\nminutes: 1\ngoals:\n  - all of it\nmolecules: one\nauthor: A "
    "teacher\nlicence: CC0-1.0\n---\n\n## One\n\n```scene\nmolecule: one\n```\n\n";

std::string number(std::size_t n) {
  char text[20];
  std::snprintf(text, sizeof text, "%zx", n);
  return text;
}

// `part(n)` for n from 0 on, as often as a lesson takes it.
template <class Part>
std::string filled(std::string text, Part&& part) {
  for (std::size_t n = 0;; ++n) {
    const std::string next = part(n);
    if (text.size() + next.size() > kLargestLesson) return text;
    text += next;
  }
}

struct Result {
  LessonCheck check;
  int asked = 0;  // for molecules
};

Result checked(const std::string& text, const std::string& file = "/nowhere/large.md") {
  Result out;
  out.check = checkLesson(file, text, [&](const NamedMolecule&) -> Expected<std::shared_ptr<const Molecule>> {
    ++out.asked;
    return Problem{{}, 0, 0, "there is no such molecule", "take another"};
  });
  return out;
}

std::size_t reported(const LessonCheck& check) { return std::max(check.errors.size(), check.warnings.size()); }

}  // namespace

TEST_CASE("for a lesson of 90 000 dead links, to steps or to files, 500 are reported and that there are more") {
  for (const char* to : {"#", "", "other.md#"}) {
    CAPTURE(to);
    const Result r = checked(filled(kLargeLessonHead, [&](std::size_t n) {
      return std::string("[a](") + to + number(n) + ")" + (n % 100 ? "" : "\n\n");
    }));
    REQUIRE(r.check.errors.size() == kMaxLessonProblems + 1);
    CHECK(r.check.errors.back().message == "there are more, which are not listed");
    CHECK(r.check.errors.back().line == r.check.errors[kMaxLessonProblems - 1].line);
  }
}

TEST_CASE("a lesson of 1000 steps is read; one of 100 000 is refused at the 1001st step") {
  const auto steps = [](std::size_t count) {
    std::string text = kLargeLessonHead + "It is here.\n\n";
    for (std::size_t n = 1; n < count; ++n) text += "## s" + number(n) + "\n\nA\n";
    return text;
  };
  const LessonReading thousand = readLessonText("l.md", steps(1000));
  CHECK(thousand.lesson);
  const LessonReading many =
      readLessonText("l.md", filled(kLargeLessonHead, [](std::size_t n) { return "## s" + number(n) + "\n"; }));
  REQUIRE(many.errors.size() == 1);
  CHECK(many.errors[0].message == "a lesson of more than 1000 steps");
  CHECK(many.errors[0].line == std::size_t(std::count(kLargeLessonHead.begin(), kLargeLessonHead.end(), '\n')) + 1000);
  CHECK(many.partial->steps.size() == 1000);
}

TEST_CASE(
    "for a lesson filled with questions, choices, scenes, asides, molecules or tasks, at most 501 "
    "problems of a kind are reported") {
  const std::string parts[] = {"### Question: a%\n",
                               "- [x] %\n",
                               "## Aside: a%\n",
                               "```scene\nmolecule: m%\n```\n\n## s%\n",
                               "```touch\nreach: atom %\n```\n",
                               "![a](%.png)\n\n",
                               "> [!%]\n\n",
                               "```%\n```\n"};
  for (const std::string& part : parts) {
    CAPTURE(part);
    const std::string start = part.starts_with('-') ? kLargeLessonHead + "### Question: a?\n\n" : kLargeLessonHead;
    const Result r = checked(filled(start, [&](std::size_t n) {
      std::string text = part;
      for (std::size_t at; (at = text.find('%')) != std::string::npos;) text.replace(at, 1, number(n));
      return text;
    }));
    CHECK(reported(r.check) > 0);
    CHECK(reported(r.check) <= kMaxLessonProblems + 1);
    CHECK(r.asked <= int(kMaxLessonProblems) + 1);
  }
  std::string molecules = "---\ntitle: Large\nlevel: beginner\nminutes: 1\ngoals:\n  - all of it\nmolecules:\n";
  for (std::size_t n = 0; molecules.size() < 900'000; ++n) molecules += "  - m" + number(n) + "\n";
  CHECK(reported(checked(molecules + kLargeLessonHead.substr(kLargeLessonHead.find("---\n\n"))).check) <=
        kMaxLessonProblems + 1);
}

TEST_CASE("a missing file beside 2000 files with long names, linked 20 000 times, gives 500 suggestions") {
  const auto folder = std::filesystem::temp_directory_path() / ("moltact_large_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string stem(52, 'a');
  for (std::size_t n = 0; n < 2000; ++n) std::ofstream(folder / (stem + number(n + 0x10000)));
  const Result r =
      checked(filled(kLargeLessonHead,
                     [&](std::size_t n) { return "[a](" + stem + number(n + 0x20000) + ")" + (n % 50 ? "" : "\n\n"); }),
              (folder / "l.md").string());
  CHECK(r.check.errors.size() == kMaxLessonProblems + 1);
  CAPTURE(r.check.errors[400].text());
  CHECK(r.check.errors[400].remedy.starts_with("did you mean '" + stem));
  std::filesystem::remove_all(folder);
}

TEST_CASE(
    "the nearest of 300 random words is the one of the least distance, found without working out every distance") {
  std::mt19937 random(11);
  const auto word = [&] {
    std::string out;
    for (std::size_t n = 3 + random() % 9; out.size() < n;) out += char('a' + random() % 3);
    return out;
  };
  for (int k = 0; k < 300; ++k) {
    std::vector<std::string> words;
    for (int i = 0; i < 300; ++i) words.push_back(word());
    const std::string asked = word();
    std::size_t least = 100;
    for (const std::string& w : words)
      if (const std::size_t d = editDistance(asked, w); d <= std::max<std::size_t>(1, w.size() / 3))
        least = std::min(least, d);
    const std::vector<std::string_view> known(words.begin(), words.end());
    const std::string said = suggest(asked, known, "known");
    CHECK(said.starts_with("did you mean '") == (least < 100));
    if (least < 100) CHECK(editDistance(asked, said.substr(14, said.size() - 16)) == least);
  }
}
