// The questions of the program's lessons give nothing away by the length or the position of a choice.
#include <algorithm>
#include <array>
#include <filesystem>

#include "engine/lesson/lesson_files.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

std::vector<std::string> shippedLessonNames() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(MOLTACT_SOURCE_DIR "/lessons"))
    if (looksLikeLesson(entry.path())) out.push_back(entry.path().stem().string());
  std::sort(out.begin(), out.end());
  return out;
}

/// Characters, not bytes, of the text as it is read.
std::size_t lengthOf(const RichText& text) {
  const std::string plain = plainText(text);
  return static_cast<std::size_t>(
      std::count_if(plain.begin(), plain.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

TEST_CASE("in no question of a shipped lesson is the one right choice longer than every wrong one") {
  int asked = 0;
  for (const std::string& name : shippedLessonNames()) {
    CAPTURE(name);
    for (const Step& step : shippedLesson(name).steps)
      for (const Question& q : step.questions) {
        if (q.rightChoices() != 1) continue;
        CAPTURE(plainText(q.title));
        std::size_t right = 0, wrong = 0;
        for (const Choice& c : q.choices)
          (c.right ? right : wrong) = std::max(c.right ? right : wrong, lengthOf(c.text));
        CHECK(right <= wrong);
        ++asked;
      }
  }
  CHECK(asked >= 30);
}

TEST_CASE("of the questions with three choices each place is right in 25 % to 45 %, and no lesson has one place only") {
  std::array<int, 3> right{};
  int asked = 0;
  for (const std::string& name : shippedLessonNames()) {
    if (name.find('.') != std::string::npos) continue;  // a translation has the order of its original
    CAPTURE(name);
    std::array<int, 3> here{};
    for (const Step& step : shippedLesson(name).steps)
      for (const Question& q : step.questions) {
        if (q.choices.size() != 3 || q.rightChoices() != 1) continue;
        for (std::size_t k = 0; k < 3; ++k) here[k] += q.choices[k].right;
        ++asked;
      }
    CHECK(std::count(here.begin(), here.end(), 0) < 2);
    for (std::size_t k = 0; k < 3; ++k) right[k] += here[k];
  }
  REQUIRE(asked >= 20);
  for (std::size_t k = 0; k < 3; ++k) {
    CAPTURE(k);
    CHECK(right[k] >= 0.25 * asked);
    CHECK(right[k] <= 0.45 * asked);
  }
}

TEST_CASE("no prediction of a shipped lesson is marked: any curve will do") {
  for (const std::string& name : shippedLessonNames()) {
    CAPTURE(name);
    for (const Step& step : shippedLesson(name).steps)
      for (const TaskSpec& t : step.tasks)
        if (t.kind == "predict") CHECK_FALSE(t.values.has("agree"));
  }
}
