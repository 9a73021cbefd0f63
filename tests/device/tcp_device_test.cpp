// A stylus over TCP on the loopback address: found by its address, used, lost and found again. The process that uses it
// may end in any way. The example of docs/device-protocol.md runs unchanged.
#include <doctest/doctest.h>

#include <random>

#include "engine/device/driver.h"
#include "engine/device/net/report_stream.h"
#include "engine/device/net/tcp_port.h"
#include "engine/device/packet/packet_device.h"
#include "tests/device/dying.h"
#include "tests/device/tcp_stylus.h"

using namespace moltact;
using namespace moltact::test;

namespace {

// Waits for another thread, for a minute at most, so that no result depends on the speed of the machine.
template <class Done>
bool comes(Done done) {
  for (int k = 0; k < 60'000 && !done(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return done();
}

std::unique_ptr<Device> openedStylus(const TcpStylus& stylus) {
  auto device = openDevice(stylus.device());
  REQUIRE(device);
  return std::move(*device);
}

}  // namespace

TEST_CASE(
    "an address is a port, a numeric host and a port, or an IPv6 address in brackets; 11 other texts are refused") {
  CHECK(parseTcpAddress("7010")->text() == "127.0.0.1:7010");
  CHECK(parseTcpAddress("localhost:7010")->text() == "127.0.0.1:7010");
  CHECK(parseTcpAddress("192.168.1.20:65535")->text() == "192.168.1.20:65535");
  CHECK(parseTcpAddress("[::1]:7010")->text() == "[::1]:7010");
  for (const char* wrong :
       {"", ":", "0", "65536", "-1", "70 10", "host:7010", "1.2.3.4:", ":7010", "[::1]", "[1]:7010"}) {
    CAPTURE(std::string(wrong));
    const auto address = parseTcpAddress(wrong);
    REQUIRE_FALSE(address);
    CHECK(address.problem().remedy.find("HOST:PORT") != std::string::npos);
  }
}

TEST_CASE(
    "reports that arrive in pieces of any size come out whole and in order; a length of 0 or of over 64 ends the "
    "stream") {
  std::mt19937 random(7);
  MESSAGE("seed 7");
  for (int round = 0; round < 200; ++round) {
    std::vector<std::vector<std::uint8_t>> sent(1 + random() % 200);
    std::vector<std::uint8_t> bytes;
    for (auto& report : sent) {
      report.resize(1 + random() % kMaxReportBytes);
      for (auto& b : report) b = static_cast<std::uint8_t>(random());
      bytes.push_back(static_cast<std::uint8_t>(report.size()));
      bytes.insert(bytes.end(), report.begin(), report.end());
    }
    ReportStream stream(lengthFraming());
    std::size_t at = 0, next = 0;
    while (at < bytes.size() || next < sent.size()) {
      const auto room = stream.room();
      const std::size_t some = std::min({room.size(), bytes.size() - at, std::size_t(1 + random() % 300)});
      std::copy_n(bytes.begin() + std::ptrdiff_t(at), some, room.begin());
      stream.filled(some);
      at += some;
      std::array<std::uint8_t, kMaxReportBytes> report{};
      for (int size; (size = stream.next(report)) > 0; ++next) {
        REQUIRE(next < sent.size());
        REQUIRE(std::vector(report.begin(), report.begin() + size) == sent[next]);
      }
    }
    CHECK(next == sent.size());
  }
  for (const std::uint8_t length : {std::uint8_t(0), std::uint8_t(65), std::uint8_t(255)}) {
    ReportStream stream(lengthFraming());
    stream.room()[0] = length;
    stream.filled(1);
    std::array<std::uint8_t, kMaxReportBytes> report{};
    CHECK(stream.next(report) == -1);
  }
}

// SLIP (RFC 1055): a frame ends with END; END and ESC within it are escaped.
class SlipFraming final : public ReportFraming {
 public:
  static constexpr std::uint8_t kEnd = 0xC0, kEsc = 0xDB, kEscEnd = 0xDC, kEscEsc = 0xDD;

  Decoded decode(std::span<const std::uint8_t> stream, std::span<std::uint8_t> report) const noexcept override {
    Decoded out;
    for (std::size_t k = 0; k < std::min(stream.size(), kMaxFrameBytes); ++k) {
      std::uint8_t byte = stream[k];
      if (byte == kEnd) {
        out.is = Decoded::Is::Report;
        out.frame_bytes = k + 1;
        return out;
      }
      if (byte == kEsc) {
        if (++k == stream.size()) break;
        if (stream[k] != kEscEnd && stream[k] != kEscEsc) return {Decoded::Is::Invalid};
        byte = stream[k] == kEscEnd ? kEnd : kEsc;
      }
      if (out.report_bytes < report.size()) report[out.report_bytes++] = byte;
    }
    return {};
  }

