#include "tests/fuzz/recording_maker.h"

#include <zlib.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace moltact::fuzz {
namespace {

void number(std::string& to, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) to += char(value >> (8 * k) & 0xff);
}

std::uint32_t numberAt(const std::string& bytes, std::size_t place) {
  std::uint32_t out = 0;
  for (int k = 3; k >= 0; --k) out = out << 8 | static_cast<unsigned char>(bytes[place + std::size_t(k)]);
  return out;
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), uInt(bytes.size())));
}

double oddDouble(Choices& choices) {
  constexpr double kOdd[] = {0.0,
                             -1.0,
                             1.0,
                             -0.0,
                             1e-300,
                             1e300,
                             -1e300,
                             1e37,
                             -1e37,
                             1e18,
                             -1e10,
                             1e9,
                             2e9,
                             1e6,
                             9.9e5,
                             1e-5,
                             1e-3,
                             1000.0,
                             -80.0,
                             300.0,
                             0.5,
                             1.7e308,
                             std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()};
  return kOdd[choices.pick(std::size(kOdd))];
}

std::uint32_t oddCount(Choices& choices) {
  constexpr std::uint32_t kOdd[] = {0, 1, 2, 3, 0x7fffffff, 0x80000000, 0xffffffff};
  return kOdd[choices.pick(std::size(kOdd))];
}

Vec3 oddPlace(Vec3 from, Choices& choices) {
  from[int(choices.pick(3))] = oddDouble(choices);
  return from;
}

void changeSettings(ServoSettings& s, Choices& choices) {
  switch (choices.pick(10)) {
    case 0:
      s.workspace.A_per_mm = oddDouble(choices);
      break;
    case 1:
      s.workspace.centre_A = oddPlace(s.workspace.centre_A, choices);
      break;
    case 2:
      s.workspace.rotation[int(choices.pick(3))] = Vec3(0.0);
      break;
    case 3:
      s.stiffness_N_per_mm = oddDouble(choices);
      break;
    case 4:
      s.max_force_N = oddDouble(choices);
      break;
    case 5:
      s.probe_A = oddDouble(choices);
      break;
    case 6:
      s.discontinuities = oddCount(choices);
      break;
    case 7:
      s.clutch.buttons = oddCount(choices);
      break;
    case 8:
      s.panic = !s.panic;
      break;
    default:
      s.force_on = !s.force_on;
      break;
  }
}

void changeFigures(DeviceSpecs& f, Choices& choices) {
  double* const figures[] = {
      &f.max_force_N,         &f.continuous_force_N, &f.max_stiffness_N_per_mm, &f.max_damping_N_s_per_m,
      &f.damping_N_s_per_m,   &f.friction_N,         &f.resolution_mm,          &f.delay_s,
      &f.speed_limit_m_per_s, &f.slew_limit_N_per_s, &f.workspace_mm.x,         &f.workspace_mm.y,
      &f.workspace_mm.z};
  *figures[choices.pick(std::size(figures))] = oddDouble(choices);
  f.gives_force = choices.pick(2);
}

void changeTick(RecordedTick& tick, Choices& choices) {
  switch (choices.pick(9)) {
    case 7:
      tick.at_rest = !tick.at_rest;
      tick.body_pose = PoseA{{oddPlace(tick.pose.position.mm, choices)}, kNoRotation};
      break;
    case 0:
      tick.pose.position.mm = oddPlace(tick.pose.position.mm, choices);
      break;
    case 1:
      tick.time.dt_s = oddDouble(choices);
      break;
    case 2:
      tick.time.delay_s = oddDouble(choices);
      break;
    case 3: {
      constexpr float kOdd[] = {0.0f,
                                0.02f,
                                1.0f,
                                -1.0f,
                                3e38f,
                                std::numeric_limits<float>::infinity(),
                                std::numeric_limits<float>::quiet_NaN()};
      (choices.pick(2) ? tick.pose.age_s : tick.pose.motor_heat) = kOdd[choices.pick(std::size(kOdd))];
      break;
    }
    case 4:
      tick.pose.buttons = oddCount(choices);
      break;
    case 5:
      tick.pose.connected = !tick.pose.connected;
      break;
    case 6:
      (choices.pick(2) ? tick.force.N : tick.torque_N_mm) = oddPlace(tick.force.N, choices);
      break;
    default:
      tick.pose.fresh = !tick.pose.fresh;
      break;
  }
}

}  // namespace

