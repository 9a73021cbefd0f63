// Tracks which parts of a scrolled text the user has had time to see. A part counts after it has been in view without
// interruption for kMoment_s. A part higher than the view must fill it. Arithmetic only; window's thread. Units: pixel,
// second.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace moltact {

class SeenParts {
 public:
  static constexpr double kMoment_s = 0.3;

  /// A vertical range of the window.
  struct Span {
    float low = 0.0f, high = 0.0f;
  };

  /// Called once per frame for each part that is drawn. `view` is the visible range. If a part misses a frame, its time
  /// starts again.
  void note(std::string_view name, Span part, Span view, int frame, double now_s) {
    constexpr float kRounded_px = 1.0f;
    const float shown = std::min(part.high, view.high) - std::max(part.low, view.low);
    const bool in_view = shown >= std::min(part.high - part.low, view.high - view.low) - kRounded_px;
    Part& p = parts_[std::string(name)];
    if (!in_view || !p.in_view || p.frame + 1 < frame) p.since_s = now_s;
    p.in_view = in_view;
    p.frame = frame;
    p.ever = p.ever || (in_view && now_s - p.since_s >= kMoment_s);
  }
  /// Whether the part is in view and has been for kMoment_s, as of its last note().
  bool now(std::string_view name, double now_s) const {
    const auto at = parts_.find(name);
    return at != parts_.end() && at->second.in_view && now_s - at->second.since_s >= kMoment_s;
  }
  /// Whether the part has been in view for kMoment_s at any time since the last clear().
  bool ever(std::string_view name) const {
    const auto at = parts_.find(name);
    return at != parts_.end() && at->second.ever;
  }
  void clear() { parts_.clear(); }

 private:
  struct Part {
    double since_s = 0.0;
    int frame = -2;
    bool in_view = false, ever = false;
  };
  std::map<std::string, Part, std::less<>> parts_;
};

}  // namespace moltact
