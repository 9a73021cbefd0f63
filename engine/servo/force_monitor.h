// What docs/safety.md promises of the force, judged tick by tick by rules that share nothing with the safety stage. Any
// one thread, also the haptic one. Units: newton; time in ticks.
#pragma once

#include <algorithm>

#include "engine/core/units.h"

namespace moltact {

class ForceMonitor {
 public:
  static constexpr double kSlew_N = 1.0;    ///< from tick to tick
  static constexpr int kSoft_ticks = 500;   ///< from nothing to the peak
  static constexpr int kFadeTo_ticks = 44;  ///< after the last fresh place there is none: 40 ms, and a way down of 4

  /// A soft start goes up to `peak_N` in kSoft_ticks.
  explicit ForceMonitor(double peak_N) : peak_N_(peak_N), soft_N_(peak_N) {}

  /// Another device is given force from now on, of which it bears so much: nothing has been given to it.
  void otherDevice(double peak_N) { peak_N_ = peak_N, last_N_ = Vec3(0.0), expectSoft(); }
  /// A fault, or what begins anew: what is left of the force goes away along the slew, and comes back no faster than
  /// softly.
  void expectSoft() { before_N_ = glm::length(last_N_), since_ = 0; }
  /// While a fault lasts nothing comes back.
  void lasting(bool on) { lasting_ = on; }
  /// What came back is at rest: from here on any force within the rest of the promises.
  void expectAny() { since_ = kSoft_ticks; }

  struct Tick {
    bool fresh = true;     ///< the place was
    bool at_once = false;  ///< the force may end in this tick, for something is wrong; then it comes back softly
    bool stopped = false;  ///< the same, and has to: by the panic key, or where it is known that something is wrong
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
    if (tick.stopped && size > 0.0) return "force where it had to end at once";
    const bool ends = (tick.stopped || tick.at_once) && size == 0.0;
    if (glm::distance(force_N, was_N) > kSlew_N + kRounding) {
      if (!ends) return "the force changed too fast";
      before_N_ = since_ = 0.0;
    }
    const double soft_N = lasting_ ? 0.0 : soft_N_ * since_ / kSoft_ticks;
    if (size > std::max(0.0, before_N_ - kSlew_N * since_) + soft_N + kRounding)
      return "more force than softly after a fault";
    if (stale_ > kFadeTo_ticks && size > 0.0) return "force at a stale place";
    return nullptr;
  }

  double beforeFault_N() const { return before_N_; }  ///< what there was at the last fault
  double sinceFault_ticks() const { return since_; }

 private:
  static constexpr double kRounding = 1e-9;

  double peak_N_, soft_N_;
  Vec3 last_N_{0.0};
  double before_N_ = 0.0, since_ = 0.0;
  int stale_ = 0;
  bool lasting_ = false;
};

}  // namespace moltact
