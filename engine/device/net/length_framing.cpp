#include <algorithm>

#include "engine/device/net/report_framing.h"
#include "engine/device/packet/packet_port.h"

namespace moltact {
namespace {

class LengthFraming final : public ReportFraming {
 public:
  Decoded decode(std::span<const std::uint8_t> stream, std::span<std::uint8_t> report) const noexcept override {
    if (stream.empty()) return {};
    const std::size_t length = stream[0];
    if (length == 0 || length > kMaxReportBytes) return {Decoded::Is::Invalid};
    if (stream.size() < 1 + length) return {};
    const std::size_t taken = std::min(length, report.size());
    std::copy_n(stream.begin() + 1, taken, report.begin());
    return {Decoded::Is::Report, 1 + length, taken};
  }

  std::size_t encode(std::span<const std::uint8_t> report, FrameBuffer out) const noexcept override {
    const std::size_t size = std::min(report.size(), kMaxReportBytes);
    out[0] = static_cast<std::uint8_t>(size);
    std::copy_n(report.begin(), size, out.begin() + 1);
    return 1 + size;
  }
};

}  // namespace

const ReportFraming& lengthFraming() {
  static const LengthFraming framing;
  return framing;
}

}  // namespace moltact
