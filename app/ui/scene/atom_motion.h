// Where the scene's atoms are: at rest as the molecule was read, on the way of a motion that the servo loop follows, or
// at other places. The picture and the searches for contacts follow the newest tick. Window's thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "app/ui/scene/motion_owner.h"
#include "app/ui/scene/servo_link.h"
#include "app/ui/scene/touchable_model.h"

namespace moltact {

class AtomMotion {
 public:
  explicit AtomMotion(ServoLink& servo) : servo_(servo) {}

  /// Its spheres are where the atoms are now; its molecule is as it was read.
  const TouchableModel& model() const { return model_; }
  /// As it was shown, before its atoms moved.
  const TouchableModel& resting() const { return resting_; }
  /// The molecule with its atoms where they are now, as it is drawn; null without one.
  const std::shared_ptr<const Molecule>& seen() const { return seen_ ? seen_ : model_.molecule; }

  /// Decides which source moves the atoms.
  MotionOwner owner;

  /// Another molecule, at rest.
  void begin(TouchableModel model);
  /// Moves the atoms evenly to these places (a sphere for each) in so many ticks. False while an earlier motion waits to
  /// begin, and where the places are none.
  bool move(const std::vector<Sphere>& to, int ticks);
  /// The atoms are at these places at once. The interaction must be made anew.
  void place(SharedArray<Sphere> at);
  /// Forgets the motion under way; the atoms stay where they are.
  void stop();
  /// Once a frame: lets the model and the picture follow the newest tick, in at most half of the window's time. Shapes
  /// that take long to make follow less often.
  void follow(double dt_s);
  /// Atoms are on a way that has not been drawn to its end.
  bool moving() const { return motion_ && !(seen_motion_ == motion_->serial() && seen_fraction_ == 1.0); }

 private:
  ServoLink& servo_;
  TouchableModel model_, resting_;
  std::shared_ptr<const Molecule> seen_;        // with its atoms where they are now; null: as it was read
  std::shared_ptr<const SphereMotion> motion_;  // the one handed over last
  std::uint64_t seen_motion_ = 0;               // where seen_ was taken from, and when
  double seen_fraction_ = 0.0, since_seen_s_ = 0.0, frame_after_s_ = 0.0;
};

}  // namespace moltact
