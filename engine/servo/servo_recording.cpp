#include "engine/servo/servo_recording.h"

#include <zlib.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <type_traits>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/platform/read_file.h"
#include "engine/servo/recording_bytes.h"
#include "engine/servo/step_state.h"

namespace moltact {
namespace {

static_assert(sizeof(ServoSettings) == 168 && sizeof(DevicePose) == 80 && sizeof(DeviceSpecs) == 136 &&
                  sizeof(TickTime) == 16,
              "a field more is to be recorded below, or a replay is not the same");

// Version 6 has no motion of spheres. Version 5 has also no poses of bodies. Version 4 has also no torque per tick.
// Version 3 has also no orientation, and no torque of devices. Version 2 has also no initial state.
constexpr std::string_view kMagic = "MOLTRAC7", kBodyPosesMagic = "MOLTRAC6", kTorquesMagic = "MOLTRAC5",
                           kForcesMagic = "MOLTRAC4", kPlacesMagic = "MOLTRAC3", kStatelessMagic = "MOLTRAC2",
                           kOldMagic = "MOLTRAC1";
// Blocks: of ticks, of one motion, and of the places of the spheres before the first motion.
constexpr std::string_view kBlockMagic = "BLK1", kMotionMagic = "MOV1", kPlacesBlockMagic = "PLC1";
constexpr std::uint32_t kTicksInBlock = 256;
constexpr std::size_t kMinTickBytes = 81;  // size of a tick without settings and device
constexpr std::size_t kMaxBytes = std::size_t{1} << 30;
constexpr std::uint8_t kSettings = 1, kFresh = 2, kConnected = 4, kOtherDevice = 8, kFaultFlag = 16, kFallenBack = 32,
                       kOriented = 64, kSpheresMoved = 128;
constexpr std::uint8_t kAtEdge = 1,
                       kSurface = 2;  // at the end of the settings; files of earlier builds have the first
constexpr std::uint8_t kBodyPose = 1, kNotAtRest = 2;            // of an oriented tick
constexpr std::uint8_t kGivesForce = 1, kRotationalDamping = 2;  // of a device; files of earlier builds have the first

// Identifies the build: identical forces require the same members of the state and the same compiler.
std::string buildName() { return std::to_string(sizeof(ServoStep)) + ' ' + __VERSION__; }

using Putter = BytesPutter;
using Getter = BytesGetter;

// Formats ascending numbers with consecutive ones as ranges: "0-3,7".
std::string rangesText(const std::vector<std::uint32_t>& numbers) {
  std::string out;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    out += (out.empty() ? "" : ",") + std::to_string(numbers[i]);
    if (last > i) out += '-' + std::to_string(numbers[last]);
    i = last + 1;
  }
  return out;
}

// The reduction of a held body's radii, where it is not the default.
constexpr const char* kOverlapLabel = "held-overlap-mA";
constexpr double kMilliPerUnit = 1000.0;

double overlapOf(const std::map<std::string, std::string>& labels) {
  const auto found = labels.find(kOverlapLabel);
  if (found == labels.end()) return kBodyOverlap_A;
  int value = 0;
  const char* const end = found->second.data() + found->second.size();
  const auto read = std::from_chars(found->second.data(), end, value);
  return read.ec == std::errc() && read.ptr == end && value >= 0 && value <= 2000 ? value / kMilliPerUnit
                                                                                  : kBodyOverlap_A;
}

// Parses ranges. Returns an empty list if the text is invalid or names a number that is not below `end`.
std::vector<std::uint32_t> rangesOf(std::string_view text, std::size_t end) {
  std::vector<std::uint32_t> out;
  const char* at = text.data();
  const char* const stop = at + text.size();
  const auto number = [&](std::uint32_t& value) {
    const auto read = std::from_chars(at, stop, value);
    if (read.ec != std::errc()) return false;
    at = read.ptr;
    return true;
  };
  while (at != stop) {
    std::uint32_t first = 0;
    if (!number(first)) return {};
    std::uint32_t last = first;
    if (at != stop && *at == '-' && (++at, !number(last))) return {};
    if (last < first || last >= end || (!out.empty() && first <= out.back())) return {};
    for (std::uint32_t i = first; i <= last; ++i) out.push_back(i);
    if (at != stop && *at++ != ',') return {};
  }
  return out;
}

template <class Each, class Settings>
void settingsFields(Each& each, Settings& s) {
  each(s.workspace.A_per_mm);
  visitVector(each, s.workspace.centre_A);
  for (int k = 0; k < 3; ++k) visitVector(each, s.workspace.rotation[k]);
  each(s.stiffness_N_per_mm), each(s.max_force_N), each(s.probe_A), each(s.discontinuities), each(s.clutch.buttons);
}
template <class Each, class F>
void surfaceFields(Each& each, F& surface) {
  each(surface.friction.coefficient), each(surface.friction.stick_slip);
}
template <class Each, class Figures>
void figuresFields(Each& each, Figures& f) {
  visitVector(each, f.workspace_mm);
  each(f.dof_in), each(f.dof_out), each(f.max_force_N), each(f.continuous_force_N), each(f.max_stiffness_N_per_mm);
  each(f.max_damping_N_s_per_m), each(f.damping_N_s_per_m), each(f.friction_N), each(f.resolution_mm), each(f.delay_s);
  each(f.speed_limit_m_per_s), each(f.slew_limit_N_per_s);
}
template <class Each, class Tick>
void tickFields(Each& each, Tick& t) {
  visitVector(each, t.pose.position.mm);
  each(t.pose.buttons), each(t.pose.discontinuities), each(t.pose.motor_heat), each(t.pose.age_s), each(t.time.dt_s),
      each(t.time.delay_s);
  visitVector(each, t.force.N);
}

bool sameBits(const Vec3& a, const Vec3& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

bool samePose(const std::optional<PoseA>& a, const std::optional<PoseA>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const auto vector = [](const Quat& q) { return Vec3(q.x, q.y, q.z); };
  return sameBits(a->place.A, b->place.A) && sameBits(vector(a->orientation), vector(b->orientation)) &&
         sameBits(Vec3(a->orientation.w), Vec3(b->orientation.w));
}

// True if this program could have made these settings. Poses and figures come from devices, which are untrusted; the
// loop accepts them unchanged.
bool canBe(const ServoSettings& s) {
  const Workspace& w = s.workspace;
  bool rotates = true;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) rotates = rotates && std::abs(w.rotation[k][i]) <= 1.001;
  const auto within = [](double x, double limit) { return x >= 0.0 && x <= limit; };
  return rotates && w.A_per_mm > 1e-6 && w.A_per_mm < 1e6 && finite(w.centre_A) && within(s.stiffness_N_per_mm, 1e6) &&
         within(s.max_force_N, 1e6) && within(s.probe_A, 1e6) && within(s.surface.friction.coefficient, 1e6) &&
         within(s.surface.friction.stick_slip, 1e6);
}

// The loop gives only finite forces within the limits of canBe().
bool canBeGiven(const Vec3& force) {
  constexpr double kMax = 1e6;
  return std::abs(force.x) <= kMax && std::abs(force.y) <= kMax && std::abs(force.z) <= kMax;
}

std::string bytesOf(const ServoSettings& settings) {
  std::string out;
  Putter put{out};
  settingsFields(put, settings);
  const bool surface = settings.surface != SurfaceProperties{};
  put(std::uint8_t(settings.force_on)), put(std::uint8_t(settings.panic));
  put(std::uint8_t((settings.clutch.at_edge ? kAtEdge : 0) | (surface ? kSurface : 0)));
  if (surface) surfaceFields(put, settings.surface);
  return out;
}

template <class Each, class Q>
void orientationFields(Each& each, Q& q) {
  each(q.w), each(q.x), each(q.y), each(q.z);
}

// A tick with an orientation also has the torque if its device drives one.
bool drivesTorque(const DeviceSpecs& device) { return device.dof_out >= 6; }

// The features of a file version.
struct Version {
  bool orientations = true, torques = true, body_poses = true, motions = true;
};

// The pose of the held body and whether it is at rest, in a tick with an orientation.
bool readBody(Getter& get, RecordedTick& tick) {
  std::uint8_t flags = 0;
  get(flags);
  tick.at_rest = !(flags & kNotAtRest);
  if (flags & kBodyPose) {
    PoseA& pose = tick.body_pose.emplace();
    visitVector(get, pose.place.A);
    orientationFields(get, pose.orientation);
    if (!finite(pose.place.A) || !rotates(pose.orientation)) return false;
  }
  return !(flags & ~(kBodyPose | kNotAtRest));
}

bool readTick(Getter& get, ServoSettings& settings, RecordedTick& tick, const Version& version) {
  std::uint8_t flags = 0, on = 0, panic = 0, gives = 0, at_edge = 0;
  get(flags);
  if (flags & kSettings) {
    settingsFields(get, settings);
    get(on), get(panic), get(at_edge);
    settings.clutch.at_edge = at_edge & kAtEdge;
    settings.force_on = on;
    settings.panic = panic;
    settings.surface = {};
    if (at_edge & kSurface) surfaceFields(get, settings.surface);
    get.ok = get.ok && on <= 1 && panic <= 1 && !(at_edge & ~(kAtEdge | kSurface)) && canBe(settings);
  }
  tick.other_device = flags & kOtherDevice;
  if (tick.other_device) {
    figuresFields(get, tick.device);
    if (version.orientations) get(tick.device.max_torque_N_mm);
    get(gives);
    tick.device.gives_force = gives & kGivesForce;
    if (gives & kRotationalDamping) get(tick.device.rotational_damping_N_mm_s);
    get.ok = get.ok && !(gives & ~(kGivesForce | kRotationalDamping));
  }
  tickFields(get, tick);
  if (version.orientations && flags & kOriented) orientationFields(get, tick.pose.orientation);
  if (version.torques && flags & kOriented && drivesTorque(tick.device)) visitVector(get, tick.torque_N_mm);
  if (version.body_poses && flags & kOriented) get.ok = readBody(get, tick) && get.ok;
  tick.pose.fresh = flags & kFresh;
  tick.pose.connected = flags & kConnected;
  tick.pose.fault = flags & kFaultFlag;
  tick.fallen_back = flags & kFallenBack;
  if (flags & kSpheresMoved) {
    tick.motion = kUnknownMotion;
    if (version.motions) get(tick.motion), get(tick.motion_tick);
  }
  tick.settings = settings;
  return get.ok && canBeGiven(tick.force.N) && canBeGiven(tick.torque_N_mm);
}

}  // namespace

