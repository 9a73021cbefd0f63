// Reports in a stream of bytes, as a TCP device sends them: one byte with the report's length, 1 to kMostReportBytes, then
// the report. Holds at most kMaxBuffered bytes and allocates nothing. One thread at a time.
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
  /// Some milliseconds of reports: a reader that is later than this loses nothing, for TCP holds the rest back.
  static constexpr std::size_t kMaxBuffered = 4096;

  /// The memory that the next bytes are to be read into; empty only while a whole report waits.
  std::span<std::uint8_t> room() {
    std::memmove(bytes_.data(), bytes_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    return std::span(bytes_).subspan(end_);
  }
  /// So many bytes were read into room().
  void filled(std::size_t count) { end_ += std::min(count, bytes_.size() - end_); }

  /// Takes the next report. Returns its length; 0: none is complete; -1: the stream is not of this layout, and nothing after
  /// this can be trusted.
  int next(std::span<std::uint8_t> report) {
    if (begin_ == end_) return 0;
    const std::size_t length = bytes_[begin_];
    if (length == 0 || length > kMostReportBytes) return -1;
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
