// A frame of spheres that move: where each is at the frame's beginning and at its end; between them it moves and grows
// evenly. The grid is built over the balls in which the spheres stay during the whole frame, so that it serves every
// tick of it. Built at a person's pace (14 000 spheres: about 2 ms, build/release/tracker_benchmark
// --benchmark_filter=frame); immutable afterwards, so every thread may read it. Units: angstrom.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/ball.h"
#include "engine/core/problem.h"
#include "engine/haptics/ball_scene.h"

namespace moltact {

class SphereFrame {
 public:
  /// The frame takes `ticks` ticks (1 to kMostTicks). A Problem where the two lists are not as long as each other, or
  /// hold what is no place or radius (not finite, farther than kFarthest_A, negative).
  static Expected<std::unique_ptr<const SphereFrame>> make(std::span<const Ball> from, std::span<const Ball> to,
                                                           int ticks);
  static constexpr int kMostTicks = 10'000;
  /// The frame that goes on from where another ends.
  static Expected<std::unique_ptr<const SphereFrame>> after(const SphereFrame& before, std::span<const Ball> to,
                                                            int ticks);
  /// Made by after() of that frame.
  bool follows(const SphereFrame& other) const { return follows_ == other.serial_; }
  /// No surface moves farther within the frame.
  double mostMoved_A() const { return most_moved_; }

  /// One of its own for each frame of a program's run, from 1 on.
  std::uint64_t serial() const { return serial_; }
  int ticks() const { return ticks_; }
  std::size_t size() const { return spheres_.size(); }

  /// A sphere's beginning and what it moves and grows by within the frame.
  struct Moving {
    Ball from;
    Vec3 way_A{0.0};
    double growth_A = 0.0;
    double moved_A() const { return glm::length(way_A) + std::abs(growth_A); }
    Ball at(double share) const { return {from.centre_A + way_A * share, from.radius_A + growth_A * share}; }
  };
  const Moving& operator[](std::size_t i) const { return spheres_[i]; }
  /// All of them at a share (0 to 1) of the frame.
  std::vector<Ball> at(double share) const;

  /// The balls that hold each sphere during the frame, by the same indices.
  const BallScene& bounds() const { return bounds_; }
  std::size_t bytes() const { return spheres_.capacity() * sizeof(Moving) + bounds_.bytes(); }

 private:
  SphereFrame(std::vector<Moving> spheres, std::vector<Ball> bounds, int ticks, double most_moved_A);

  std::vector<Moving> spheres_;
  BallScene bounds_;
  int ticks_;
  double most_moved_;
  std::uint64_t serial_, follows_ = 0;  // of this frame and of the one before; 0: none
};

}  // namespace moltact
