// The positions of the scene's atoms: as read, during a motion that the servo loop follows, or elsewhere. The picture
// and the searches for contacts follow the newest tick. Window's thread.
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

  /// The model; its spheres are at the atoms' present positions, its molecule is as it was read.
  const TouchableModel& model() const { return model_; }
  /// The model before its atoms moved.
  const TouchableModel& resting() const { return resting_; }
  /// The molecule with its atoms at their present positions, as drawn; null without one.
  const std::shared_ptr<const Molecule>& seen() const { return seen_ ? seen_ : model_.molecule; }

  /// The molecule as the picture shows it: seen(), or what the owner has shown since.
  const std::shared_ptr<const Molecule>& drawn() const { return drawn_ ? drawn_ : seen(); }
  /// Draws the atoms at these positions (one sphere for each) until others are seen; the felt ones follow by move().
  /// Returns false and does nothing in every second frame where frames take longer than kQuickFrame_s.
  bool show(const SharedArray<Sphere>& at);

  /// Decides which source moves the atoms.
  MotionOwner owner;

  /// Sets another molecule, at rest.
  void begin(TouchableModel model);
  /// Moves the atoms at constant speed to these positions (one sphere for each) within this number of ticks. Returns
  /// false while an earlier motion is waiting, or if the positions are invalid.
  bool move(const std::vector<Sphere>& to, int ticks);
  /// Moves the atoms there at once. The caller must rebuild the interaction.
  void place(SharedArray<Sphere> at);
  /// Stops the present motion; the atoms stay where they are.
  void stop();
  /// Called once per frame: updates model and picture to the newest tick. Where the frame after an update takes longer
  /// than kQuickFrame_s, because its shapes are expensive, in at most half of the window's time.
  void follow(double dt_s);
  /// Whether a motion of atoms has not been drawn to its end.
  bool moving() const { return motion_ && !(seen_motion_ == motion_->serial() && seen_fraction_ == 1.0); }
  static constexpr double kQuickFrame_s = 0.02;
  /// What show() has set is drawn for so many frames after the last call, if the felt atoms move meanwhile.
  static constexpr int kShown_frames = 10;

 private:
  bool tooSoon() const { return since_seen_s_ < (frame_after_s_ > kQuickFrame_s ? 2.0 : 1.0) * frame_after_s_ - 1e-9; }

  ServoLink& servo_;
  TouchableModel model_, resting_;
  std::shared_ptr<const Molecule> seen_;        // with its atoms at their present positions; null: as it was read
  std::shared_ptr<const Molecule> drawn_;       // what show() has set; null: seen()
  std::shared_ptr<const SphereMotion> motion_;  // the last one passed to the loop
  std::uint64_t seen_motion_ = 0;               // the motion and time of seen_
  double seen_fraction_ = 0.0, since_seen_s_ = 0.0, frame_after_s_ = 0.0, last_frame_s_ = 0.0;
  int frames_since_drawn_ = 2;
};

}  // namespace moltact
