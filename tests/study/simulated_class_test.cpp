// Simulated classes through the whole pipeline: files as the program writes them, the table, the page. Oracle for the
// share of studies that find an effect: the power from the noncentral t distribution.
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include "engine/lesson/reader.h"
#include "engine/results/attempt_lines.h"
#include "engine/results/attempt_log.h"
#include "engine/results/class_files.h"
#include "engine/results/study_csv.h"
#include "engine/results/study_page.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// Before: 3 of 12 right, with a standard deviation of 1. The gain has 3 and 1.5. Rounding to whole answers adds a
// variance of 1/12, and the limits 0 and 12 lie 3 standard deviations away.
constexpr double kPre = 3.0, kPreSd = 1.0, kGain = 3.0, kGainSd = 1.5;
const double kOutcomeSd = std::sqrt(kGainSd * kGainSd + 1.0 / 12.0);

LessonOutline outlineFor(const std::string& part, const std::string& group) {
  const LessonReading reading = readLesson(MOLTACT_SOURCE_DIR "/assets/studies/surface-and-probe.md");
  REQUIRE(reading.lesson);
  LessonOutline out = outlineOf(*reading.lesson, "0");
  out.study = {"simulated", part, group};
  out.file = part + "-surface-and-probe.md";
  if (group == "eyes") out.condition = Condition::Look;
  return out;
}

// Lessons without questions have only a step.
LessonOutline lessonFor(const std::string& group) {
  LessonOutline out{"lesson.md", "Lesson", "0", {{"one", "One", {{"reach", "Touch it."}}, {}}}};
  out.condition = group == "eyes" ? Condition::Look : Condition::Touch;
  out.study = {"simulated", "lesson", group};
  return out;
}

class SimulatedClass {
 public:
  SimulatedClass(std::uint64_t seed, double effect) : random_(seed), effect_(effect) {}

  // Attempts of 2 x n students at the test before and after; with `lessons` also at the lesson.
  std::vector<Attempt> attempts(std::size_t n, bool lessons) {
    std::vector<Attempt> out;
    for (const char* group : {"hands", "eyes"}) {
      const LessonOutline &pre = outlines(group)[0], &post = outlines(group)[1];
      for (std::size_t k = 0; k < n; ++k) {
        const std::string code = group + std::to_string(k + 1);
        const int before = whole(kPre, kPreSd, 0, 12);
        const double shift = std::string_view(group) == "hands" ? effect_ * kOutcomeSd : 0.0;
        const int after = std::clamp(before + whole(kGain + shift, kGainSd, -12, 24), 0, 12);
        out.push_back(test(pre, code, before, "2026-11-02T08:00:00Z"));
        if (lessons) out.push_back(lesson(lessonFor(group), code));
        out.push_back(test(post, code, after, "2026-11-02T09:00:00Z"));
      }
    }
    return out;
  }

 private:
  static const std::array<LessonOutline, 2>& outlines(std::string_view group) {
    static const std::array<LessonOutline, 2> hands{outlineFor("pre", "hands"), outlineFor("post", "hands")};
    static const std::array<LessonOutline, 2> eyes{outlineFor("pre", "eyes"), outlineFor("post", "eyes")};
    return group == "hands" ? hands : eyes;
  }
  int whole(double mean, double sd, int low, int high) {
    return std::clamp(int(std::lround(std::normal_distribution<double>(mean, sd)(random_))), low, high);
  }
  Attempt test(const LessonOutline& outline, const std::string& code, int right, const std::string& began) {
    Attempt out;
    out.header = {kAttemptFormat, "test", began, code, "Mouse", false, outline};
    std::vector<char> answers(outline.steps.size(), 0);
    std::fill_n(answers.begin(), right, char(1));
    std::shuffle(answers.begin(), answers.end(), random_);
    double t_s = 0.0;
    for (std::size_t s = 0; s < outline.steps.size(); ++s) {
      const StepOutline& step = outline.steps[s];
      const QuestionOutline& question = step.questions[0];
      out.events.push_back({t_s, StepEntered{step.id}});
      t_s += 10.0 + double(random_() % 300) / 10.0;
      std::size_t chosen = question.right[0];
      // Some students change an answer: the last one counts.
      const bool changes = random_() % 10 == 0;
      if (changes) out.events.push_back({t_s, answer(step, question, 1, (chosen + answers[s]) % 4, !answers[s])});
      if (changes) t_s += 3.0;
      if (!answers[s]) chosen = (chosen + 1 + random_() % 3) % 4;
      out.events.push_back({t_s, answer(step, question, 1 + changes, chosen, answers[s] != 0)});
    }
    out.events.push_back({t_s, ProgressMade{outline.steps.back().id, 12, 12}});
    out.events.push_back({t_s, SessionClosed{began}});
    return out;
  }
  static Answered answer(const StepOutline& step, const QuestionOutline& question, int attempt, std::size_t chosen,
                         bool right) {
    return {step.id, question.id, attempt, {chosen}, {}, right, InputKind::Mouse};
  }
  Attempt lesson(const LessonOutline& outline, const std::string& code) {
    Attempt out;
    out.header = {kAttemptFormat, "test", "2026-11-02T08:20:00Z", code, "Mouse", false, outline};
    const double whole_s = 900.0 + double(random_() % 600);
    out.events.push_back({0.0, StepEntered{"one"}});
    if (outline.condition == Condition::Touch) {
      out.events.push_back({1.0, TaskBegun{"one", 0}});
      out.events.push_back({10.0, TouchBegan{{1}}});
      out.events.push_back({40.0, TouchEnded{10.0, {1}, 2, 1.5, 0.7, 25.0, InputKind::Mouse}});
      out.events.push_back({40.0, TaskDone{"one", 0, 39.0, InputKind::Mouse, {{"mean force", 0.7, "N"}}}});
    }
    out.events.push_back({whole_s, SessionClosed{"2026-11-02T08:40:00Z"}});
    return out;
  }

