// A live class: who is where in which lesson, and what the teacher holds. It knows no socket, file or clock: the time is
// an argument (unit: second, of any monotonic clock), and every change is also returned as a record, a line of JSON, from
// which restore() builds the same class again after a stop. Any one thread at a time but the haptic one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/classroom/class_names.h"
#include "engine/results/attempt.h"

namespace moltact {

inline constexpr std::size_t kMaxStudents = 400;
inline constexpr std::size_t kMaxAttemptsOfStudent = 40;
inline constexpr std::size_t kMaxAttemptKey = 100;                        ///< characters
inline constexpr std::size_t kMaxClassLine = std::size_t{512} << 10;      ///< unit: byte
inline constexpr std::size_t kMaxBytesOfStudent = std::size_t{64} << 20;  ///< of all attempts; unit: byte
inline constexpr double kNotSeen_s = -1e9;
inline constexpr double kMaxAttemptTime_s = 1e9;
inline constexpr std::size_t kMaxKeptChoices = 64, kMaxKeptCurvePoints = 200;  ///< of an answer, of a curve
inline constexpr std::size_t kMaxKeptAnswers = 500, kMaxKeptCurves = 40;  ///< of an attempt, for the teacher's page

/// What the outline of a step does not tell.
struct ClassStep {
  std::vector<char> unseen_tasks;  ///< by task: done in the dark, without names, or in a scene that hides atoms
  std::vector<int> tries;          ///< by question: wrong answers after which the right one is shown; 0: never
};

/// A lesson that the teacher has chosen.
struct ClassLesson {
  std::string id;  ///< the file's name without ending and language: "first-touch"
  LessonOutline outline;
  std::vector<ClassStep> steps = {};  ///< by step
};

/// The latest answer of a student to a question.
struct LiveAnswer {
  std::vector<std::size_t> chosen;
  std::string written;
  bool right = false;
  int attempt = 1;  ///< 1 for the first answer to the question
};

/// An attempt as far as its lines have come. Steps, questions and tasks are numbers from 0, which are the same in every
/// language of a lesson. Times: second of use.
struct LiveAttempt {
  std::string key;              ///< as the student's page names it
  std::size_t lines = 0;        ///< lines taken, with the header
  std::uint32_t last_mark = 0;  ///< lineMark() of the last of them
  LessonOutline lesson;         ///< as the student reads it; empty before the header
  std::optional<std::size_t> step;
  double entered_s = 0.0, now_s = 0.0;
  struct Step {
    double spent_s = 0.0;  ///< in earlier visits
    bool entered = false;
    std::size_t hints = 0;
    std::vector<char> tasks_done;
  };
  std::vector<Step> steps;
  std::size_t done = 0, of = 0;
  std::map<std::pair<std::size_t, std::size_t>, LiveAnswer> answers;  ///< by step and question
  std::map<std::pair<std::size_t, std::size_t>, CurveKept> curves;    ///< drawn ones, by step and task

  bool finished() const { return of > 0 && done >= of; }
  std::size_t hints() const;
  /// Time on a step, over all visits.
  double spent_s(std::size_t at) const;
};

/// A plot of the class's predictions that the teacher shows to the class: of a question with choices, or of a task before
/// which students draw a force curve.
struct ShownPlot {
  std::string lesson;                ///< ClassLesson::id
  std::size_t step = 0, number = 0;  ///< of the question or the task in the step
  bool curve = false;                ///< of a task

  friend bool operator==(const ShownPlot&, const ShownPlot&) = default;
};

struct LiveStudent {
  std::string name, token;
  double joined_s = 0.0;              ///< first seen, after a restart too
  double seen_s = 0.0;                ///< of the caller's clock; kNotSeen_s after a restart
  std::vector<LiveAttempt> attempts;  ///< in the order in which they began
  std::size_t current = 0;            ///< the one that the last line belongs to
  std::size_t bytes = 0;
};

class ClassRoom {
 public:
  ClassRoom(std::vector<ClassLesson> lessons, std::uint64_t seed) : lessons_(std::move(lessons)), names_(seed) {}

  struct Joined {
    std::size_t student = 0;
    std::string record;
  };
  /// A new student; nothing if the class is full or over. `token` is kept as it is.
  std::optional<Joined> join(std::string_view name, std::string token, double now_s);

  /// The student who has this token. Takes the same time for every wrong token of a length.
  std::optional<std::size_t> studentOf(std::string_view token) const;
  void seen(std::size_t student, double now_s) {
    LiveStudent& one = students_[student];
    if (one.joined_s == kNotSeen_s) one.joined_s = now_s;
    one.seen_s = now_s;
  }

  enum class Refused {
    No,
    Gap,     ///< lines before `from` are missing, or lines from `from` on are there already and others are new
    Broken,  ///< a line is no line of an attempt, or the key no key
    Full,    ///< beyond the limits above
  };
  struct Taken {
    Refused refused = Refused::No;
    std::size_t have = 0;  ///< lines of this attempt that were taken, now and earlier
    std::string records;
  };
  /// Takes lines of an attempt. `from` is the number of the first one in the attempt. Lines that were all taken before are
  /// passed over. Either all lines are taken or none. The name in the header becomes the student's.
  Taken take(std::size_t student, std::string_view key, std::size_t from, const std::vector<std::string>& lines,
             double now_s);

  /// The mark of an attempt's last line, by which a page sees whether the lines are its own; nothing before the second line,
  /// because the header is rewritten.
  std::optional<std::uint32_t> lastMark(std::size_t student, std::string_view key) const;

  /// Nobody may go beyond this step of the lesson (ClassLesson::id), until it is opened. Empty if there is no such step.
  std::string hold(const std::string& lesson, std::size_t step);
  std::string open(const std::string& lesson);
  /// Shows this plot to the class instead of another. Empty if there is no such question or task.
  std::string show(const ShownPlot& plot);
  std::string hide();
  std::string end();

  /// Repeats a record, in the order in which they were made. False: it is none.
  bool restore(std::string_view record);

  const std::vector<ClassLesson>& lessons() const { return lessons_; }
  const std::vector<LiveStudent>& students() const { return students_; }
  const std::map<std::string, std::size_t>& held() const { return held_; }  ///< step by lesson
  const std::optional<ShownPlot>& shown() const { return shown_; }
  bool ended() const { return ended_; }
  /// Grows with every change that the teacher's page shows.
  std::uint64_t version() const { return version_; }

 private:
  void apply(LiveAttempt& attempt, std::string_view line);
  LiveAttempt& attemptOf(LiveStudent& student, std::string_view key);

  std::vector<ClassLesson> lessons_;
  NameBook names_;
  std::vector<LiveStudent> students_;
  std::map<std::string, std::size_t> held_;
  std::optional<ShownPlot> shown_;
  bool ended_ = false;
  std::uint64_t version_ = 0;
};

/// FNV-1a (32 bits) of a line's bytes; app/web/classroom.js computes the same.
std::uint32_t lineMark(std::string_view line);

/// A record of a line, in parts; nothing if it is another record. The views end with `record`.
struct LineRecord {
  std::size_t student = 0, attempt = 0;
  std::string_view line;  ///< without line end
};
std::optional<LineRecord> lineRecord(std::string_view record);

}  // namespace moltact
