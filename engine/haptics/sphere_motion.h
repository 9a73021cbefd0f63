// The motion of a scene's spheres from one snapshot to the next, for example between frames of a trajectory. Centres
// and radii are interpolated linearly. The grid contains, for each sphere, the bounding sphere of its whole motion, so
// that it serves every tick of the motion. Construction takes about 2 ms for 14 000 spheres
// (build/release/tracker_benchmark --benchmark_filter=frame) and does not run on the haptic thread. Immutable
// afterwards, so every thread may read it. Units: angstrom.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/sphere.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact {

class SphereMotion {
 public:
  /// Creates a motion of `ticks` ticks (1 to kMaxTicks). Returns a Problem if the two lists differ in length or contain
  /// an invalid sphere: not finite, farther than kMaxPosition_A, or of negative radius. The spheres of `untouchable`
  /// move but are not felt (as in SphereGrid), nor are those whose radius is 0 at both ends: they are gone.
  static Expected<std::unique_ptr<const SphereMotion>> make(std::span<const Sphere> from, std::span<const Sphere> to,
                                                            int ticks, std::span<const std::uint32_t> untouchable = {});
  static constexpr int kMaxTicks = 10'000;
  /// Creates the motion that starts where `before` ends.
  static Expected<std::unique_ptr<const SphereMotion>> after(const SphereMotion& before, std::span<const Sphere> to,
                                                             int ticks);
  struct Moving;
  /// Creates a motion from what operator[] returned, identical to the last bit; `before` is the motion that it continues
  /// (null: none).
  static Expected<std::unique_ptr<const SphereMotion>> make(std::vector<Moving> spheres, int ticks,
                                                            std::span<const std::uint32_t> untouchable,
                                                            const SphereMotion* before);
  /// True if this motion was created by after(other, ...), and the same spheres are felt.
  bool continues(const SphereMotion& other) const { return continues_ == other.serial_; }
  /// Upper bound of the motion of the surface of any sphere but those that are gone.
  double maxMotion_A() const { return max_motion_; }

  /// Unique number of this motion within the process, from 1.
  std::uint64_t serial() const { return serial_; }
  int ticks() const { return ticks_; }
  std::size_t size() const { return spheres_.size(); }

  /// A sphere at the start, and its displacement and growth during the motion.
  struct Moving {
    Sphere from;
    Vec3 displacement_A{0.0};
    double growth_A = 0.0;
    double moved_A() const { return glm::length(displacement_A) + std::abs(growth_A); }
    Sphere at(double fraction) const {
      return {from.centre_A + displacement_A * fraction, from.radius_A + growth_A * fraction};
    }
  };
  const Moving& operator[](std::size_t i) const { return spheres_[i]; }
  /// All spheres at a fraction (0 to 1) of the motion.
  std::vector<Sphere> at(double fraction) const;

  /// The bounding sphere of each sphere's motion, by the same indices.
  const SphereGrid& sweptSpheres() const { return bounds_; }
  std::size_t bytes() const {
    return spheres_.capacity() * sizeof(Moving) + bounds_.bytes() + untouchable_.capacity() * sizeof(std::uint32_t);
  }

 private:
  SphereMotion(std::vector<Moving> spheres, std::vector<Sphere> bounds, std::span<const std::uint32_t> untouchable,
               int ticks, double max_motion_A);

  std::vector<Moving> spheres_;
  SphereGrid bounds_;
  std::vector<std::uint32_t> untouchable_;  // of the scene; bounds_ has also those that are gone
  int ticks_;
  double max_motion_;
  std::uint64_t serial_, continues_ = 0;  // of this motion and of its predecessor; 0: none
};

}  // namespace moltact
