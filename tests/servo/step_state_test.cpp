// The initial state of a recording: it is restored to the last bit, and no text gives a state that the loop cannot
// have.
#include "engine/servo/step_state.h"

#include <doctest/doctest.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>

#include "engine/bench/scenes.h"
#include "engine/haptics/methods.h"
#include "engine/servo/servo_recording.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

std::unique_ptr<Tracker> newTracker() {
  return methods().front().make(test::makeScene(scenes::cluster(20, 3).spheres), kWaterProbe_A);
}

// A hand that shakes in and out of the cluster, with faults of the device and of the clock in between.
class StepStateHand {
 public:
  explicit StepStateHand(unsigned seed) : random_(seed) {}
  ServoSample tick(ServoStep& step, Tracker* tracker) {
    const auto chance = [&](double p) { return std::uniform_real_distribution(0.0, 1.0)(random_) < p; };
    for (int k = 1; k < 3; ++k)
      place_.mm[k] += std::uniform_real_distribution(-0.2, 0.2)(random_) - 0.002 * place_.mm[k];
    place_.mm.x = 40.0 * std::cos(0.002 * ++ticks_);
    DevicePose pose{.position = place_, .fresh = !chance(0.1), .fault = chance(0.0005)};
    if (chance(0.0002)) ++discontinuities_;
    pose.discontinuities = discontinuities_;
    settings_.panic = chance(0.0005);
    settings_.clutch = {.buttons = 1, .at_edge = true};
    pose.buttons = chance(0.01);
    if (chance(0.0005)) {
      DeviceSpecs stronger = phantomOmniFigures();
      stronger.max_force_N = 5.0, stronger.continuous_force_N = 1.0, stronger.gives_force = true;
      step.setDevice(stronger);
    }
    return step.tick(settings_, tracker, pose, {.dt_s = chance(0.0005) ? 0.03 : 0.001, .delay_s = 1e-5});
  }

 private:
  std::mt19937 random_;
  ServoSettings settings_;
  PointMm place_;
  int ticks_ = 0;
  std::uint32_t discontinuities_ = 0;
};

std::string changed(std::string text, std::mt19937& random) {
  const auto any = [&](std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random); };
  constexpr const char* kValues[] = {
      "9", "-1", "18446744073709551615", "nan", "inf", "-inf", "1p+1023", "1p+2000", "", "2", "0x1", "1 "};
  const std::size_t line = text.find('=', any(text.size() - 20)),
                    at = line == std::string::npos ? text.find('=') : line;
  switch (any(4)) {
    case 0:
      text.replace(at + 1, text.find('\n', at) - at - 1, kValues[any(std::size(kValues))]);
      break;
    case 1:
      text[any(text.size())] ^= char(1 << any(7));
      break;
    case 2:
      text.erase(any(text.size()), 1 + any(40));
      break;
    default:
      text.insert(text.find('\n', at) + 1, text.substr(0, 1 + any(80)));
      break;
  }
  return text;
}

// A recording as a program of ours writes it, with another state put into it and the checksum made right.
std::string forged(const std::string& file, const std::string& state) {
  const auto length = [&](std::size_t at) {
    return std::size_t(std::uint8_t(file[at])) | std::size_t(std::uint8_t(file[at + 1])) << 8;
  };
  const std::size_t before = 20 + length(8) + length(12), after = before + length(16) + 4;
  std::string out = file.substr(0, before) + state;
  for (int k = 0; k < 4; ++k) out[16 + std::size_t(k)] = char(state.size() >> (8 * k) & 0xff);
  const auto crc = static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(out.data()), uInt(out.size())));
  for (int k = 0; k < 4; ++k) out += char(crc >> (8 * k) & 0xff);
  return out + file.substr(after);
}

}  // namespace

TEST_CASE(
    "a step that is written as text and read again continues with the same forces to the last bit, at any of 40 ticks "
    "of "
    "a rough hand") {
  const auto tracker = newTracker();
  ServoStep step;
  StepStateHand hand(7);
  double peak_N = 0;
  for (int k = 0; k < 40; ++k) {
    CAPTURE(k);
    for (int i = 0; i < 231; ++i) hand.tick(step, tracker.get());
    step.forgetInteraction();
    const std::string text = stateText(step);
    Expected<ServoStep> read = stepFromText(text);
    REQUIRE(read);
    CHECK(stateText(*read) == text);
    ServoStep one = step, other = *read;
    const auto for_one = newTracker(), for_other = newTracker();
    StepStateHand hand_one = hand, hand_other = hand;
    for (int i = 0; i < 100; ++i) {
      const ForceN a = hand_one.tick(one, for_one.get()).force, b = hand_other.tick(other, for_other.get()).force;
      REQUIRE(a.N == b.N);
      peak_N = std::max(peak_N, glm::length(a.N));
    }
  }
  CHECK(peak_N > 0.1);
}

