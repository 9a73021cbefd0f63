// Summarizes the attempts of a class as plain numbers, from which the CSV and the page are written. Any thread but the
// haptic one. A person is a student's name, or a single attempt without a name. Several attempts of a person at a
// lesson are combined: the greatest progress, the total time, and the first answer to each question.
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

inline constexpr std::size_t kInputKinds = 3;  ///< number of InputKind's values
using InputShares = std::array<double, kInputKinds>;

/// A person's first answer to a question, and the further tries. For predictions and free answers, the last answer
/// counts instead.
struct AnswerScore {
  AnswerKind kind = AnswerKind::Marked;
  std::vector<std::size_t> chosen;  ///< of the first answer
  std::string written;
  bool first_right = false, right = false;
  int tries = 0;                    ///< up to the first right one, or all if there is none
  InputKind by = InputKind::Mouse;  ///< of the first answer
};

struct TaskScore {
  bool begun = false, done = false;
  double took_s = 0.0;
  InputKind by = InputKind::Mouse;
  std::vector<LoggedFigure> figures;
  /// The first curve drawn and the last one felt; null in most tasks, because there may be a hundred thousand attempts.
  std::shared_ptr<const CurveKept> drawn, felt;
  std::optional<double> first_sensitivity;  ///< d' of the first round of a task that is asked before and after
};

/// One person's results in one lesson.
struct PersonScore {
  std::string person;  ///< the name, or "(no name, 21 Nov 10:58)"
  bool named = false;
  std::string began;  ///< the first attempt's
  std::size_t attempts = 0;
  std::size_t done = 0, of = 0;  ///< of the attempt with the greatest progress
  std::string last_step;         ///< title of the last attempt's current step
  double time_s = 0.0;
  std::size_t hints = 0, touches = 0, crossings = 0;
  double touch_s = 0.0, peak_N = 0.0, mean_N = 0.0, path_A = 0.0;
  InputShares touch_by_input_s{};  ///< time of touch by way of input
  std::string device;              ///< of the last attempt
  bool gives_force = false;
  std::map<std::string, double> step_s;                                ///< by step id
  std::map<std::pair<std::string, std::string>, AnswerScore> answers;  ///< by step and question id
  std::map<std::pair<std::string, std::size_t>, TaskScore> tasks;      ///< by step id and index
  std::vector<Predicted> predictions;
  std::vector<std::string> steps_taken;               ///< ids of the steps in the order of entry
  std::vector<OrderChanged> rules;                    ///< the rules by which answers changed the order of the steps
  std::map<std::string, std::size_t> misconceptions;  ///< number of choices with each tag

  double share() const { return of ? double(done) / double(of) : 0.0; }
  bool finished() const { return of > 0 && done >= of; }
  /// The numbers of marked questions that were answered, and that were answered right at the first try.
  std::size_t answered() const;
  std::size_t firstRight() const;
  /// The way of input with the longest touch, or without touch the one with the most answers. No value without both.
  std::optional<InputKind> input() const;
};

/// The results of one or more people for one of the lesson's goals.
struct GoalScore {
  std::size_t parts = 0, done = 0;            ///< tasks, and questions of every kind
  std::size_t answered = 0, first_right = 0;  ///< marked questions only
};
GoalScore goalScore(const LessonOutline& lesson, const PersonScore& person, std::size_t goal);

/// The sensitivity d' in the first round of a task that a lesson asks before and after its explanation.
struct SensitivityPair {
  std::optional<double> before, after;  ///< no value if the task has not been done
  /// No value unless both are known.
  std::optional<double> gain() const { return before && after ? std::optional(*after - *before) : std::nullopt; }
};
SensitivityPair sensitivityPair(const LessonOutline& lesson, const PersonScore& person);
/// Whether the lesson has a task that it asks before and after.
bool asksTwice(const LessonOutline& lesson);

struct LessonSummary {
  /// The lesson's file, with its title if another lesson of the class has the same file name.
  std::string name;
  LessonOutline lesson;             ///< of the newest attempt
  std::size_t versions = 1;         ///< number of versions of the lesson's file among the attempts
  std::vector<PersonScore> people;  ///< by name
};

struct ClassSummary {
  std::vector<LessonSummary> lessons;      ///< by title
  std::vector<std::string> people;         ///< named people first, then one entry for each attempt without a name
  std::size_t attempts = 0, nameless = 0;  ///< all attempts; those without a name, whose students cannot be counted
};

struct NamesShown {
  /// Names are replaced by "S01", "S02" …, in an order that does not depend on the names. Texts that students typed are
  /// left out, but for right answers and numbers, and the time at which somebody began is reduced to the day.
  bool anonymous = false;
  /// Without names: typed texts stay, with the names of the class's students replaced by their codes.
  bool typed_texts = false;
  /// With a code word, names are instead replaced by codes computed from the word and the name, "S-4KQ7M": the same in
  /// every report with that word. Someone who knows the word can test names.
  std::string code_word = {};
};

/// Adds attempts one by one and keeps only the scores, so that a large class needs little memory. Lessons are
/// distinguished by file name and title.
class ClassCount {
 public:
  explicit ClassCount(NamesShown names = {});
  ~ClassCount();
  ClassCount(const ClassCount&) = delete;
  ClassCount& operator=(const ClassCount&) = delete;

  /// Call it in the order in which the attempts began.
  void add(const Attempt& attempt);
  /// Call it once, after the last attempt.
  ClassSummary finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The same for attempts in any order.
ClassSummary summarise(std::vector<Attempt> attempts, const NamesShown& names = {});

/// The discrimination of a question: the point-biserial correlation between a right first answer and the share of the
/// person's other marked questions that were right at first. No value if fewer than five people answered it and others,
/// or if there is no variance.
std::optional<double> discrimination(const LessonSummary& lesson, const std::string& step, const std::string& question);

/// The steps a person took by their numbers; asides are a1, a2 …. Brackets after a step give the effect of an answer in
/// it: "1 2 (after 2 wrong: a1) a1 2 3".
std::string wayText(const LessonOutline& lesson, const PersonScore& person);

/// "24 students, 2 lessons, 51 attempts", with "3 of them without a name" if applicable.
std::string summaryText(const ClassSummary& summary);

}  // namespace moltact