std::string recordingOf(const std::map<std::string, std::string>& labels, const std::vector<RecordedTick>& ticks) {
  const std::string file = fileOf("", "sample.recording");
  auto writer = ServoRecordingWriter::create(file, true);
  mustBe(writer && !writer->begin(labels, ServoStep()), "a recording");
  for (const RecordedTick& tick : ticks) mustBe(!writer->add(tick), "a tick");
  mustBe(!writer->finish(), "an end");
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

RecordingParts partsOf(const std::string& recording) {
  RecordingParts out;
  const std::uint32_t labels = numberAt(recording, 8), build = numberAt(recording, 12), state = numberAt(recording, 16);
  out.labels = recording.substr(20, labels);
  out.build = recording.substr(20 + labels, build);
  out.state = recording.substr(20 + labels + build, state);
  const std::size_t block = 20 + labels + build + state + 4;
  out.count = numberAt(recording, block + 4);
  out.ticks = recording.substr(block + 16);
  return out;
}

std::string RecordingParts::file() const {
  std::string out = "MOLTRAC7";
  number(out, std::uint32_t(labels.size())), number(out, std::uint32_t(build.size())),
      number(out, std::uint32_t(state.size()));
  out += labels + build + state;
  number(out, checksum(out));
  out += "BLK1";
  number(out, count), number(out, std::uint32_t(ticks.size())), number(out, checksum(ticks));
  return out + ticks;
}

void changeState(std::string& state, Choices& choices) {
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
}

std::string madeRecording(Choices& choices, std::size_t count, const Workspace& workspace) {
  std::vector<RecordedTick> ticks(count);
  ServoSettings settings;
  settings.workspace = workspace;
  DeviceSpecs device = shownForceFigures();
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = 6.3 * double(k) / double(count);
    ticks[k].pose.position.mm = {100.0 * std::cos(angle), 20.0 * std::sin(angle), 10.0 * std::sin(2.0 * angle)};
    ticks[k].settings = settings;
    ticks[k].device = device;
  }
  for (std::size_t n = choices.pick(16); n > 0; --n) {
    const std::size_t from = choices.pick(count), how = choices.pick(4);
    if (how <= 1) {
      changeTick(ticks[from], choices);
      continue;
    }
    if (how == 2)
      changeSettings(ticks[from].settings, choices);
    else
      changeFigures(ticks[from].device, choices), ticks[from].other_device = true;
    for (std::size_t k = from + 1; k < count; ++k) {
      ticks[k].settings = ticks[from].settings;
      ticks[k].device = ticks[from].device;
    }
  }
  static const std::string kNames[] = {"1ubq",    "1hel", "", "/dev/null", "../1ubq", std::string(2000, 'x'),
                                       "\x1b[2J", "%n"};
  static const std::string kMethods[] = {"exact", "grid", "penalty", "mesh", "none", ""};
  const bool other = choices.pick(4) == 3;
  const std::string molecule = kNames[other ? choices.pick(std::size(kNames)) : 0],
                    method = kMethods[other ? choices.pick(std::size(kMethods)) : 0];
  RecordingParts parts = partsOf(recordingOf({{"molecule", molecule}, {"method", method}, {"device", "Any"}}, ticks));
  if (choices.pick(4) == 3) changeState(parts.state, choices);
  return parts.file();
}

}  // namespace moltact::fuzz
