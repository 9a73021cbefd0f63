// Statistics of frame times, for `--frame-stats`. Unit: millisecond.
#pragma once

#include <string>
#include <vector>

namespace moltact {

class FrameStats {
 public:
  void add(double frame_ms) { frames_ms_.push_back(frame_ms); }
  /// One JSON object: the number of frames, mean, p50, p95 and max of their times, and frames per second.
  std::string json() const;

 private:
  std::vector<double> frames_ms_;
};

}  // namespace moltact
