// Judges the force of each tick by the guarantees of docs/safety.md, with rules that share no code with the safety
// stage. Any one thread, including the haptic one. Units: newton; time in ticks.
#pragma once

#include <algorithm>

#include "engine/core/units.h"

namespace moltact {

class ForceMonitor {
 public:
  static constexpr double kSlew_N = 1.0;   ///< largest change of the force per tick
  static constexpr int kSoft_ticks = 500;  ///< duration of a soft start, from zero to the peak force
  /// After this time without a fresh position the force must be zero: 40 ms, plus 4 ms to ramp down.
  static constexpr int kFadeTo_ticks = 44;

  /// `peak_N`: peak force of the device, reached by a soft start in kSoft_ticks.
  explicit ForceMonitor(double peak_N) : peak_N_(peak_N), soft_N_(peak_N) {}

  /// Switches to another device with peak force `peak_N`, which has received no force yet.
  void otherDevice(double peak_N) { peak_N_ = peak_N, last_N_ = Vec3(0.0), expectSoft(); }
  /// A fault or a new start: the present force ramps down along the slew limit, and returns no faster than a soft
  /// start.
  void expectSoft() { before_N_ = glm::length(last_N_), since_ = 0; }
  /// While a fault lasts no force may return.
  void lasting(bool on) { lasting_ = on; }
  /// Ends the soft start; from now on only the other guarantees limit the force.
  void expectAny() { since_ = kSoft_ticks; }

  struct Tick {
    bool fresh = true;     ///< the position was fresh
    bool at_once = false;  ///< the force may end abruptly in this tick because of a fault; it then returns softly
    bool stopped = false;  ///< the force must be zero in this tick: the panic key, or a known fault
  };
  /// Returns the guarantee that this tick's force violates; null: none.
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

  double beforeFault_N() const { return before_N_; }  ///< size of the force at the last fault
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
