// The byte stream of a device over TCP. For any bytes in pieces of any size, the reports equal those of a plain parse
// of the whole. The open layout turns them into finite positions.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/device/hid/open_layout.h"
#include "engine/device/net/report_stream.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

using Report = std::vector<std::uint8_t>;

// Answers the request of a description with the first report.
class Describes final : public PacketPort {
 public:
  explicit Describes(const Report& first) : first_(first) {}
  int read(std::span<std::uint8_t>, int) override { return -1; }
  bool write(std::span<const std::uint8_t>) override { return false; }
  int feature(std::span<std::uint8_t> report) override {
    std::copy(first_.begin(), first_.end(), report.begin());
    return int(first_.size());
  }

 private:
  const Report& first_;
};

// The reports in the bytes, and whether bytes follow that are not a report.
std::pair<std::vector<Report>, bool> parsed(std::string_view bytes) {
  std::vector<Report> out;
  while (!bytes.empty()) {
    const auto length = static_cast<unsigned char>(bytes.front());
    if (length < 1 || length > 64) return {out, true};
    if (bytes.size() <= length) break;
    out.emplace_back(bytes.begin() + 1, bytes.begin() + 1 + length);
    bytes.remove_prefix(1u + length);
  }
  return {out, false};
}

}  // namespace

void reportStream(std::string_view bytes) {
  const std::size_t piece = bytes.empty() ? 1 : 1u + static_cast<unsigned char>(bytes.front());
  if (!bytes.empty()) bytes.remove_prefix(1);
  const auto [wanted, wanted_broken] = parsed(bytes);
  ReportStream stream(lengthFraming());
  std::vector<Report> got;
  bool broken = false;
  for (std::string_view rest = bytes; !rest.empty() && !broken;) {
    const auto room = stream.room();
    mustBe(!room.empty(), "room for more bytes");
    const std::size_t count = std::min({piece, rest.size(), room.size()});
    std::copy_n(rest.begin(), count, room.begin());
    stream.filled(count);
    rest.remove_prefix(count);
    std::array<std::uint8_t, kMaxReportBytes> report{};
    int size = 0;
    while ((size = stream.next(report)) > 0) got.emplace_back(report.begin(), report.begin() + size);
    broken = size < 0;
  }
  mustBe(got == wanted && broken == wanted_broken, "the same reports in pieces");
  OpenLayoutProtocol protocol;
  DeviceInfo info;
  if (!got.empty()) {
    Describes port(got.front());
    if (!protocol.begin(port, info))
      mustBe(finite(info.workspace_mm) && info.resolution_mm > 0.0, "a workspace and a step");
  }
  DevicePose pose;
  for (const Report& report : got) {
    protocol.parseReport(report, pose);
    protocol.advance(0.001, pose);
    mustBe(finite(pose.position.mm), "a position that is a number");
  }
}

}  // namespace moltact::fuzz
