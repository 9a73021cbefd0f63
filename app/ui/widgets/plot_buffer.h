// The contents of a live plot: the newest values of a quantity sampled at equal intervals. Any one thread.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace moltact {

/// A ring buffer of `length` values; new values replace the oldest.
class PlotBuffer {
 public:
  explicit PlotBuffer(std::size_t length) : values_(length, 0.0f) {}
  /// A value that is not finite is stored as 0.
  void add(float value) {
    values_[next_] = std::isfinite(value) ? value : 0.0f;
    next_ = (next_ + 1) % values_.size();
    if (count_ < values_.size()) ++count_;
  }
  std::size_t size() const { return count_; }
  std::size_t capacity() const { return values_.size(); }
  /// The value `age` samples ago; 0 is the newest. `age` must be less than size().
  float ago(std::size_t age) const { return values_[(next_ + values_.size() - 1 - age) % values_.size()]; }

 private:
  std::vector<float> values_;
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace moltact
