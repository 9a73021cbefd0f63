// Splits a byte stream into reports by a framing. Buffers at most kMaxBuffered bytes and allocates nothing. One thread
// at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "engine/device/net/report_framing.h"

namespace moltact {

class ReportStream {
 public:
  /// About 160 position reports. TCP flow control holds back the rest.
  static constexpr std::size_t kMaxBuffered = 4096;

  /// The framing must outlive the stream.
  explicit ReportStream(const ReportFraming& framing) : framing_(framing) {}

  /// The free part of the buffer; never empty after next() returned 0.
  std::span<std::uint8_t> room() {
    std::memmove(bytes_.data(), bytes_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    return std::span(bytes_).subspan(end_);
  }
  /// Call after reading `count` bytes into room().
  void filled(std::size_t count) { end_ += std::min(count, bytes_.size() - end_); }

  /// Copies the next report and returns its length; 0: none is complete. -1: invalid framing; the connection must be
  /// closed. A report longer than `report` is cut.
  int next(std::span<std::uint8_t> report) {
    using Is = ReportFraming::Decoded::Is;
    for (;;) {
      const ReportFraming::Decoded found = framing_.decode(std::span(bytes_).subspan(begin_, end_ - begin_), report);
      if (found.is == Is::Incomplete) return end_ - begin_ < kMaxFrameBytes ? 0 : -1;
      if (found.is == Is::Invalid || found.frame_bytes == 0 || found.frame_bytes > end_ - begin_) return -1;
      begin_ += found.frame_bytes;
      if (found.report_bytes > 0) return int(std::min(found.report_bytes, report.size()));
    }
  }

 private:
  const ReportFraming& framing_;
  std::array<std::uint8_t, kMaxBuffered> bytes_{};
  std::size_t begin_ = 0, end_ = 0;
};

}  // namespace moltact
