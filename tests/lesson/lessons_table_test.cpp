// lessons/README.md, the table of the lessons, agrees with them: a row for each, with its title and minutes, and every
// German sister named.
#include <algorithm>
#include <filesystem>
#include <iterator>

#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "each shipped lesson has one row in lessons/README.md, with its title and its minutes, and German ones are told") {
  const std::filesystem::path folder = MOLTACT_SOURCE_DIR "/lessons";
  std::ifstream in(folder / "README.md");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  const std::size_t german_at = text.find("\nIn German too: ");
  REQUIRE(german_at != std::string::npos);
  const std::string german = text.substr(german_at, text.find("\n\n", german_at + 1) - german_at);
  int rows = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".md" || name == "README" || name.starts_with("glossary") ||
        name.find('.') != std::string::npos)
      continue;
    CAPTURE(name);
    const Lesson lesson = shippedLesson(name);
    const std::string begin = "\n| [" + lesson.title + "](" + name + ".md) | ";
    const std::size_t at = text.find(begin);
    REQUIRE(at != std::string::npos);
    CHECK(text.find(begin, at + 1) == std::string::npos);
    const std::string row = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
    CHECK(row.find(" | " + std::to_string(lesson.minutes) + " | ") != std::string::npos);
    CHECK((german.find("*" + lesson.title + "*") != std::string::npos) ==
          std::filesystem::exists(folder / (name + ".de.md")));
    ++rows;
  }
  CHECK(rows >= 14);
  CHECK(rows == std::count(text.begin(), text.begin() + std::ptrdiff_t(german_at), '\n') -
                    std::count(text.begin(), text.begin() + std::ptrdiff_t(text.find("\n| ---")), '\n') - 2);
}
