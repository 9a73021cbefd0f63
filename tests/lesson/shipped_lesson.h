// A lesson of lessons/ and its molecules, as distributed.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <initializer_list>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "engine/haptics/sphere_grid.h"
#include "engine/lesson/check.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/surface_places.h"
#include "engine/molecule/reader.h"

namespace moltact::test {

inline Expected<std::shared_ptr<const Molecule>> shippedMolecule(const NamedMolecule& named) {
  const std::string path = std::string(MOLTACT_SOURCE_DIR "/molecules/") + named.name;
  const bool charged = std::ifstream(path + ".pqr").good();
  auto molecule = readMolecule(path + (charged ? ".pqr" : ".pdb"), named.reading);
  if (!molecule) return molecule.problem();
  return std::make_shared<const Molecule>(*std::move(molecule));
}

inline Lesson shippedLesson(const std::string& name) {
  const LessonReading read = readLesson(std::string(MOLTACT_SOURCE_DIR "/lessons/") + name + ".md");
  for (const Problem& p : read.errors) MESSAGE(p.text());
  for (const Problem& p : read.warnings) MESSAGE(p.text());
  REQUIRE(read.lesson);
  CHECK(read.warnings.empty());
  return *read.lesson;
}

/// The minimum quality of every lesson: a task and a hint in each step; feedback to every choice; and
/// selections that match atoms.
inline void checkCare(const Lesson& lesson) {
  for (const Problem& p : checkAgainstMolecules(lesson, shippedMolecule)) FAIL_CHECK(p.text());
  for (const Step& step : lesson.steps) {
    CAPTURE(step.title);
    CHECK_FALSE(step.tasks.empty());
    bool tip = false;
    for (const Block& b : step.blocks) tip = tip || std::holds_alternative<Tip>(b);
    CHECK(tip);
    for (const TaskSpec& t : step.tasks) CHECK(t.values["praise"].text != "Done.");
    for (const Question& q : step.questions)
      for (const Choice& c : q.choices) {
        CAPTURE(plainText(c.text));
        CHECK_FALSE(plainText(c.feedback).empty());
      }
  }
}

/// The line of a lesson that contains these words, "the-haem-in-its-pocket.md:57"; fails if there is none, so that a
/// test computes what the lesson says.
inline std::string lineSaying(const std::string& lesson, const std::string& words) {
  std::ifstream in(std::string(MOLTACT_SOURCE_DIR "/lessons/") + lesson + ".md");
  std::string line;
  for (int n = 1; std::getline(in, line); ++n)
    if (line.find(words) != std::string::npos) return lesson + ".md:" + std::to_string(n);
  FAIL_CHECK(lesson << ".md does not say: " << words);
  return lesson + ".md";
}

/// The same for several texts: "the-haem-in-its-pocket.md:57, the-haem-in-its-pocket.md:60".
inline std::string linesSaying(const std::string& lesson, std::initializer_list<std::string> words) {
  std::string out;
  for (const std::string& w : words) out += (out.empty() ? "" : ", ") + lineSaying(lesson, w);
  return out;
}

// doctest evaluates what it captures only when a check fails, and then the search would not run. SAYS searches at once.
#define MOLTACT_SAYS(place, ...)           \
  const std::string place = (__VA_ARGS__); \
  CAPTURE(place)
/// SAYS(lineSaying(lesson, words)): the lesson must say this; the line is shown with every failed check that follows.
#define SAYS(...) MOLTACT_SAYS(DOCTEST_ANONYMOUS(said_), __VA_ARGS__)

/// The number of touch tasks of this kind in a lesson.
inline int tasksOf(const Lesson& lesson, std::string_view kind) {
  int n = 0;
  for (const Step& s : lesson.steps)
    for (const TaskSpec& t : s.tasks) n += t.kind == kind;
  return n;
}

struct ShippedScene {
  explicit ShippedScene(const std::string& name) : molecule(*shippedMolecule(name)), spheres(molecule->spheres) {}
  std::vector<std::uint32_t> select(const std::string& text) const {
    const auto selection = parseSelection(text);
    REQUIRE(selection);
    return selection->select(*molecule);
  }
  PlacedAtom atom(const std::string& text) const {
    const auto found = select(text);
    REQUIRE_MESSAGE(found.size() == 1, text);
    return molecule->at(found[0]);
  }
  double between(const std::string& a, const std::string& b) const {
    return glm::distance(atom(a).position.A, atom(b).position.A);
  }
  /// The angle at the probe in the triangle formed by the probe and two atoms that it touches (unit: degree).
  double turn_deg(const std::string& one, const std::string& other, double probe_A) const {
    const double a = atom(one).radius_A + probe_A, b = atom(other).radius_A + probe_A, d = between(one, other);
    return std::acos((a * a + b * b - d * d) / (2 * a * b)) * 180 / std::numbers::pi;
  }
  /// Places on these atoms where a probe can rest, from this number of directions around each.
  std::vector<SurfacePlace> places(const std::string& text, double probe_A, int directions = 3000) const {
    const auto atoms = select(text);
    return facePlaces(spheres, atoms, probe_A, directions);
  }
  /// The number of these places that the probe reaches straight from outside.
  std::size_t openPlaces(const std::string& text, double probe_A) const {
    std::size_t n = 0;
    for (const SurfacePlace& p : places(text, probe_A)) n += openFromOutside(spheres, p, probe_A);
    return n;
  }

  std::shared_ptr<const Molecule> molecule;
  SphereGrid spheres;
};

}  // namespace moltact::test
