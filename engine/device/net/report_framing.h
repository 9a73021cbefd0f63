// How a device's byte stream is divided into reports. Implementations have no state; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace moltact {

/// The longest frame: a report of kMaxReportBytes (packet_port.h) with whatever its framing adds (unit: byte).
inline constexpr std::size_t kMaxFrameBytes = 128;
/// Memory for one frame.
using FrameBuffer = std::span<std::uint8_t, kMaxFrameBytes>;

class ReportFraming {
 public:
  virtual ~ReportFraming() = default;

  struct Decoded {
    enum class Is : std::uint8_t { Incomplete, Report, Invalid };
    Is is = Is::Incomplete;
    std::size_t frame_bytes = 0;   ///< of the stream that the frame occupies
    std::size_t report_bytes = 0;  ///< 0: a frame without a report, such as an empty one between two delimiters
  };
  /// Decodes the first frame of the received bytes into `report`, cut to its size. A stream without a complete frame in
  /// its first kMaxFrameBytes bytes is invalid.
  virtual Decoded decode(std::span<const std::uint8_t> stream, std::span<std::uint8_t> report) const noexcept = 0;
  /// Encodes a report of at most kMaxReportBytes. Returns the length of the frame.
  virtual std::size_t encode(std::span<const std::uint8_t> report, FrameBuffer out) const noexcept = 0;
};

/// One byte with the length of the report, 1 to kMaxReportBytes, then the report: docs/device-protocol.md, "Over a
/// network".
const ReportFraming& lengthFraming();

}  // namespace moltact
