#include "engine/device/net/tcp_port.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "engine/device/net/report_stream.h"

namespace moltact {
namespace {

static_assert(kMaxFrameBytes <= TcpConnection::kMaxLastBytes);
using Clock = std::chrono::steady_clock;

class TcpPort final : public PacketPort {
 public:
  TcpPort(std::unique_ptr<TcpConnection> connection, const ReportFraming& framing)
      : connection_(std::move(connection)), framing_(framing), stream_(framing) {}

  int read(std::span<std::uint8_t> report, int wait_ms) override {
    const auto until = Clock::now() + std::chrono::milliseconds(wait_ms);
    for (;;) {
      if (const int size = stream_.next(report)) {
        heard_ = Clock::now();
        return size;
      }
      const auto now = Clock::now();
      const int left_ms = int(std::chrono::ceil<std::chrono::milliseconds>(until - now).count());
      const int size = connection_->read(stream_.room(), std::max(0, left_ms));
      if (size < 0) return -1;
      if (size == 0) return now - heard_ > std::chrono::milliseconds(tcp_port::kSilence_ms) ? -1 : 0;
      stream_.filled(std::size_t(size));
    }
  }

  bool write(std::span<const std::uint8_t> report) override {
    const Message message(framing_, report);
    return connection_->write(message.bytes());
  }

  // The request is the report's id alone. Positions that arrive before the answer are dropped.
  int feature(std::span<std::uint8_t> report) override {
    const std::uint8_t id = report[0];
    if (!write({&id, 1})) return -1;
    const auto until = Clock::now() + std::chrono::milliseconds(tcp_port::kDescription_ms);
    heard_ = Clock::now();
    while (Clock::now() < until) {
      const int size = read(report, 10);
      if (size < 0) return -1;
      if (size > 1 && report[0] == id) return size;
    }
    return -1;
  }

  void lastReport(std::span<const std::uint8_t> report) override {
    const Message message(framing_, report);
    connection_->lastBytes(message.bytes());
  }

 private:
  // One frame in one buffer, so that it is sent as one packet.
  class Message {
   public:
    Message(const ReportFraming& framing, std::span<const std::uint8_t> report)
        : size_(std::min(framing.encode(report.first(std::min(report.size(), kMaxReportBytes)), bytes_),
                         kMaxFrameBytes)) {}
    std::span<const std::uint8_t> bytes() const { return {bytes_.data(), size_}; }

   private:
    std::array<std::uint8_t, kMaxFrameBytes> bytes_{};
    std::size_t size_;
  };

  std::unique_ptr<TcpConnection> connection_;
  const ReportFraming& framing_;
  ReportStream stream_;
  Clock::time_point heard_ = Clock::now();
};

}  // namespace

Expected<std::unique_ptr<PacketPort>> openTcpPort(const TcpAddress& address, const ReportFraming& framing) {
  auto connection = TcpConnection::connect(address, tcp_port::kConnect_ms);
  if (!connection) return connection.problem();
  return std::unique_ptr<PacketPort>(std::make_unique<TcpPort>(std::move(*connection), framing));
}

}  // namespace moltact