TEST_CASE(
    "a state with an index out of its ring, a bool of 2, a NaN, a value twice, missing or unknown is "
    "reported by its name") {
  const std::string whole = stateText(ServoStep());
  REQUIRE(stepFromText(whole));
  const auto with = [&](const std::string& name, const std::string& value) {
    std::string text = '\n' + whole;
    const std::size_t at = text.find('\n' + name + '=');
    REQUIRE(at != std::string::npos);
    text.replace(at + 1, text.find('\n', at + 1) - at - 1, name + '=' + value);
    return stepFromText(text.substr(1));
  };
  const auto said = [](const Expected<ServoStep>& read) {
    return read ? std::string("nothing") : read.problem().message;
  };
  for (const char* name : {"safety.speed.next", "safety.speed.count"})
    CHECK(said(with(name, "10")) ==
          "the state that the recording begins from has a " + std::string(name) + " that cannot be");
  for (const char* value : {"2", "-1", "", "true"}) CHECK_FALSE(with("safety.placed", value));
  for (const char* value : {"nan", "inf", "1p+2000", "-1p-3"}) CHECK_FALSE(with("safety.gain", value));
  CHECK(said(stepFromText(whole + "push.x=0p+0\n")) == "the state that the recording begins from says a value twice");
  CHECK(said(stepFromText(whole + "pull.x=0p+0\n")) ==
        "the state that the recording begins from holds a value that is not known");
  CHECK(said(stepFromText(whole.substr(whole.find('\n') + 1))) ==
        "the state that the recording begins from does not say tick");
  CHECK(said(stepFromText("tick")) == "the state that the recording begins from holds a line without a value");
}

TEST_CASE(
    "a state of an older recording, whose forces of the last 8 ticks are a ring, is read in the order in which they "
    "were given; a place beyond the ring is refused") {
  const std::string whole = stateText(ServoStep());
  const auto older = [&](int next) {
    std::string text = whole + "safety.passivity.next=" + std::to_string(next) + '\n';
    for (int k = 0; k < 8; ++k)
      for (const char* axis : {"x", "y", "z"}) {
        const std::string at = std::to_string(k) + '.' + axis + '=';
        text += "safety.passivity.given_N." + at + (*axis == 'x' ? std::to_string(k + 1) : "0") + "p+0\n";
        text += "safety.passivity.given_N_mm." + at + (*axis == 'y' ? std::to_string(k + 1) : "0") + "p+0\n";
      }
    return stepFromText(text);
  };
  for (int next = 0; next < 8; ++next) {
    CAPTURE(next);
    const auto step = older(next);
    REQUIRE(step);
    const std::string text = stateText(*step);
    for (int ago = 0; ago < 8; ++ago) {
      // Sample k was written at place k: the newest lies just before the next place.
      const double value = (next - 1 - ago + 16) % 8 + 1;
      const std::string names[] = {"safety.passivity.given_ago_N." + std::to_string(ago) + ".x=",
                                   "safety.passivity.given_ago_N_mm." + std::to_string(ago) + ".y="};
      for (const std::string& name : names) {
        const std::size_t at = text.find(name);
        REQUIRE(at != std::string::npos);
        CHECK(std::strtod(("0x" + text.substr(at + name.size(), text.find('\n', at) - at - name.size())).c_str(),
                          nullptr) == value);
      }
    }
    CHECK(text.find("given_ago_N.8.") == std::string::npos);
    CHECK(stateText(*stepFromText(text)) == text);
  }
  CHECK_FALSE(older(8));
}

TEST_CASE("3000 recordings with a forged state and a right checksum are refused or replayed with finite forces") {
  const auto file = std::filesystem::temp_directory_path() / ("moltact_state_" + std::to_string(getpid()));
  const auto tracker = newTracker();
  {
    auto writer = ServoRecordingWriter::create(file, true);
    REQUIRE(writer);
    ServoStep step;
    REQUIRE_FALSE(writer->begin({{"molecule", "cluster 20"}}, step));
    for (int k = 0; k < 100; ++k) REQUIRE_FALSE(writer->add({}));
    REQUIRE_FALSE(writer->finish());
  }
  std::ifstream in(file, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}}, state = stateText(ServoStep());
  std::mt19937 random(20);
  int refused = 0, replayed = 0;
  for (int k = 0; k < 3000; ++k) {
    CAPTURE(k);
    std::ofstream(file, std::ios::binary) << forged(whole, changed(state, random));
    const auto recording = readServoRecording(file);
    if (!recording) {
      CHECK_FALSE(recording.problem().remedy.empty());
      ++refused;
      continue;
    }
    REQUIRE(recording->ticks.size() == 100);
    CHECK(std::isfinite(replay(*recording, tracker.get()).max_difference_N));
    ++replayed;
  }
  CHECK(refused > 1000);
  CHECK(replayed > 100);
  std::filesystem::remove(file);
}