  std::mt19937_64 random_;
  double effect_;
};

StudyData dataOf(const std::vector<Attempt>& attempts) {
  StudyCount count;
  for (const Attempt& a : attempts) count.add(a);
  Expected<StudyData> out = count.finish();
  REQUIRE(out);
  return *std::move(out);
}

struct FolderOfClass {
  fs::path path = fs::temp_directory_path() / ("moltact-class-" + std::to_string(::getpid()));
  FolderOfClass() { fs::create_directories(path); }
  ~FolderOfClass() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

std::size_t linesOf(const std::string& text) { return std::size_t(std::count(text.begin(), text.end(), '\n')); }

}  // namespace

TEST_CASE("a simulated class goes through files, table and page, and the figures are those of its numbers") {
  const std::uint64_t seed = 2026;
  const std::size_t n = 24;
  const std::vector<Attempt> attempts = SimulatedClass(seed, 0.5).attempts(n, true);
  FolderOfClass folder;
  // MOLTACT_SIMULATED_CLASS=FOLDER keeps the files, for a look at the page.
  if (const char* kept = std::getenv("MOLTACT_SIMULATED_CLASS")) folder.path = kept;
  fs::create_directories(folder.path);
  for (std::size_t k = 0; k < attempts.size(); ++k) {
    std::ofstream out(folder.path / ("a" + std::to_string(k) + ".jsonl"), std::ios::binary);
    out << lineOf(attempts[k].header);
    for (const AttemptEvent& e : attempts[k].events) out << lineOf(e);
  }
  StudyCount count;
  const std::vector<fs::path> named{folder.path};
  CHECK(forEachAttempt(named, [&](const Attempt& a) { count.add(a); }).empty());
  const Expected<StudyData> study = count.finish();
  REQUIRE(study);
  if (std::getenv("MOLTACT_SIMULATED_CLASS")) folder.path.clear();
  CHECK(study->name == "simulated");
  CHECK(study->groups == std::vector<std::string>{"eyes", "hands"});
  CHECK(study->conditions == std::vector<std::string>{"look", "touch"});
  CHECK(study->students.size() == 2 * n);
  CHECK(study->attempts == 6 * n);
  CHECK(study->notes.empty());
  REQUIRE(study->parts.size() == 3);
  CHECK(study->parts[1].part == "lesson");

  const std::string csv = studyCsv(*study);
  // The same from memory, without files.
  CHECK(csv == studyCsv(dataOf(attempts)));
  // A head; for each student 24 answers and 3 x 6 measures; for each of the group with touch a task and a figure.
  CHECK(linesOf(csv) == 1 + 2 * n * (24 + 18) + n * 2);
  CHECK(study->students[0].name == "eyes1");
  CHECK(linesOf(studyCodebook()) == 1 + 20 + 7 + 3);

  // Gains by hand from the attempts.
  std::vector<double> gains[2];
  for (std::size_t k = 0; k < attempts.size(); k += 3) {
    const auto score = [](const Attempt& a) {
      std::map<std::string, bool> last;
      for (const AttemptEvent& e : a.events)
        if (const auto* answered = std::get_if<Answered>(&e.what)) last[answered->step] = answered->right;
      return double(std::count_if(last.begin(), last.end(), [](const auto& l) { return l.second; })) / 12.0;
    };
    gains[k < 3 * n ? 0 : 1].push_back(score(attempts[k + 2]) - score(attempts[k]));
  }
  const std::vector<StudyComparison> comparisons = studyComparisons(*study);
  REQUIRE(comparisons.size() == 2);
  CHECK(comparisons[0].first == "hands");
  CHECK(comparisons[0].second == "eyes");
  const EffectSize expected = *hedgesG(gains[0], gains[1]);
  CHECK(comparisons[0].effect->g == doctest::Approx(expected.g).epsilon(1e-12));
  CHECK(comparisons[0].effect->difference == doctest::Approx(expected.difference).epsilon(1e-12));

  const std::string page = studyPage(*study, {}, "2026-11-28");
  for (const char* part : {"Normalised gain", "Hedges’ g", "R. R. Hake, Am. J. Phys. 66, 64 (1998)", "KR-20", "<svg",
                           "Time on task", "a molecule has one surface"})
    CHECK_MESSAGE(page.find(part) != std::string::npos, part);
  CHECK(page.find("<script") == std::string::npos);
}

