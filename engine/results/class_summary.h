// The work of a class, counted from its attempts: plain numbers, from which the CSV and the page are written. Any
// thread but the haptic one. A person is a student's name, or an attempt where no name was given. Several attempts of a
// person at a lesson count together: the farthest progress, all the time, and of each question the first answer ever
// given.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/quantile.h"
#include "engine/results/attempt_file.h"

namespace moltact {

inline constexpr std::size_t kWays = 3;  ///< InputWay's values
using WayShares = std::array<double, kWays>;

/// The first answer that a person gave to a question, and how it went on; of a prediction and a free answer the last.
struct AnswerScore {
  AnswerKind kind = AnswerKind::Marked;
  std::vector<std::size_t> chosen;  ///< of the first answer
  std::string written;
  bool first_right = false, right = false;
  int tries = 0;                  ///< until the first right one, or all where there is none
  InputWay by = InputWay::Mouse;  ///< of the first answer
};

struct TaskScore {
  bool begun = false, done = false;
  double took_s = 0.0;
  InputWay by = InputWay::Mouse;
  std::vector<LoggedFigure> figures;
  /// The first curve drawn, and the last felt; null where there is none, as in most tasks of a hundred thousand attempts.
  std::shared_ptr<const CurveKept> drawn, felt;
  std::optional<double> first_sensitivity;  ///< d' of the first round of a task that is asked before and after
};

/// One person at one lesson.
struct PersonScore {
  std::string person;  ///< the name, or "(no name, 21 Nov 10:58)"
  bool named = false;
  std::string began;  ///< the first attempt's
  std::size_t attempts = 0;
  std::size_t done = 0, of = 0;  ///< of the attempt that came farthest
  std::string last_step;         ///< title of the step where the last attempt stands
  double time_s = 0.0;
  std::size_t hints = 0, touches = 0, crossings = 0;
  double touch_s = 0.0, peak_N = 0.0, mean_N = 0.0, path_A = 0.0;
  WayShares touch_ways_s{};  ///< time of touch with each way of input
  std::string device;        ///< of the last attempt
  bool gives_force = false;
  std::map<std::string, double> step_s;                                ///< by step id
  std::map<std::pair<std::string, std::string>, AnswerScore> answers;  ///< by step and question id
  std::map<std::pair<std::string, std::size_t>, TaskScore> tasks;      ///< by step id and index
  std::vector<Predicted> predictions;
  std::vector<std::string> steps_taken;               ///< ids of the steps in the order in which they were entered
  std::vector<WayTaken> rules;                        ///< by which answers changed it
  std::map<std::string, std::size_t> misconceptions;  ///< how often a choice with that tag was given

  double share() const { return of ? double(done) / double(of) : 0.0; }
  bool finished() const { return of > 0 && done >= of; }
  /// Of the questions that are marked, those answered, and those that the first answer was right to.
  std::size_t answered() const;
  std::size_t firstRight() const;
  /// The way that most of the touching was done with; of the answers where there was no touch; no value without either.
  std::optional<InputWay> way() const;
};

/// What a person, or several, did for one of the lesson's goals.
struct GoalScore {
  std::size_t parts = 0, done = 0;            ///< tasks, and questions of every kind
  std::size_t answered = 0, first_right = 0;  ///< of the questions that are marked
};
GoalScore goalScore(const LessonOutline& lesson, const PersonScore& person, std::size_t goal);

/// The sensitivity d' in the first round of a task that a lesson asks before and after its explanation.
struct SensitivityPair {
  std::optional<double> before, after;  ///< no value where the task has not been done
  /// No value unless both are known.
  std::optional<double> gain() const { return before && after ? std::optional(*after - *before) : std::nullopt; }
};
SensitivityPair sensitivityPair(const LessonOutline& lesson, const PersonScore& person);
/// Whether the lesson has a task that it asks before and after.
bool asksTwice(const LessonOutline& lesson);

struct LessonSummary {
  /// The lesson's file; with its title where another of the class has the same file name.
  std::string name;
  LessonOutline lesson;             ///< of the newest attempt
  std::size_t versions = 1;         ///< how many versions of the lesson's file the attempts were made with
  std::vector<PersonScore> people;  ///< by name
};

struct ClassSummary {
  std::vector<LessonSummary> lessons;      ///< by title
  std::vector<std::string> people;         ///< named ones first, then an entry for each attempt without a name
  std::size_t attempts = 0, nameless = 0;  ///< all attempts; those without a name, whose students cannot be counted
};

struct NamesShown {
  /// Names become "S01", "S02" …, in an order that tells nothing about the names.
  bool anonymous = false;
  /// With it they become codes that follow from it and the name, "S-4KQ7M": the same in every report with that word.
  /// Who knows the word can try names.
  std::string code_word = {};
};

/// Counts one attempt after another and keeps only the scores, so that a large class needs little memory. Lessons differ
/// by file name and title.
class ClassCount {
 public:
  explicit ClassCount(NamesShown names = {});
  ~ClassCount();
  ClassCount(const ClassCount&) = delete;
  ClassCount& operator=(const ClassCount&) = delete;

  /// In the order in which the attempts began.
  void add(const Attempt& attempt);
  /// Once, after the last.
  ClassSummary finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The same of attempts in any order.
ClassSummary summarise(std::vector<Attempt> attempts, const NamesShown& names = {});

/// How well a question tells those who do well in the rest of the lesson from those who do not: the correlation of its
/// first answers with the share of the person's other marked questions that were right at first (point-biserial). No
/// value where fewer than five people answered it and others, or all did alike.
std::optional<double> discrimination(const LessonSummary& lesson, const std::string& step, const std::string& question);

/// The way a person took: steps by their numbers, side paths as a1, a2 …, and behind a step in brackets what an answer in
/// it led to: "1 2 (after 2 wrong: a1) a1 2 3".
std::string wayText(const LessonOutline& lesson, const PersonScore& person);

/// "24 students, 2 lessons, 51 attempts"; with "3 of them without a name" where that is so.
std::string summaryText(const ClassSummary& summary);

}  // namespace moltact
