// How spheres move from one snapshot (a frame of a trajectory) to the next: where each is at the beginning and at the
// end; between them it moves and grows evenly. The grid is built over the spheres in which the spheres stay during the
// whole motion, so that it serves every tick of it. Built at a person's pace (14 000 spheres: about 2 ms,
// build/release/tracker_benchmark
// --benchmark_filter=frame); immutable afterwards, so every thread may read it. Units: angstrom.
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
  /// The motion takes `ticks` ticks (1 to kMaxTicks). A Problem where the two lists are not as long as each other, or
  /// hold what is no place or radius (not finite, farther than kFarthest_A, negative).
  /// The spheres of `untouchable` move, but nothing feels them (as in SphereGrid).
  static Expected<std::unique_ptr<const SphereMotion>> make(std::span<const Sphere> from, std::span<const Sphere> to,
                                                            int ticks, std::span<const std::uint32_t> untouchable = {});
  static constexpr int kMaxTicks = 10'000;
  /// The motion that goes on from where another ends.
  static Expected<std::unique_ptr<const SphereMotion>> after(const SphereMotion& before, std::span<const Sphere> to,
                                                             int ticks);
  /// Made by after() of that motion.
  bool continues(const SphereMotion& other) const { return continues_ == other.serial_; }
  /// No surface moves farther within the motion.
  double mostMoved_A() const { return most_moved_; }

  /// One of its own for each motion of a program's run, from 1 on.
  std::uint64_t serial() const { return serial_; }
  int ticks() const { return ticks_; }
  std::size_t size() const { return spheres_.size(); }

  /// A sphere's beginning and what it moves and grows by within the motion.
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
  /// All of them at a fraction (0 to 1) of the motion.
  std::vector<Sphere> at(double fraction) const;

  /// The spheres that hold each sphere during the motion, by the same indices.
  const SphereGrid& sweptSpheres() const { return bounds_; }
  std::size_t bytes() const { return spheres_.capacity() * sizeof(Moving) + bounds_.bytes(); }

 private:
  SphereMotion(std::vector<Moving> spheres, std::vector<Sphere> bounds, std::span<const std::uint32_t> untouchable,
               int ticks, double most_moved_A);

  std::vector<Moving> spheres_;
  SphereGrid bounds_;
  int ticks_;
  double most_moved_;
  std::uint64_t serial_, continues_ = 0;  // of this motion and of the one before; 0: none
};

}  // namespace moltact