TEST_CASE(
    "of 500 studies with an effect of 0.5 and 20 students per group as many find it as the noncentral t says, and "
    "without an effect 5 % do") {
  constexpr std::size_t kStudies = 500, kStudents = 20;
  for (const double effect : {0.5, 0.0}) {
    const double power = twoGroupPower(kStudents, kStudents, effect);
    std::size_t found = 0, covered = 0;
    double g = 0.0;
    const std::uint64_t first_seed = effect > 0.0 ? 1000 : 5000;
    for (std::uint64_t seed = first_seed; seed < first_seed + kStudies; ++seed) {
      const auto comparisons = studyComparisons(dataOf(SimulatedClass(seed, effect).attempts(kStudents, true)));
      const EffectSize& e = comparisons[0].effect.value();
      found += e.p < 0.05;
      covered += e.low <= effect && effect <= e.high;
      g += e.g / double(kStudies);
    }
    const double share = double(found) / double(kStudies), error = std::sqrt(power * (1.0 - power) / double(kStudies));
    MESSAGE("effect " << effect << ", seeds " << first_seed << " to " << first_seed + kStudies - 1 << ": found in "
                      << share << " of the studies, by theory in " << power << " ± " << error << "; mean g " << g
                      << "; the interval contains the effect in " << double(covered) / double(kStudies));
    CHECK(std::abs(share - power) < 3.0 * error);
    // The standard error of one g is 0.32, of the mean of 500 is 0.0145.
    CHECK(std::abs(g - effect) < 3.0 * 0.0145);
    CHECK(std::abs(double(covered) / double(kStudies) - 0.95) < 3.0 * std::sqrt(0.95 * 0.05 / double(kStudies)));
  }
}

TEST_CASE("a repeated test, a student in two groups and results of another study are told, not mixed in") {
  std::vector<Attempt> attempts = SimulatedClass(1, 0.0).attempts(3, false);
  Attempt again = attempts[0];
  for (AttemptEvent& e : again.events)
    if (auto* answered = std::get_if<Answered>(&e.what)) answered->right = true;
  again.header.began = "2026-11-03T08:00:00Z";
  const double before = *dataOf(attempts).students[3].share(dataOf(attempts).parts[0]);
  attempts.push_back(again);
  Attempt moved = attempts.back();
  moved.header.student = "eyes1";
  attempts.push_back(moved);
  Attempt none = attempts[0];
  none.header.lesson.study = {};
  attempts.push_back(none);
  const StudyData study = dataOf(attempts);
  CHECK(study.students[3].name == "hands1");
  CHECK(*study.students[3].share(study.parts[0]) == before);
  REQUIRE(study.notes.size() == 3);
  CHECK(study.notes[0] == "hands1 has done the test 'pre' more than once. The first time counts.");
  CHECK(study.notes[1] == "eyes1 has worked in the groups eyes and hands. The first one counts.");
  CHECK(study.others == 1);
  attempts[0].header.lesson.study.study = "another";
  StudyCount count;
  for (const Attempt& a : attempts) count.add(a);
  CHECK(count.finish().problem().message == "these attempts belong to several studies: another, simulated");
  CHECK_FALSE(StudyCount().finish());
}

}  // namespace moltact
