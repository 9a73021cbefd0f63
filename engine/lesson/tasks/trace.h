// Common base of the two forms of the task trace: measures how far the hand is off the path and how often it lost
// contact. The paths are in trace.cpp (from atom to atom) and trace_crease.cpp (along creases). Units: angstrom,
// second.
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
    double off_A = 0.0;  // distance of the contact point from the path
    bool on = false;     // on the part of the path that is to be followed now
  };

  /// The present slide over the surface.
  Slide slide_;
  /// The hand has made contact in this tick.
  bool put_down_ = false;

  /// Advances along the path if the contact point is on it within the tolerance.
  virtual Step follow(const Contact& contact, double probe_A, double within_A) = 0;
  virtual bool begun() const = 0;
  virtual double covered() const = 0;  // share of the path, 0 to 1
  virtual void forget() = 0;
  virtual Begin begin() const = 0;
  /// The words for what must be touched first, if the author gave no name.
  virtual const char* unnamed() const;

 private:
  void onSample(const TouchSample& s, double dt_s) override;

  void letGo();

  std::string guidance() const override;

  // The author's name of the path.
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

/// Makes the task `trace: crease`.
std::unique_ptr<Task> makeTraceCrease(const TaskSpec& spec, const Molecule& molecule);

}  // namespace moltact
