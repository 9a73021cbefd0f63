// lessons/README.md, the table of the lessons, agrees with them: a row for each, with its title and minutes.
#include <algorithm>
#include <filesystem>
#include <iterator>

#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE("each shipped lesson has one row in lessons/README.md, with its title and its minutes, and no other has") {
  const std::filesystem::path folder = MOLTACT_SOURCE_DIR "/lessons";
  std::ifstream in(folder / "README.md");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  const std::size_t table_at = text.find("\n| lesson | ");
  REQUIRE(table_at != std::string::npos);
  const std::string table = text.substr(table_at, text.find("\n\n", table_at) - table_at);
  int rows = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".md" || name == "README" || name.starts_with("glossary") ||
        name.find('.') != std::string::npos)
      continue;
    CAPTURE(name);
    const Lesson lesson = shippedLesson(name);
    const std::string begin = "\n| [" + lesson.title + "](" + name + ".md) | ";
    const std::size_t at = table.find(begin);
    REQUIRE(at != std::string::npos);
    CHECK(table.find(begin, at + 1) == std::string::npos);
    const std::string row = table.substr(at + 1, table.find('\n', at + 1) - at - 1);
    CHECK(row.find(" | " + std::to_string(lesson.minutes) + " | ") != std::string::npos);
    ++rows;
  }
  CHECK(rows >= 14);
  CHECK(rows == std::count(table.begin(), table.end(), '\n') - 2);  // the head and the line below it
}
