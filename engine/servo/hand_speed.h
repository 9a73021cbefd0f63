// The hand's velocity from quantized positions: the displacement over the last kSpan ticks divided by their duration.
// One step of a sensor of 0.055 mm then counts as 7 mm/s instead of 55. Haptic thread. Units: metre, second.
#pragma once

#include <array>
#include <cstddef>

#include "engine/core/units.h"

namespace moltact {

class HandSpeed {
 public:
  static constexpr std::size_t kSpan = 8;

  void restart() noexcept { count_ = 0; }

  /// Adds a position, `dt_s` after the previous one.
  void add(const Vec3& place_m, double dt_s) noexcept {
    time_s_ += dt_s;
    ring_[next_] = {place_m, time_s_};
    next_ = (next_ + 1) % ring_.size();
    if (count_ < ring_.size()) ++count_;
  }

  Vec3 m_per_s() const noexcept {
    if (count_ < 2) return Vec3(0.0);
    const Entry& last = ring_[(next_ + ring_.size() - 1) % ring_.size()];
    const Entry& first = ring_[(next_ + ring_.size() - count_) % ring_.size()];
    const double span_s = last.time_s - first.time_s;
    return span_s > 0 ? (last.place_m - first.place_m) / span_s : Vec3(0.0);
  }

 private:
  friend struct StepState;  // step_state.cpp, which saves the state
  struct Entry {
    Vec3 place_m{0.0};
    double time_s = 0;
  };
  std::array<Entry, kSpan + 1> ring_{};
  std::size_t next_ = 0, count_ = 0;
  double time_s_ = 0;
};

}  // namespace moltact
