// Recordings of a hand: as bytes; as blocks of ticks with any numbers and a right checksum; and with the state that the
// first tick begins from. What can be read is replayed: every force is finite and no greater than the device gives.
#include <zlib.h>

#include <cmath>
#include <fstream>

#include "engine/bench/scenes.h"
#include "engine/haptics/methods.h"
#include "engine/servo/playback_device.h"
#include "engine/servo/servo_recording.h"
#include "engine/servo/step_state.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

void replayed(const std::string& file) {
  static const auto scene = std::make_shared<const BallScene>(scenes::cluster(20, 3).balls);
  auto trace = readServoRecording(file);
  if (!trace) return mustBe(!trace.problem().message.empty(), "a message");
  if (trace->ticks.size() > 300) trace->ticks.resize(300);
  const auto tracker = methods().front().make(scene, kWaterProbe_A);
  ServoStep step = trace->start.value_or(ServoStep());
  for (const RecordedTick& tick : trace->ticks) {
    if (tick.other_device) step.setDevice(tick.device);
    mustBe(finite(step.tick(tick.settings, tracker.get(), tick.pose, tick.time).force.N), "a force that is a number");
  }
  replay(*trace, tracker.get());
  PlaybackDevice device(*std::move(trace));
  for (int k = 0; k < 10; ++k) device.read(0.001);
}

void number(std::string& to, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) to += char(value >> (8 * k) & 0xff);
}
std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), uInt(bytes.size())));
}

// What a program of ours writes of a few ticks; its state's text apart.
struct Sample {
  std::string labels = "molecule=1ubq\nmethod=exact\n", build, state, ticks;
  std::uint32_t count = 8;
  Sample() {
    const std::string file = fileOf("", "sample.recording");
    auto writer = ServoRecordingWriter::create(file, true);
    ServoStep step;
    mustBe(writer && !writer->begin({{"molecule", "1ubq"}, {"method", "exact"}}, step), "a recording");
    for (std::uint32_t k = 0; k < count; ++k) {
      RecordedTick tick;
      tick.pose.position.mm.x = 30.0 - 4.0 * k;
      if (k == 1) tick.other_device = true, tick.device.gives_force = true;
      if (k == 4) tick.settings.stiffness_N_per_mm = 0.3;
      mustBe(!writer->add(tick), "a tick");
    }
    mustBe(!writer->finish(), "an end");
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const auto at = [&](std::size_t place) {
      std::uint32_t out = 0;
      for (int k = 3; k >= 0; --k) out = out << 8 | static_cast<unsigned char>(bytes[place + std::size_t(k)]);
      return out;
    };
    build = bytes.substr(20 + at(8), at(12));
    state = bytes.substr(20 + at(8) + at(12), at(16));
    ticks = bytes.substr(20 + at(8) + at(12) + at(16) + 4 + 16);
  }
  std::string file(const std::string& with_state, const std::string& with_ticks, std::uint32_t with_count) const {
    std::string out = "MOLTRAC3";
    number(out, std::uint32_t(labels.size())), number(out, std::uint32_t(build.size())),
        number(out, std::uint32_t(with_state.size()));
    out += labels + build + with_state;
    number(out, checksum(out));
    out += "BLK1";
    number(out, with_count), number(out, std::uint32_t(with_ticks.size())), number(out, checksum(with_ticks));
    return out + with_ticks;
  }
};

const Sample& sample() {
  static const Sample out;
  return out;
}

}  // namespace

void recording(std::string_view bytes) {
  replayed(fileOf(bytes, "a.recording"));
  // The same changes to the ticks, under a checksum that is right.
  Choices choices(bytes);
  std::string ticks = sample().ticks;
  for (std::size_t n = choices.pick(12); n > 0; --n) {
    const std::size_t at = choices.pick(ticks.size()), how = choices.pick(4);
    constexpr double kOdd[] = {0.0,
                               -1.0,
                               1e-300,
                               1e300,
                               -1e18,
                               std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN(),
                               7.5};
    if (how == 0)
      ticks[at] = char(choices.pick(256));
    else if (at + 8 <= ticks.size())
      ticks.replace(at, 8, reinterpret_cast<const char*>(&kOdd[choices.pick(std::size(kOdd))]), 8);
  }
  replayed(fileOf(sample().file(sample().state, ticks, sample().count), "a.recording"));
}

void recordingState(std::string_view bytes) {
  Choices choices(bytes);
  std::string state = sample().state;
  for (std::size_t n = choices.pick(8); n > 0; --n) {
    const std::size_t from = choices.pick(state.size()), at = state.find('=', from), how = choices.pick(8);
    if (at == std::string::npos) continue;
    const std::size_t end = state.find('\n', at);
    constexpr const char* kOdd[] = {
        "0",       "1",       "8",   "9",   "7", "-1", "18446744073709551615", "4294967295", "1p+0", "1p+39", "-1p+39",
        "1p+1000", "1p-1000", "nan", "inf", "",  "x"};
    if (how == 0)
      state.erase(at, choices.pick(30));
    else if (how == 1)
      state.insert(end, state.substr(choices.pick(state.size()), choices.pick(60)));
    else
      state.replace(at + 1, end - at - 1, kOdd[choices.pick(std::size(kOdd))]);
  }
  replayed(fileOf(sample().file(state, sample().ticks, sample().count), "a.recording"));
}

}  // namespace moltact::fuzz
