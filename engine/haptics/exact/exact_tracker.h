#pragma once
#include <memory>

#include "engine/haptics/ball_scene.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class ExactTracker final : public Tracker {
 public:
  ExactTracker(std::shared_ptr<const BallScene> scene, double probe_A) : scene_(std::move(scene)), probe_(probe_A) {}
  Contact step(PointA hip) noexcept override { return {.scp = hip}; }
  void reset() noexcept override {}
  void setProbe(double probe_A) noexcept override { probe_ = probe_A; }
  double probe_A() const noexcept override { return probe_; }
  Footprint footprint() const noexcept override { return {}; }

 private:
  std::shared_ptr<const BallScene> scene_;
  double probe_;
};

}  // namespace moltact
