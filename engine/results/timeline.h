// An attempt prepared for playback: the hand, the scene and the view at any time, and the marks of events. Any thread
// but the haptic one. Units: angstrom, newton; second of use, which is the time since the attempt began without the
// time when the program was closed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/results/attempt_file.h"

namespace moltact {

/// An event, for the bar below the picture.
struct TimelineMark {
  enum class Kind : std::uint8_t { Step, Task, Right, Wrong, Hint };
  double t_s = 0.0;
  Kind kind = Kind::Step;
  std::string text;  ///< "One atom", "done: Touch the argon atom.", "answered: Two"
};

class Timeline {
 public:
  /// The attempt must have been read completely (ReadDepth::All).
  explicit Timeline(Attempt attempt);

  const AttemptHeader& header() const { return header_; }
  double length_s() const { return length_s_; }
  /// In chronological order.
  const std::vector<TimelineMark>& marks() const { return marks_; }

  /// The hand at a time, linearly interpolated between two HIP samples; the contact is the earlier sample's. No value
  /// before the first sample.
  std::optional<HipSample> hand(double t_s) const;
  /// The scene at that time; null before the first molecule.
  const StageChanged* stage(double t_s) const;
  /// The position of the atoms, for the scene at that time; null if nothing moves them.
  const AtomsMoved* atoms(double t_s) const;
  /// The view; null if it is unknown.
  const ViewChanged* view(double t_s) const;
  /// The time of the next motion of the hand or of the next mark; the end if there is none.
  double nextAfter(double t_s) const;
  InputKind input(double t_s) const;
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
  std::vector<At<AtomsMoved>> moves_;
  std::vector<At<ViewChanged>> views_;
  std::vector<At<InputKind>> inputs_;
  std::vector<TimelineMark> marks_;
  double length_s_ = 0.0;
};

}  // namespace moltact
