// What docs/safety.md promises of the force, judged tick by tick by rules that share nothing with the safety stage. Any one
// thread, also the haptic one. Units: newton; time in ticks.
#pragma once

#include <algorithm>

#include "engine/core/units.h"

namespace moltact {

class ForceJudge {
 public:
  static constexpr double kSlew_N = 1.0;   ///< from tick to tick
  static constexpr int kSoft_ticks = 500;  ///< from nothing to the peak
  static constexpr int kFadeTo_ticks = 44; ///< after the last fresh place there is none: 40 ms, and a way down of 4

  explicit ForceJudge(double peak_N) : peak_N_(peak_N) {}

  /// Another device's peak: nothing has been given to it.
  void setPeak(double peak_N) { peak_N_ = peak_N, last_N_ = Vec3(0.0); }
  /// A fault, or what begins anew: what is left of the force goes away along the slew, and comes back no faster than softly.
  void expectSoft() { before_N_ = glm::length(last_N_), since_ = 0; }
  /// While a fault lasts nothing comes back.
  void lasting(bool on) { lasting_ = on; }

  struct Tick {
    bool fresh = true;      ///< the place was
    bool connected = true;  ///< the device was
    bool stopped = false;   ///< by the panic key
  };
  /// The promise that this tick's force breaks; null: none.
  const char* judge(const Vec3& force_N, const Tick& tick) {
    const Vec3 was_N = last_N_;
    const double size = glm::length(force_N);
    last_N_ = force_N;
    ++since_;
    stale_ = tick.fresh ? 0 : stale_ + 1;
    if (!finite(force_N)) return "the force is not finite";
    if (size > peak_N_ + kRounding) return "over the greatest force";
    if ((tick.stopped || !tick.connected) && size > 0.0) return tick.stopped ? "force after the panic key" : "force for a device that is gone";
    if (!tick.stopped && tick.connected && glm::distance(force_N, was_N) > kSlew_N + kRounding) return "the force changed too fast";
    const double soft_N = lasting_ ? 0.0 : peak_N_ * since_ / kSoft_ticks;
    if (size > std::max(0.0, before_N_ - kSlew_N * since_) + soft_N + kRounding) return "more force than softly after a fault";
    if (stale_ > kFadeTo_ticks && size > 0.0) return "force at a stale place";
    return nullptr;
  }

 private:
  static constexpr double kRounding = 1e-9;

  double peak_N_;
  Vec3 last_N_{0.0};
  double before_N_ = 0.0;
  double since_ = 0.0, stale_ = 0.0;
  bool lasting_ = false;
};

}  // namespace moltact