Expected<ServoRecordingWriter> ServoRecordingWriter::create(const std::filesystem::path& file, bool replace) {
  auto opened = AppendFile::open(file, replace ? AppendFile::Begin::Replace : AppendFile::Begin::New);
  if (!opened) return opened.problem();
  return ServoRecordingWriter(*std::move(opened));
}

std::optional<Problem> ServoRecordingWriter::begin(const std::map<std::string, std::string>& labels,
                                                   const ServoStep& start) {
  std::string text;
  for (const auto& [key, value] : labels) text += key + '=' + value + '\n';
  std::string head(kMagic);
  Putter put{head};
  const std::string build = buildName(), state = stateText(start);
  put(std::uint32_t(text.size()));
  put(std::uint32_t(build.size()));
  put(std::uint32_t(state.size()));
  head += text + build + state;
  put(std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(head.data()), uInt(head.size()))));
  return broken_ = file_.append(head);
}

std::optional<Problem> ServoRecordingWriter::add(const RecordedTick& tick) {
  if (!broken_ && kept_ + ticks_in_block_ == kMaxRecordedTicks)
    return broken_ = Problem{
               "", 0, 0, tr("a recording is at most 66 minutes and 40 s long; what was recorded until then is kept"),
               tr("begin another one")};
  const bool other_settings = ticks_in_block_ == 0 || bytesOf(*last_) != bytesOf(tick.settings);
  const DevicePose& pose = tick.pose;
  const bool oriented =
      pose.orientation != kNoRotation || !sameBits(tick.torque_N_mm, Vec3(0.0)) || tick.body_pose || !tick.at_rest;
  Putter put{block_};
  put(std::uint8_t((other_settings ? kSettings : 0) | (pose.fresh ? kFresh : 0) | (pose.connected ? kConnected : 0) |
                   (pose.fault ? kFaultFlag : 0) | (tick.other_device ? kOtherDevice : 0) |
                   (tick.fallen_back ? kFallenBack : 0) | (oriented ? kOriented : 0) |
                   (tick.motion ? kSpheresMoved : 0)));
  if (other_settings) block_ += bytesOf(tick.settings);
  if (tick.other_device) {
    device_ = tick.device;
    figuresFields(put, tick.device);
    put(tick.device.max_torque_N_mm);
    const bool damping = tick.device.rotational_damping_N_mm_s != 0.0;
    put(std::uint8_t((tick.device.gives_force ? kGivesForce : 0) | (damping ? kRotationalDamping : 0)));
    if (damping) put(tick.device.rotational_damping_N_mm_s);
  }
  tickFields(put, tick);
  if (oriented) orientationFields(put, pose.orientation);
  if (oriented && drivesTorque(device_)) visitVector(put, tick.torque_N_mm);
  if (oriented) put(std::uint8_t((tick.body_pose ? kBodyPose : 0) | (tick.at_rest ? 0 : kNotAtRest)));
  if (oriented && tick.body_pose) {
    visitVector(put, tick.body_pose->place.A);
    orientationFields(put, tick.body_pose->orientation);
  }
  if (tick.motion) put(tick.motion), put(tick.motion_tick);
  last_ = tick.settings;
  return ++ticks_in_block_ == kTicksInBlock ? writeBlock() : std::nullopt;
}

