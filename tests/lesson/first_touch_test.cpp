// The shipped lesson: it reads without a problem, and its steps are what a newcomer is promised.
#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "engine/haptics/ball_scene.h"
#include "engine/lesson/check.h"
#include "engine/lesson/reader.h"
#include "engine/molecule/reader.h"

using namespace moltact;

namespace {

struct File {
  const char *name, *title;
};
constexpr File kFiles[] = {{MOLTACT_SOURCE_DIR "/lessons/first-touch.md", "First touch"},
                           {MOLTACT_SOURCE_DIR "/lessons/first-touch.de.md", "Erste Berührung"}};

Expected<std::shared_ptr<const Molecule>> shipped(const NamedMolecule& named) {
  const std::string& name = named.name;
  auto molecule = readMolecule(std::string(MOLTACT_SOURCE_DIR "/molecules/") + name + ".pdb", named.reading);
  if (!molecule) return molecule.problem();
  return std::make_shared<const Molecule>(*std::move(molecule));
}

/// The number of 2000 even directions in which a probe touches the atom without overlapping any other.
int openDirections(const BallScene& balls, std::uint32_t atom, double probe_A) {
  int open = 0;
  for (int k = 0; k < 2000; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / 2000, angle = 2.399963229728653 * k, r = std::sqrt(1.0 - z * z);
    const Vec3 p =
        balls[atom].centre_A + Vec3(r * std::cos(angle), r * std::sin(angle), z) * (balls[atom].radius_A + probe_A);
    bool free = true;
    balls.visitNear(p, probe_A, [&](std::uint32_t i, const Ball& b) {
      if (i != atom && glm::distance(p, b.centre_A) < b.radius_A + probe_A) free = false;
    });
    open += free;
  }
  return open;
}

}  // namespace

TEST_CASE(
    "first-touch.md, as in German, reads without errors or warnings into 5 steps, from argon to ubiquitin, each with a "
    "task") {
  for (const File& file : kFiles) {
    CAPTURE(file.name);
    const LessonReading read = readLesson(file.name);
    for (const Problem& p : read.errors) MESSAGE(p.text());
    for (const Problem& p : read.warnings) MESSAGE(p.text());
    REQUIRE(read.lesson);
    CHECK(read.warnings.empty());
    const Lesson& lesson = *read.lesson;
    CHECK(lesson.title == file.title);
    CHECK(lesson.minutes == 10);
    CHECK(lesson.goals.size() == 3);
    REQUIRE(lesson.steps.size() == 5);
    const char* expected[] = {"argon", "argon-pair", "argon-triangle", "alpha-helix", "1ubq"};
    std::set<std::string> used;
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(lesson.steps[i].scene.molecule == expected[i]);
      CHECK(lesson.steps[i].tasks.size() >= 2);
      used.insert(lesson.steps[i].scene.molecule.name);
    }
    CHECK(used.size() == lesson.molecules.size());
    std::size_t questions = 0, notes = 0, tips = 0;
    for (const Step& s : lesson.steps) {
      questions += s.questions.size();
      for (const Block& b : s.blocks) {
        notes += std::holds_alternative<TeacherNote>(b);
        tips += std::holds_alternative<Tip>(b);
      }
    }
    CHECK(questions == 5);
    CHECK(notes == 2);
    CHECK(tips >= 6);
  }
}

TEST_CASE("every selection of first-touch.md selects atoms of the shipped molecules") {
  for (const File& file : kFiles) {
    CAPTURE(file.name);
    const LessonReading read = readLesson(file.name);
    REQUIRE(read.lesson);
    for (const Problem& p : checkAgainstMolecules(*read.lesson, shipped)) FAIL_CHECK(p.text());
  }
}

TEST_CASE("every target of first-touch.md has an atom that the probe can touch from at least 1 in 100 directions") {
  for (const File& file : kFiles) {
    CAPTURE(file.name);
    const LessonReading read = readLesson(file.name);
    REQUIRE(read.lesson);
    int targets = 0;
    for (const Step& step : read.lesson->steps) {
      const auto molecule = shipped(step.scene.molecule);
      REQUIRE(molecule);
      const BallScene balls((*molecule)->balls());
      for (const TaskSpec& task : step.tasks)
        for (const auto& [key, value] : task.values) {
          if (!value.selection.given()) continue;
          CAPTURE(value.selection.text());
          int most = 0;
          for (const std::uint32_t atom : value.selection.select(**molecule))
            most = std::max(most, openDirections(balls, atom, step.scene.touch.probe_A));
          CHECK(most >= 20);
          ++targets;
        }
    }
    CHECK(targets == 6);
  }
}

TEST_CASE("the pit of the argon triangle is a place where a 1.4 Å probe touches three atoms: 2.46 Å above the middle") {
  const auto molecule = shipped("argon-triangle");
  REQUIRE(molecule);
  const double z = std::sqrt(std::pow(1.88 + 1.4, 2) - std::pow(3.76, 2) / 3.0);
  CHECK(z == doctest::Approx(2.46).epsilon(0.002));
  for (const Atom& a : (*molecule)->atoms)
    CHECK(glm::distance(a.position.A, Vec3(0, 0, z)) == doctest::Approx(a.radius_A + 1.4).epsilon(0.001));
}
