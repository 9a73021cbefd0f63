#include "engine/bench/smaller_probe.h"

#include <algorithm>
#include <array>

#include "engine/haptics/exact/exact_tracker.h"

namespace moltact::bench {
namespace {

class SmallerProbe final : public Tracker {
 public:
  SmallerProbe(std::shared_ptr<const SphereGrid> scene, double probe_A, double less_A)
      : exact_(std::move(scene), std::max(0.0, probe_A - less_A)), less_A_(less_A), probe_A_(probe_A) {}

  Contact step(PointA hip) noexcept override { return exact_.step(hip); }
  void reset() noexcept override { exact_.reset(); }
  void setProbe(double probe_A) noexcept override {
    probe_A_ = probe_A;
    exact_.setProbe(std::max(0.0, probe_A - less_A_));
  }
  double probe_A() const noexcept override { return probe_A_; }
  bool setMotion(const SphereMotion* motion) noexcept override { return exact_.setMotion(motion); }
  void advanceTo(double fraction) noexcept override { exact_.advanceTo(fraction); }
  MemoryUsage memoryUsage() const noexcept override { return exact_.memoryUsage(); }

 private:
  ExactTracker exact_;
  double less_A_, probe_A_;
};

template <int thousandths_A>
std::unique_ptr<Tracker> make(std::shared_ptr<const SphereGrid> scene, double probe_A) {
  return std::make_unique<SmallerProbe>(std::move(scene), probe_A, 0.001 * thousandths_A);
}

constexpr std::array kFloor{
    Method{.name = "exact-0.001",
           .sentence = "exact with a probe 0.001 A smaller",
           .make = &make<1>,
           .family = {"Exact", {}},
           .grade = "probe 0.001 Å smaller",
           .follows_motion = true},
    Method{.name = "exact-0.02",
           .sentence = "exact with a probe 0.02 A smaller",
           .make = &make<20>,
           .family = {"Exact", {}},
           .grade = "probe 0.02 Å smaller",
           .follows_motion = true},
};

}  // namespace

std::span<const Method> noiseFloor() { return kFloor; }

}  // namespace moltact::bench
