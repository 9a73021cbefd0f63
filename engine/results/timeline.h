// An attempt laid out in time, to be played back: where the hand was at any moment, what was on the stage, how it was
// seen, and the marks at which something happened. Any thread but the haptic one. Units: second of use, angstrom,
// newton.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/results/attempt_file.h"

namespace moltact {

/// Something that happened, for the line under the picture.
struct TimelineMark {
  enum class Kind : std::uint8_t { Step, Task, Right, Wrong, Hint };
  double t_s = 0.0;
  Kind kind = Kind::Step;
  std::string text;  ///< "One atom", "done: Touch the argon atom.", "answered: Two"
};

class Timeline {
 public:
  /// The attempt must have been read whole (ReadDepth::All).
  explicit Timeline(Attempt attempt);

  const AttemptHeader& header() const { return header_; }
  double length_s() const { return length_s_; }
  /// In order of time.
  const std::vector<TimelineMark>& marks() const { return marks_; }

  /// The hand at a moment, between two HIP samples on the straight line from one to the other; no value before
  /// the first. The contact is the earlier sample's.
  std::optional<HipSample> hand(double t_s) const;
  /// The stage at that moment; null before the first molecule.
  const StageChanged* stage(double t_s) const;
  /// Where the atoms were between two structures; null where there was one. Of the stage at that moment only.
  const StatesMoved* states(double t_s) const;
  /// How it was looked at; null where that is not known.
  const ViewChanged* view(double t_s) const;
  /// When the hand moves or a mark comes next; the end where there is neither.
  double nextAfter(double t_s) const;
  InputWay input(double t_s) const;
  /// The title of the step.
  std::string step(double t_s) const;

 private:
  template <class Fact>
  struct At {
    double t_s;
    Fact fact;
  };
  AttemptHeader header_;
  std::vector<HipSample> samples_;
  std::vector<At<StageChanged>> stages_;
  std::vector<At<StatesMoved>> states_;
  std::vector<At<ViewChanged>> views_;
  std::vector<At<InputWay>> inputs_;
  std::vector<TimelineMark> marks_;
  double length_s_ = 0.0;
};

}  // namespace moltact
