// The tables in lessons/README.md agree with the lessons: a row for each lesson with its title and minutes, and one for
// each task with its step and kind.
#include <algorithm>
#include <filesystem>
#include <iterator>

#include "engine/lesson/minutes.h"
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
    const ShownMinutes minutes = shownMinutes(lesson);
    CHECK(minutes.core <= 20);
    const std::string all = minutes.all > minutes.core ? ", with all " + std::to_string(minutes.all) : "";
    CHECK_MESSAGE(row.ends_with(" | " + std::to_string(minutes.core) + all + " |"), row);
    ++rows;
  }
  CHECK(rows >= 16);
  CHECK(rows == std::count(table.begin(), table.end(), '\n') - 2);  // the head and the line below it
}

TEST_CASE("each task of each shipped lesson has its row in lessons/README.md, in their order, and no other has") {
  std::ifstream in(MOLTACT_SOURCE_DIR "/lessons/README.md");
  std::vector<std::string> rows;
  bool tasks = false;
  for (std::string line; std::getline(in, line);) {
    tasks = tasks || line == "| lesson | step | task | what it takes |";
    if (tasks && line.starts_with("| ")) rows.push_back(line);
  }
  REQUIRE(rows.size() > 2);
  rows.erase(rows.begin(), rows.begin() + 2);  // the head and the line below it
  std::vector<Lesson> lessons;
  for (const auto& entry : std::filesystem::directory_iterator(MOLTACT_SOURCE_DIR "/lessons")) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".md" && name != "README" && !name.starts_with("glossary") &&
        name.find('.') == std::string::npos)
      lessons.push_back(shippedLesson(name));
  }
  std::sort(lessons.begin(), lessons.end(), [](const Lesson& a, const Lesson& b) { return a.order < b.order; });
  std::size_t row = 0;
  for (const Lesson& lesson : lessons) {
    bool first = true;
    for (const Step& step : lesson.steps)
      for (const TaskSpec& t : step.tasks) {
        REQUIRE(row < rows.size());
        const std::string begin =
            "| " + (first ? lesson.title : std::string()) + " | " + step.title + " | `" + t.kind + "` | ";
        CHECK_MESSAGE(rows[row].starts_with(begin), rows[row] << " is not " << begin);
        CHECK(rows[row].size() > begin.size() + 2);
        first = false;
        ++row;
      }
  }
  CHECK(row == rows.size());
}
