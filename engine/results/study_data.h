// Gathers the attempts of a study (docs/study.md) by student and part, from which the table and the page are made. Any
// thread but the haptic one.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/results/attempt_file.h"
#include "engine/results/study_statistics.h"

namespace moltact {

/// One question or task of a part, as its outline states it.
struct StudyItem {
  std::size_t step = 0;  ///< index
  bool task = false;
  std::size_t index = 0;  ///< of the question or task in the step
  std::string id;         ///< "step/question" or "step/task 1", of the first attempt
};

/// A lesson or test of the study. All languages and conditions of a lesson are one part.
struct StudyPartOutline {
  std::string part;                  ///< "pre", "lesson", "post", "delayed"
  LessonOutline lesson;              ///< of the first attempt
  std::vector<StudyItem> questions;  ///< in the order of the text
  bool test() const { return lesson.test; }
};

/// A student's answer to a question. Of a test, the last answer counts, of a lesson the first one.
struct StudyAnswer {
  std::vector<std::size_t> chosen;
  std::string written;
  bool right = false;
  int tries = 0;
  double seconds = 0.0;  ///< of use, from the previous answer or the step's beginning to the first answer
  InputKind by = InputKind::Mouse;
};

struct StudyTask {
  std::string step;
  std::size_t index = 0;
  std::string kind;
  bool solved = false;
  double took_s = 0.0;
  InputKind by = InputKind::Mouse;
  std::vector<LoggedFigure> figures;
};

/// What one student did in one part.
struct StudyScore {
  std::string began;
  std::size_t attempts = 0;
  std::string condition, group;
  std::map<std::size_t, StudyAnswer> answers;  ///< by the index of StudyPartOutline::questions
  std::vector<StudyTask> tasks;
  double time_s = 0.0, touch_s = 0.0, peak_N = 0.0, path_A = 0.0;
  std::size_t touches = 0, hints = 0;

  std::size_t right() const;
};

struct StudyStudent {
  std::string name;   ///< the code, or "(no code 1)"
  std::string group;  ///< empty if no part states one
  std::map<std::string, StudyScore> parts;
  /// The share of right answers in a test; no value if the student has not begun it.
  std::optional<double> share(const StudyPartOutline& part) const;
};

struct StudyData {
  std::string name;
  std::vector<StudyPartOutline> parts;   ///< pre, lessons, post, delayed
  std::vector<StudyStudent> students;    ///< in the order of their names
  std::vector<std::string> groups;       ///< ascending
  std::vector<std::string> conditions;   ///< of each group
  std::vector<std::string> notes;        ///< what a reader must know: repeated tests, students in two groups
  std::size_t attempts = 0, others = 0;  ///< of the study; of no study

  const StudyPartOutline* find(const std::string& part) const;
  /// The answers of a group ("": all) to a test, and who gave them. An item without an answer counts as wrong.
  AnswerMatrix answers(const StudyPartOutline& part, const std::string& group = "") const;
};

/// Adds attempts one by one, in the order in which they began.
class StudyCount {
 public:
  /// `anonymous`: codes are replaced by S01, S02 … in the order of the attempts. Typed texts are left out, but for right
  /// answers and numbers, and the time at which somebody began is reduced to the day.
  explicit StudyCount(bool anonymous = false) : anonymous_(anonymous) {}
  void add(const Attempt& attempt);
  /// Call it once. Returns a Problem if the attempts belong to no study, or to several.
  Expected<StudyData> finish();

 private:
  std::string nameOf(const std::string& student);

  bool anonymous_;
  StudyData out_;
  std::vector<std::string> studies_;
  std::map<std::string, std::string> names_;
  std::map<std::string, std::size_t> students_;  // by name
  std::size_t nameless_ = 0;
};

}  // namespace moltact
