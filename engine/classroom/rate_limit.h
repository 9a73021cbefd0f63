// Limits how often somebody may ask, by a token bucket. Pure; any one thread.
#pragma once

#include <algorithm>
#include <map>
#include <string>

namespace moltact {

/// `burst` requests at once, and `per_s` more each second.
struct RateLimit {
  double burst = 1.0, per_s = 1.0;
};

class RateBucket {
 public:
  /// Whether one more request is allowed now; it is then counted. `now_s` must not decrease.
  bool take(const RateLimit& limit, double now_s) {
    if (!begun_) level_ = limit.burst;
    level_ = std::min(limit.burst, level_ + (begun_ ? (now_s - last_s_) * limit.per_s : 0.0));
    begun_ = true;
    last_s_ = now_s;
    if (level_ < 1.0) return false;
    level_ -= 1.0;
    return true;
  }
  double last_s() const { return last_s_; }

 private:
  bool begun_ = false;
  double level_ = 0.0, last_s_ = 0.0;
};

/// A bucket for each address, of which at most kMaxAddresses are kept: the one that was quiet the longest is dropped.
class RateByAddress {
 public:
  explicit RateByAddress(RateLimit limit) : limit_(limit) {}
  bool take(const std::string& address, double now_s) {
    if (buckets_.size() >= kMaxAddresses && !buckets_.contains(address))
      buckets_.erase(std::min_element(buckets_.begin(), buckets_.end(), [](const auto& a, const auto& b) {
        return a.second.last_s() < b.second.last_s();
      }));
    return buckets_[address].take(limit_, now_s);
  }
  static constexpr std::size_t kMaxAddresses = 1024;

 private:
  RateLimit limit_;
  std::map<std::string, RateBucket> buckets_;
};

}  // namespace moltact