std::optional<Problem> ServoRecordingWriter::place(std::span<const Sphere> spheres) {
  return append(kPlacesBlockMagic, 0, bytesOf(spheres));
}

std::optional<Problem> ServoRecordingWriter::addMotion(const RecordedMotion& motion) {
  return append(kMotionMagic, 0, bytesOf(motion));
}

std::optional<Problem> ServoRecordingWriter::append(std::string_view magic, std::uint32_t ticks,
                                                    const std::string& bytes) {
  std::string whole(magic);
  Putter put{whole};
  put(ticks);
  put(std::uint32_t(bytes.size()));
  put(std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), uInt(bytes.size()))));
  whole += bytes;
  if (!broken_) broken_ = file_.append(whole);
  return broken_;
}

std::optional<Problem> ServoRecordingWriter::writeBlock() {
  if (ticks_in_block_ == 0) return broken_;
  if (!append(kBlockMagic, ticks_in_block_, block_)) kept_ += ticks_in_block_;
  block_.clear();
  ticks_in_block_ = 0;
  return broken_;
}

std::optional<Problem> ServoRecordingWriter::finish() {
  if (auto problem = writeBlock()) return problem;
  return file_.sync();
}

Expected<ServoRecording> readServoRecording(const std::filesystem::path& file) {
  const auto bytes = readFile(file, kMaxBytes, tr("a recording has 81 bytes per tick: is this file one?"));
  if (!bytes) return bytes.problem();
  const char* data = bytes->data();
  const Problem none{file.string(), 0, 0, tr("this is no recording of a device"),
                     tr("recordings are made by `moltact device record`")};
  const std::size_t fixed = kMagic.size() + 12;
  if (std::string_view(*bytes).starts_with(kOldMagic))
    return Problem{file.string(), 0, 0, tr("this recording is of an earlier version, whose ticks hold less"),
                   tr("record it again")};
  const bool stateless = std::string_view(*bytes).starts_with(kStatelessMagic);
  Version version;
  version.orientations = !stateless && !std::string_view(*bytes).starts_with(kPlacesMagic);
  version.motions = std::string_view(*bytes).starts_with(kMagic);
  version.body_poses = version.motions || std::string_view(*bytes).starts_with(kBodyPosesMagic);
  version.torques = version.body_poses || std::string_view(*bytes).starts_with(kTorquesMagic);
  if (bytes->size() < fixed ||
      (version.orientations && !version.torques && !std::string_view(*bytes).starts_with(kForcesMagic)))
    return none;
  Getter get{data + kMagic.size(), data + bytes->size()};
  std::uint32_t text_size = 0, build_size = 0, state_size = 0, crc = 0;
  get(text_size), get(build_size), get(state_size);
  const std::size_t head = fixed + std::size_t(text_size) + build_size + state_size;
  if (head + 4 > bytes->size())
    return Problem{file.string(), 0, 0, tr("the recording breaks off in its first lines"), tr("record it again")};
  get.at = data + head;
  get(crc);
  if (crc != crc32(0, reinterpret_cast<const Bytef*>(data), uInt(head)))
    return Problem{file.string(), 0, 0, tr("the recording's first lines are damaged"), tr("record it again")};

  ServoRecording recording;
  recording.torques = version.torques;
  recording.body_poses = version.body_poses;
  const std::string_view text(data + fixed, text_size);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size()), equals = text.find('=', at);
    if (equals < end)
      recording.labels[std::string(text.substr(at, equals - at))] =
          std::string(text.substr(equals + 1, end - equals - 1));
    at = end + 1;
  }
  if (version.orientations && std::string_view(data + fixed + text_size, build_size) == buildName()) {
    auto state = stepFromText({data + fixed + text_size + build_size, state_size});
    if (!state) return Problem{file.string(), 0, 0, state.problem().message, state.problem().remedy};
    recording.start = *std::move(state);
  }

  recording.ticks.reserve(std::min(kMaxRecordedTicks, static_cast<std::size_t>(get.end - get.at) / kMinTickBytes));
  DeviceSpecs device;
  while (get.at < get.end) {
    const auto torn = [&](const char* sentence) {
      recording.torn =
          trf(sentence, quantityText(double(recording.ticks.size()) * kTick_s, Dimension::Time, decimals(3)));
    };
    std::uint32_t count = 0, size = 0, block_crc = 0;
    const std::string_view magic(get.at, std::min(get.left(), kBlockMagic.size()));
    const bool of_ticks = magic == kBlockMagic,
               block = of_ticks || (version.motions && (magic == kMotionMagic || magic == kPlacesBlockMagic));
    if (block) get.at += magic.size();
    get(count), get(size), get(block_crc);
    if (!get.ok || static_cast<std::size_t>(get.end - get.at) < size) {
      torn(N_("the recording is truncated after {0}; the part before that is kept"));
      break;
    }
    Getter inside{get.at, get.at + size};
    get.at += size;
    bool good =
        block && count <= kTicksInBlock && block_crc == crc32(0, reinterpret_cast<const Bytef*>(inside.at), uInt(size));
    if (good && !of_ticks) {
      const std::string_view content(inside.at, size);
      auto motion = magic == kMotionMagic ? motionOfBytes(content) : std::nullopt;
      auto places = magic == kPlacesBlockMagic ? spheresOfBytes(content) : std::nullopt;
      if (motion) recording.motions.push_back(*std::move(motion));
      if (places) recording.placed = *std::move(places);
      if (motion || places) continue;
      good = false;
    }
    ServoSettings settings;
    std::vector<RecordedTick> ticks(good ? count : 0);
    for (RecordedTick& tick : ticks) {
      tick.device = device;
      good = good && readTick(inside, settings, tick, version) &&
             (tick.motion == kUnknownMotion || tick.motion <= recording.motions.size());
      device = tick.device;
    }
    if (good && ticks.size() > kMaxRecordedTicks - recording.ticks.size()) {
      torn(N_("the recording exceeds the maximum length after {0}; the part before that is kept"));
      break;
    }
    if (!good || inside.at != inside.end) {
      torn(N_("the recording is damaged after {0}; the part before that is kept"));
      break;
    }
    recording.ticks.insert(recording.ticks.end(), ticks.begin(), ticks.end());
  }
  return recording;
}

