// Every lesson in lessons/ can be finished: a scripted learner follows each task's demonstration and gives right
// answers.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "engine/lesson/lesson_files.h"
#include "engine/lesson/minutes.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/scripted_learner/scripted_learner.h"
#include "engine/molecule/catalogue.h"

using namespace moltact;

namespace {

Expected<std::shared_ptr<const Molecule>> shipped(const NamedMolecule& named) {
  const std::string& name = named.name;
  static std::map<NamedMolecule, std::shared_ptr<const Molecule>> read;
  if (const auto known = read.find(named); known != read.end()) return known->second;
  const std::filesystem::path molecules = MOLTACT_SOURCE_DIR "/molecules";
  const auto file = findMolecule(name, {molecules, {}});
  if (!file) return file.problem();
  auto molecule = readMolecule(*file, named.reading);
  if (!molecule) return molecule.problem();
  return read[named] = std::make_shared<const Molecule>(*std::move(molecule));
}

std::vector<std::filesystem::path> lessons() {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(MOLTACT_SOURCE_DIR "/lessons"))
    if (looksLikeLesson(entry.path())) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

TEST_CASE(
    "every lesson in lessons/ is finished by the demonstrating student within the minutes of all its steps, on the "
    "virtual clock") {
  REQUIRE(lessons().size() >= 2);
  for (const std::filesystem::path& file : lessons()) {
    CAPTURE(file.filename().string());
    LessonReading reading = readLesson(file);
    REQUIRE(reading.lesson);
    const auto lesson = std::make_shared<const Lesson>(*std::move(reading.lesson));
    ScriptedLearner learner(lesson, shipped, [&](const LearnerEvent& e) {
      if (e.kind == LearnerEvent::Kind::GaveUp || e.kind == LearnerEvent::Kind::Fault)
        FAIL_CHECK(file.filename().string()
                   << ":" << e.place.line << ": step '" << e.step << "', task " << e.index + 1 << ": " << e.note);
      if (e.kind == LearnerEvent::Kind::Question) CHECK(e.right);
    });
    CHECK(learner.demonstrate());
    learner.demonstrateStepsLeft();
    for (std::size_t s = 0; s < lesson->steps.size(); ++s) CHECK(learner.session().stepSeen(s));
    CHECK(learner.time_s() <= 60.0 * shownMinutes(*lesson).all);
  }
}
