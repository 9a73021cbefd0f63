// What the two forms of the task trace have in common: how far the hand is off the way, and how often it let go. The
// ways themselves are in trace.cpp (from atom to atom) and trace_crease.cpp (along creases). Units: angstrom, second.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/lesson/tasks/task.h"

namespace moltact {

class Trace : public Task {
 public:
  explicit Trace(const TaskSpec& spec);

  void reset() override;
  bool takesUpSlide() const override { return true; }

 protected:
  enum class State { Away, Elsewhere, On, Off, Lifted, Again };
  enum class Begin { Start, EitherEnd, Anywhere };

  struct Step {
    double off_A = 0.0;  // of the contact point from the way
    bool on = false;     // on the part of the way that is to be followed now
  };

  /// The stretch of surface that the hand slides over now.
  Slide slide_;
  /// The hand has been put down again since the tick before.
  bool put_down_ = false;

  /// Moves on along the way where the contact point is on it within the tolerance.
  virtual Step follow(const Contact& contact, double probe_A, double within_A) = 0;
  virtual bool begun() const = 0;
  virtual double covered() const = 0;  // 0 to 1
  virtual void forget() = 0;
  virtual Begin begin() const = 0;
  /// What is to be touched first, where the author gave it no name.
  virtual const char* unnamed() const;

 private:
  void onSample(const TouchSample& s, double dt_s) override;

  void letGo();

  std::string guidance() const override;

  // As the author called it.
  std::string name() const;
  std::string way() const;

  void measure(std::vector<TaskFigure>& out) const override;

  std::string called_;
  double within_A_ = 1.0, cover_ = 0.9;
  bool limited_ = false;
  int lifts_allowed_ = 0, lifts_ = 0;
  double away_s_ = 0.0, over_A_s_ = 0.0, on_s_ = 0.0, greatest_A_ = 0.0;
  State state_ = State::Away;
};

/// The task of 'trace: crease'.
std::unique_ptr<Task> makeTraceCrease(const TaskSpec& spec, const Molecule& molecule);

}  // namespace moltact