std::map<std::string, std::string> sceneLabels(const SphereGrid& scene, const HeldBody* body) {
  std::map<std::string, std::string> labels{{"balls", fingerprint(scene)}};
  if (scene.hasUntouchable()) labels["untouchable"] = rangesText(scene.untouchable());
  if (body) labels["held"] = rangesText(body->atoms);
  if (body && body->overlap_A != kBodyOverlap_A)
    labels[kOverlapLabel] = std::to_string(std::lround(body->overlap_A * kMilliPerUnit));
  return labels;
}

RecordedScene recordedScene(const std::map<std::string, std::string>& labels, SharedArray<Sphere> spheres) {
  const auto listed = [&](const char* key) {
    const auto found = labels.find(key);
    return found == labels.end() ? std::vector<std::uint32_t>() : rangesOf(found->second, spheres.size());
  };
  RecordedScene out;
  out.body = heldBody(spheres, listed("held"), overlapOf(labels));
  const std::vector<std::uint32_t> untouchable = listed("untouchable");
  out.spheres = std::make_shared<const SphereGrid>(std::move(spheres), untouchable);
  return out;
}

TouchSetup touchOf(const ServoRecording& recording) {
  TouchSetup out = labelledTouch(recording.labels);
  recording.ticks.front().settings.giveTo(out);
  return out;
}

