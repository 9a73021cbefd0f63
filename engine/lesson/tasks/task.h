// A touch task under way: a small state machine that is fed with servo samples and says how far the student has come.
// Deterministic: the same samples give the same states. Used on the screen's thread; samples may come at any rate from
// 30 Hz up (at 1 kHz nothing is missed). Once done, a task stays done.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/lesson/lesson.h"
#include "engine/lesson/touch_sample.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// Samples farther apart than this (unit: second) say nothing about the time between them, so that time is not counted.
inline constexpr double kLongestGap_s = 0.25;

/// How long a touch must last to count (unit: second): too short to notice, long enough that a graze does not count.
inline constexpr double kTouch_s = 0.1;

/// A slip shorter than this (unit: second) does not interrupt a touch: hands tremble.
inline constexpr double kSlip_s = 0.3;

class Task {
 public:
  virtual ~Task() = default;

  /// One tick. Samples whose time does not advance, or with a time or force that is not finite, are passed over, as is
  /// everything after the task is done.
  void feed(const TouchSample& sample);

  bool done() const { return done_; }
  /// 0 to 1; 1 exactly when done.
  double progress() const { return done_ ? 1.0 : progress_; }
  /// One sentence for the student: what is going on and what to do next. The author's praise when done.
  std::string sentence() const;

  /// Forgets everything, as at the start.
  virtual void reset();

 protected:
  explicit Task(const TaskSpec& spec) : praise_(spec.values["praise"].text) {}

  /// One good tick; `dt_s` is the time since the last one, 0 for the first and after a gap.
  virtual void take(const TouchSample& sample, double dt_s) = 0;
  /// The sentence while the task is under way.
  virtual std::string guidance() const = 0;

  void setProgress(double progress);
  void finish() { done_ = true; }

 private:
  std::string praise_;
  double progress_ = 0.0, last_time_s_ = 0.0;
  bool done_ = false, started_ = false, inside_ = false;
};

/// The atoms that a task is about.
class AtomSet {
 public:
  /// An absent selection stands for every atom.
  AtomSet(const Selection& selection, const Molecule& molecule);
  bool has(std::int32_t atom) const {
    return all_ ? atom >= 0 : atom >= 0 && static_cast<std::size_t>(atom) < in_.size() && in_[static_cast<std::size_t>(atom)];
  }
  /// Whether the contact rests on at least one of them.
  bool touchedBy(const Contact& contact) const;
  /// Whether every atom that holds the contact is one of them.
  bool holds(const Contact& contact) const;
  std::size_t count() const { return count_; }

 private:
  std::vector<char> in_;
  std::size_t count_ = 0;
  bool all_ = false;
};

/// Counts how long something has lasted, forgiving short slips.
class Stopwatch {
 public:
  /// Adds a tick; a break longer than `slip_s` starts the count again. Gives true when that happened now.
  bool tick(bool lasting, double dt_s, double slip_s);
  double elapsed_s() const { return elapsed_s_; }
  void restart() { elapsed_s_ = away_s_ = 0.0; }

 private:
  double elapsed_s_ = 0.0, away_s_ = 0.0;
};

/// The name of a task's target in the middle of a sentence: `called`, or made from the selection or the feature in `key`.
std::string targetName(const TaskSpec& spec, std::string_view key);

/// "sphere" -> a single atom's sphere, "crease" -> a circle, "pit" -> a point.
bool isFeature(std::string_view word, Feature feature);

/// "0.35 N" and "1.2 s": two digits and one after the point.
std::string forceText(double force_N);
std::string timeText(double time_s);

}  // namespace moltact
