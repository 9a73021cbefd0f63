// The motion of a scene's spheres in a recording of the servo loop (servo_recording.h), and its reconstruction, which is
// identical to the last bit. Not for the haptic thread. Units: angstrom, tick.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/haptics/sphere_motion.h"
#include "engine/servo/servo_step.h"

namespace moltact {

struct RecordedMotion {
  int ticks = 0;
  /// The spheres at the start; empty: the motion begins where the recorded motion before it ends.
  std::vector<Sphere> from;
  struct Change {
    Vec3 displacement_A{0.0};
    double growth_A = 0.0;
  };
  std::vector<Change> changes;  ///< one for each sphere
};

/// The motion as it is recorded; `before` is the motion recorded before it (null: none).
RecordedMotion recordedMotion(const SphereMotion& motion, const SphereMotion* before);

/// The bytes of a motion: 24 for each sphere, 32 more where `from` is given, 8 more where spheres grow.
std::string bytesOf(const RecordedMotion& motion);
/// Empty for bytes that bytesOf() does not write. The values are not checked.
std::optional<RecordedMotion> motionOfBytes(std::string_view bytes);

std::string bytesOf(std::span<const Sphere> spheres);
std::optional<std::vector<Sphere>> spheresOfBytes(std::string_view bytes);

/// Reconstructs the recorded motions, in their order.
class MotionReplay {
 public:
  /// `scene`: the spheres that moved. Both must outlive the object.
  MotionReplay(std::span<const RecordedMotion> motions, const SphereGrid& scene) : motions_(motions), scene_(scene) {}

  /// The phase of a tick: `number` is that of its motion, from 1, and `tick` counts the ticks of the motion; the spheres
  /// rest at number 0. Both may only grow. Empty if the motion cannot be reconstructed,
  /// or is not one of the scene's spheres.
  std::optional<MotionPhase> at(std::uint32_t number, std::int32_t tick);

 private:
  std::span<const RecordedMotion> motions_;
  const SphereGrid& scene_;
  std::uint32_t number_ = 0;
  std::unique_ptr<const SphereMotion> now_, before_;  // the interaction may read the replaced one in the next tick
};

}  // namespace moltact
