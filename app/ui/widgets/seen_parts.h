// Which parts of a text that scrolls a person has had the time to see: a part counts once it has been in view, wholly or
// as much of it as the view holds, for a moment without a break. Arithmetic only; window's thread. Units: pixel, second.
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

  /// A stretch of the window from top to bottom.
  struct Span {
    float low = 0.0f, high = 0.0f;
  };

  /// Once a frame for each part that is drawn. `view` is what the window shows. The frames of one part follow on one
  /// another, or it begins anew.
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
  /// It is in view and has been for a moment, as of its last note.
  bool now(std::string_view name, double now_s) const {
    const auto at = parts_.find(name);
    return at != parts_.end() && at->second.in_view && now_s - at->second.since_s >= kMoment_s;
  }
  /// It has been at some time since the last clear().
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
