// One lesson done twice in the same window under two names: what each student sees, and what the teacher receives.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/results/class_csv.h"
#include "engine/results/class_files.h"
#include "engine/results/class_page.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

constexpr std::size_t kChoices = 8, kPairs = 8;  // alike by chance: 1 in 40 320, and 1 in 65 536

std::string twoIdentitiesLessonText() {
  std::string choices = "- [x] Choice 0 → Yes.\n";
  for (std::size_t k = 1; k < kChoices; ++k) choices += "- [ ] Choice " + std::to_string(k) + " → No.\n";
  return "---\ntitle: Twice\nminutes: 1\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\nask: name\n---\n"
         "## One\n```scene\nmolecule: argon\n```\n### Question: Which?\n\n" +
         choices + "\n## Two\n```touch\nsame: anywhere\nprobe: 3 Å\ntrials: " + std::to_string(kPairs) +
         "\nfor: 0.1 s\nsay: Are they the same?\n```\n";
}

struct Met {
  std::vector<std::size_t> choices;  // from top to bottom
  std::string pairs;                 // A: the scene's own probe, B: the other
};

// As one who feels both and says what is so, by mouse.
std::string feelPairs(ScriptedUser& d) {
  LessonSession& session = *d.app().lesson.session();
  std::string out;
  for (std::size_t turn = 0; turn < 2 * kPairs && !session.task(0).done; ++turn) {
    out += session.taskStage().touch.has(&TouchSetup::probe_A) ? 'B' : 'A';
    d.point("view");
    d.press();
    for (int k = 0; k < 200 && session.taskAt(0)->buttons().empty(); ++k) d.frames(2);
    d.release();
    d.frames(10);
    const bool second = turn % 2 == 1;
    const char* const word = !second ? "task/0/next" : out[turn] == out[turn - 1] ? "task/0/same" : "task/0/different";
    REQUIRE(d.click(word));
    d.frames(10);
  }
  return out;
}

Met goThrough(ScriptedUser& d, const std::string& file, const std::string& name) {
  d.app().open(file);
  d.app().finishLoading();
  d.frames(20);
  REQUIRE(d.shows("name/field"));
  d.tap("Ctrl+A");
  d.type(name);
  REQUIRE(d.click("name/begin"));
  d.frames(20);
  CHECK(d.app().extensions().recorder.student() == name);
  LessonSession& session = *d.app().lesson.session();
  Met met;
  for (std::size_t k = 0; k < kChoices; ++k) met.choices.push_back(k);
  const auto top = [&](std::size_t k) { return widgets().find("question/0/" + std::to_string(k))->low.y; };
  std::sort(met.choices.begin(), met.choices.end(), [&](std::size_t a, std::size_t b) { return top(a) < top(b); });
  for (int k = 0; k < 20 && !widgets().find("question/0/0")->visible(); ++k) {
    d.tap("Ctrl+PageDown");
    d.frames(2);
  }
  REQUIRE(d.click("question/0/0"));
  d.frames(5);
  REQUIRE(session.question(0).answered_right);
  REQUIRE(d.click("lesson/next"));
  d.frames(20);
  met.pairs = feelPairs(d);
  CHECK(session.finished());
  REQUIRE(d.app().extensions().recorder.flush());
  return met;
}

TEST_CASE(
    "a lesson is gone through twice, by Ana and by Bo: the choices stand in another order, other pairs are felt, and "
    "the "
    "report lists both as finished, with one task and one question each") {
  const ScratchFolder scratch;
  const std::filesystem::path attempts = scratch.path / "attempts";
  writeFile(scratch.path / "twice.md", twoIdentitiesLessonText());
  ScriptedUser::Options options;
  options.application.attempts_folder = attempts;
  auto d = startWith("", std::move(options));
  const std::string file = (scratch.path / "twice.md").string();
  const Met ana = goThrough(*d, file, "Ana"), bo = goThrough(*d, file, "Bo");
  CHECK(ana.choices != bo.choices);
  CHECK(ana.pairs.size() == 2 * kPairs);
  CHECK(bo.pairs.size() == 2 * kPairs);
  CHECK(ana.pairs != bo.pairs);
  d.reset();  // what is kept is whole

  const std::array named{attempts};
  const ClassReading reading = readClass(named);
  CHECK(reading.passed_over.empty());
  const ClassSummary& summary = reading.summary;
  REQUIRE(summary.attempts == 2);
  CHECK(summary.people == std::vector<std::string>{"Ana", "Bo"});
  REQUIRE(summary.lessons.size() == 1);
  REQUIRE(summary.lessons[0].people.size() == 2);
  for (const PersonScore& p : summary.lessons[0].people) {
    CAPTURE(p.person);
    CHECK(p.finished());
    CHECK(p.of == 2);
    CHECK(p.firstRight() == 1);
    REQUIRE(p.tasks.size() == 1);
    CHECK(p.tasks.begin()->second.done);
  }
  const std::string csv = classCsv(summary), page = classPage(summary, {}, "now");
  for (const char* name : {"Ana", "Bo"}) {
    CAPTURE(name);
    CHECK(contains(csv, "\n" + std::string(name) + ",Twice,twice.md,"));
    CHECK(contains(page, name));
  }
}

}  // namespace
}  // namespace moltact
