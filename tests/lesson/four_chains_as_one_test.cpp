// The program's lesson on the four chains of haemoglobin: its steps, and the numbers of its table.
#include <cmath>

#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "four-chains-as-one.md has 6 steps in one molecule, with three borders to slide over and a search in the dark") {
  for (const char* file : {"four-chains-as-one", "four-chains-as-one.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 6);
    CHECK(tasksOf(lesson, "cross") == 4);
    CHECK(tasksOf(lesson, "find") == 1);
    CHECK(lesson.molecules.size() == 1);
  }
}

TEST_CASE(
    "with Hill's equation, n = 2.7 and half full at 3.5 kPa, 97 of 100 haems hold oxygen at 13 kPa and 18 at 2 kPa; "
    "without cooperativity 79 and 36") {
  const std::string line = linesSaying(
      "four-chains-as-one", {"97 of 100 haems hold oxygen | 79 |", "at 2 kPa | 18 | 36 |", "79 of 100 against 43"});
  CAPTURE(line);
  const auto full = [](double kPa, double n) { return 100.0 / (1.0 + std::pow(3.5 / kPa, n)); };
  CHECK(std::round(full(13.0, 2.7)) == 97.0);
  CHECK(std::round(full(2.0, 2.7)) == 18.0);
  CHECK(std::round(full(13.0, 1.0)) == 79.0);
  CHECK(std::round(full(2.0, 1.0)) == 36.0);
  CHECK(97 - 18 == 79);
  CHECK(79 - 36 == 43);
}