ReplayResult replay(const ServoRecording& recording, Interaction* interaction, const SphereGrid* scene) {
  ServoStep step = recording.start.value_or(ServoStep());
  ReplayResult out;
  static const SphereGrid kNone{SharedArray<Sphere>()};
  MotionReplay motions(recording.motions, scene ? *scene : kNone);
  for (const RecordedTick& tick : recording.ticks) {
    if (tick.other_device) step.setDevice(tick.device);
    const std::optional<MotionPhase> phase =
        tick.motion == kUnknownMotion ? std::nullopt : motions.at(tick.motion, tick.motion_tick);
    const ServoSample now = step.tick(tick.settings, interaction, tick.pose, tick.time, phase.value_or(MotionPhase{}));
    const bool same_torque = !recording.torques || sameBits(now.torque_N_mm, tick.torque_N_mm);
    const bool same_pose = !recording.body_poses || samePose(now.body_pose, tick.body_pose);
    if (!sameBits(now.force.N, tick.force.N) || !same_torque || !same_pose) {
      if (!out.first_difference) out.first_difference = out.ticks;
      out.max_difference_N = std::max(out.max_difference_N, glm::distance(now.force.N, tick.force.N));
      if (!same_torque)
        out.max_difference_N_mm = std::max(out.max_difference_N_mm, glm::distance(now.torque_N_mm, tick.torque_N_mm));
      if (now.body_pose && tick.body_pose)
        out.max_difference_A =
            std::max(out.max_difference_A, glm::distance(now.body_pose->place.A, tick.body_pose->place.A));
    }
    ++out.ticks;
    out.motion_unknown += !phase;
  }
  return out;
}

std::string fingerprint(const SphereGrid& scene) {
  std::uint64_t hash = 14695981039346656037u;
  for (const Sphere& sphere : scene.spheres())
    for (const double value : {sphere.centre_A.x, sphere.centre_A.y, sphere.centre_A.z, sphere.radius_A})
      for (std::uint64_t bits = std::bit_cast<std::uint64_t>(value), k = 0; k < 8; ++k, bits >>= 8)
        hash = (hash ^ (bits & 0xFF)) * 1099511628211u;
  // Untouchable spheres make a different scene of the same spheres.
  for (const std::uint32_t i : scene.untouchable())
    for (std::uint64_t bits = i, k = 0; k < 4; ++k, bits >>= 8) hash = (hash ^ (bits & 0xFF)) * 1099511628211u;
  char text[40];
  std::snprintf(text, sizeof text, "%zu %016llx", scene.size(), static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace moltact