  std::size_t encode(std::span<const std::uint8_t> report, FrameBuffer out) const noexcept override {
    std::size_t size = 0;
    for (const std::uint8_t byte : report) {
      const bool escaped = byte == kEnd || byte == kEsc;
      if (size + 3 > out.size()) break;
      if (escaped) out[size++] = kEsc;
      out[size++] = !escaped ? byte : byte == kEnd ? kEscEnd : kEscEsc;
    }
    out[size++] = kEnd;
    return size;
  }
};

TEST_CASE(
    "another framing needs a decoder and an encoder alone: 200 streams in SLIP frames, with empty frames between, come "
    "out whole; 128 bytes without an end, and a wrong escape, end the stream") {
  const SlipFraming slip;
  std::mt19937 random(11);
  MESSAGE("seed 11");
  for (int round = 0; round < 200; ++round) {
    std::vector<std::vector<std::uint8_t>> sent(1 + random() % 100);
    std::vector<std::uint8_t> bytes;
    for (auto& report : sent) {
      report.resize(1 + random() % 60);
      for (auto& b : report) b = random() % 4 ? static_cast<std::uint8_t>(random()) : SlipFraming::kEnd;
      std::array<std::uint8_t, kMaxFrameBytes> frame{};
      const std::size_t size = slip.encode(report, frame);
      bytes.insert(bytes.end(), frame.begin(), frame.begin() + std::ptrdiff_t(size));
      if (random() % 3 == 0) bytes.push_back(SlipFraming::kEnd);
    }
    ReportStream stream(slip);
    std::size_t next = 0;
    for (std::size_t at = 0; at < bytes.size();) {
      const auto room = stream.room();
      REQUIRE_FALSE(room.empty());
      const std::size_t some = std::min({room.size(), bytes.size() - at, std::size_t(1 + random() % 300)});
      std::copy_n(bytes.begin() + std::ptrdiff_t(at), some, room.begin());
      stream.filled(some);
      at += some;
      std::array<std::uint8_t, kMaxReportBytes> report{};
      for (int size; (size = stream.next(report)) != 0; ++next) {
        REQUIRE(size > 0);
        REQUIRE(next < sent.size());
        REQUIRE(std::vector(report.begin(), report.begin() + size) == sent[next]);
      }
    }
    CHECK(next == sent.size());
  }
  std::array<std::uint8_t, kMaxReportBytes> report{};
  for (const std::vector<std::uint8_t>& wrong :
       {std::vector<std::uint8_t>(128, 1), std::vector<std::uint8_t>{1, SlipFraming::kEsc, 7}}) {
    ReportStream stream(slip);
    std::copy(wrong.begin(), wrong.end(), stream.room().begin());
    stream.filled(wrong.size());
    CHECK(stream.next(report) == -1);
  }
}

TEST_CASE(
    "a stylus over TCP is found by its address, describes itself, reports a place of 12 mm and is given a force of 1 "
    "N") {
  TcpStylus stylus;
  const auto found = findDevice(stylus.device());
  REQUIRE(found);
  CHECK(found->usable);
  CHECK(found->gives_force);
  CHECK_FALSE(found->auto_selectable);
  CHECK(found->name == stylus.device());
  CHECK(found->place == "127.0.0.1:" + std::to_string(stylus.port()));

  const auto device = openedStylus(stylus);
  CHECK(device->info().gives_force);
  CHECK(device->status().connected);
  stylus.x_mm = 12.0;
  CHECK(comes([&] { return device->read(0.001).position.mm.x == doctest::Approx(12.0).epsilon(0.01); }));
  CHECK(comes([&] {
    device->write({{0.6, 0.8, 0.0}});
    return stylus.last_mN == 1400;
  }));
  device->stop();
  CHECK(comes([&] { return stylus.last_mN == 0; }));
}

TEST_CASE(
    "the driver's name alone shows how to give an address; where nothing listens the reason contains the address, and "
    "no device is made") {
  const auto unnamed = findDevice("open-tcp");
  REQUIRE(unnamed);
  CHECK_FALSE(unnamed->usable);
  CHECK(unnamed->why.find("open-tcp:PORT") != std::string::npos);
  std::string gone;
  { gone = TcpStylus().device(); }
  const auto none = openDevice(gone);
  REQUIRE_FALSE(none);
  CHECK(none.problem().message.find("127.0.0.1") != std::string::npos);
  CHECK_FALSE(openDevice("open-tcp:here"));
}

TEST_CASE(
    "an address on this computer has no note; one of another computer has a note that the reports cross the network "
    "unencrypted") {
  for (const char* own : {"open-tcp:7010", "open-tcp:127.0.0.2:7010", "open-tcp:[::1]:7010"}) {
    CAPTURE(std::string(own));
    CHECK(findDevice(own)->note.empty());
  }
  for (const char* other : {"open-tcp:192.168.1.20:7010", "open-tcp:[fe80::1]:7010", "open-tcp:0.0.0.0:7010"}) {
    CAPTURE(std::string(other));
    CHECK(findDevice(other)->usable);
    CHECK(findDevice(other)->note.find("unencrypted") != std::string::npos);
  }
}

TEST_CASE(
    "a connection to a port where nothing listens is refused 200 times, also where the system would connect it to "
    "itself") {
  TcpAddress address;
  { address.port = TcpStylus().port(); }
  for (int k = 0; k < 200; ++k) CHECK_FALSE(TcpConnection::connect(address, 1000));
}

TEST_CASE("a listener that never describes itself is refused after half a second") {
  TcpStylus stylus;
  stylus.describes = false;
  const auto device = openDevice(stylus.device());
  REQUIRE_FALSE(device);
  CHECK(device.problem().message.find("open layout") != std::string::npos);
}

TEST_CASE(
    "a stylus that hangs up, or sends a report of no length, of 200 bytes, half of one, or nothing for 2 s: it is "
    "given no "
    "force, is lost, and is found again") {
  using Sends = TcpStylus::Sends;
  for (const Sends fault : {Sends::Places, Sends::EmptyReport, Sends::LongReport, Sends::HalfReport, Sends::Nothing}) {
    CAPTURE(int(fault));
    TcpStylus stylus;
    const auto device = openedStylus(stylus);
    CHECK(comes([&] {
      device->write({{0.5, 0, 0}});
      return device->read(0.001).connected && stylus.last_mN > 0;
    }));
    const int hosts = stylus.hosts;
    stylus.describes = false;  // it cannot be found again before the test has seen that it was lost
    stylus.sends = fault;
    if (fault == Sends::Places) stylus.hangs_up = true;
    CHECK(comes([&] {
      device->write({{0.5, 0, 0}});
      return !device->read(0.001).connected;
    }));
    CHECK_FALSE(device->status().connected);
    if (fault != Sends::Places) CHECK(comes([&] { return stylus.last_mN == 0; }));
    stylus.sends = Sends::Places;
    stylus.describes = true;
    CHECK(comes([&] { return device->read(0.001).connected; }));
    CHECK(stylus.hosts > hosts);
    CHECK(device->read(0.001).discontinuities > 0);
  }
}

TEST_CASE(
    "TCP: a process that gives force ends in 30 ways, by signals, crashes, exits and exceptions: the connection ends, "
    "and the last report has no force") {
  double worst_ms = 0;
  for (const WayToDie& one : kWaysToDie) {
    CAPTURE(std::string(one.way));
    CAPTURE(one.signal);
    TcpStylus stylus;
    Dying child(stylus.device(), one.way);
    REQUIRE(child.line(20'000) == "pressing");
    REQUIRE(comes([&] { return stylus.last_mN > 0; }));
    if (std::string(one.way) == "wait")
      child.send(one.signal);
    else
      child.go();
    CHECK(comes([&] { return child.over(); }));
    CHECK((one.signal ? child.killedBy(one.signal) : child.exitedWith(7)));
    CHECK(comes([&] { return !stylus.connected; }));
    CHECK(stylus.last_mN == 0);
    CHECK(stylus.greatest_mN > 0);
    const double forced_ms = 1e-6 * double(stylus.forced_ns - child.at_ns());
    if (std::string(one.way) != "stack") worst_ms = std::max(worst_ms, forced_ms);  // filling it takes time
  }
  MESSAGE(std::size(kWaysToDie) << " ways, at most " << worst_ms << " ms until the last report with force came");
}

#ifdef MOLTACT_PYTHON
TEST_CASE(
    "the example docs/tcp_stylus.py presses 10 mm and more into a wall of 20 N/m that the host renders, and prints the "
    "force that it was given") {
  Child example({MOLTACT_PYTHON, MOLTACT_SOURCE_DIR "/docs/tcp_stylus.py", "0"});
  const std::string listening = example.line(60'000);
  const std::size_t colon = listening.rfind(':');
  REQUIRE(colon != std::string::npos);
  auto device = openDevice("open-tcp:" + listening.substr(colon + 1));
  REQUIRE(device);
  CHECK((*device)->info().max_force_N == 3.0);
  CHECK((*device)->info().workspace_mm == Vec3(160, 120, 120));
  double highest_mm = -100.0, lowest_mm = 100.0, given_N = 0.0, printed_N = 0.0;
  CHECK(comes([&] {
    const double z_mm = (*device)->read(0.001).position.mm.z;
    highest_mm = std::max(highest_mm, z_mm);
    lowest_mm = std::min(lowest_mm, z_mm);
    const double force_N = z_mm < 0.0 ? -0.02 * z_mm : 0.0;
    given_N = std::max(given_N, force_N);
    (*device)->write({{0.0, 0.0, force_N}});
    double x = 0, y = 0, z = 0, force_x = 0, force_y = 0, force_z = 0;
    if (std::sscanf(example.line(0).c_str(), "place %lf %lf %lf mm, force %lf %lf %lf N", &x, &y, &z, &force_x,
                    &force_y, &force_z) == 6)
      printed_N = std::max(printed_N, force_z);
    return printed_N >= 0.2 && lowest_mm < -10.0 && highest_mm > 10.0;
  }));
  CHECK(printed_N <= given_N + 0.002);  // in whole millinewtons
}
#endif
