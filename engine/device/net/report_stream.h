// Splits a byte stream into reports, as a TCP device sends them: one byte with the length of the report, 1 to
// kMaxReportBytes, then the report. Buffers at most kMaxBuffered bytes and allocates nothing. One thread at a time.
// Layout: docs/device-protocol.md, "Over a network".
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "engine/device/packet/packet_port.h"

namespace moltact {

class ReportStream {
 public:
  /// About 160 position reports. TCP flow control holds back the rest.
  static constexpr std::size_t kMaxBuffered = 4096;

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
    if (begin_ == end_) return 0;
    const std::size_t length = bytes_[begin_];
    if (length == 0 || length > kMaxReportBytes) return -1;
    if (end_ - begin_ < 1 + length) return 0;
    std::copy_n(bytes_.begin() + std::ptrdiff_t(begin_ + 1), std::min(length, report.size()), report.begin());
    begin_ += 1 + length;
    return int(std::min(length, report.size()));
  }

 private:
  std::array<std::uint8_t, kMaxBuffered> bytes_{};
  std::size_t begin_ = 0, end_ = 0;
};

}  // namespace moltact
