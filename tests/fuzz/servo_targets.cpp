// Recordings of a hand: arbitrary bytes, blocks of ticks with any numbers and a correct checksum, and initial states.
// Accepted ones are replayed: every force is finite and at most the device's maximum. Also hands' paths as rows of
// numbers: accepted ones survive writing and reading unchanged.
#include <cmath>
#include <limits>

#include "engine/bench/scenes.h"
#include "engine/haptics/methods.h"
#include "engine/servo/hand_path.h"
#include "engine/servo/playback_device.h"
#include "engine/servo/servo_recording.h"
#include "tests/fuzz/recording_maker.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

void replayed(const std::string& file) {
  static const auto scene = std::make_shared<const SphereGrid>(scenes::cluster(20, 3).spheres);
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

// A motion of these bytes, and one of spheres with some bytes changed; reconstructed, it is finite.
void motion(std::string_view bytes, Choices& choices) {
  std::string written = moltact::bytesOf(RecordedMotion{.ticks = 3,
                                                        .from = {{{0, 0, 0}, 1.0}, {{3, 0, 0}, 1.5}},
                                                        .changes = {{Vec3(0.5, 0, 0), 0.0}, {Vec3(0, 0.2, 0), 0.1}}});
  for (std::size_t n = choices.pick(6); n > 0; --n) written[choices.pick(written.size())] = char(choices.pick(256));
  for (const std::string_view tried : {bytes, std::string_view(written)}) {
    const auto read = motionOfBytes(tried);
    if (!read) continue;
    const std::vector<RecordedMotion> twice{*read, *read};
    const SphereGrid scene(std::vector<Sphere>(read->changes.size(), Sphere{{0, 0, 0}, 1.0}));
    MotionReplay replayed(twice, scene);
    for (std::uint32_t number = 1; number <= 2; ++number)
      for (const std::int32_t tick : {0, 1, read->ticks}) {
        const auto phase = replayed.at(number, tick);
        if (!phase) continue;
        mustBe(phase->fraction >= 0.0 && phase->fraction <= 1.0, "a fraction");
        for (const Sphere& s : phase->motion->at(phase->fraction))
          mustBe(finite(s.centre_A) && std::isfinite(s.radius_A), "spheres that are numbers");
      }
  }
}

// Eight ticks that come from outside into the cluster.
const RecordingParts& sample() {
  static const RecordingParts out = [] {
    std::vector<RecordedTick> ticks(8);
    for (std::size_t k = 0; k < ticks.size(); ++k) ticks[k].pose.position.mm.x = 30.0 - 4.0 * double(k);
    ticks[1].other_device = ticks[1].device.gives_force = true;
    for (std::size_t k = 2; k < ticks.size(); ++k) ticks[k].device = ticks[1].device;
    ticks[4].settings.stiffness_N_per_mm = 0.3;
    return partsOf(recordingOf({{"molecule", "1ubq"}, {"method", "exact"}}, ticks));
  }();
  return out;
}

}  // namespace

void recording(std::string_view bytes) {
  replayed(fileOf(bytes, "a.recording"));
  // The same changes to the ticks, under a checksum that is right.
  Choices choices(bytes);
  RecordingParts changed = sample();
  std::string& ticks = changed.ticks;
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
  replayed(fileOf(changed.file(), "a.recording"));
  replayed(fileOf(madeRecording(choices, 16, {}), "a.recording"));
  motion(bytes, choices);
}

void recordingState(std::string_view bytes) {
  Choices choices(bytes);
  RecordingParts changed = sample();
  changeState(changed.state, choices);
  replayed(fileOf(changed.file(), "a.recording"));
}

void handPath(std::string_view bytes) {
  const auto path = readHandPath(fileOf(bytes, "a.hand"));
  if (!path) return mustBe(!path.problem().message.empty(), "a message");
  mustBe(!path->places.empty(), "a place");
  mustBe(path->touched.empty() || path->touched.size() == path->places.size(), "a touch a tick, or none");
  mustBe(path->probe_A >= 0.0 && path->probe_A <= kMaxProbe_A, "a probe in its range");
  for (const Vec3& p : path->places) mustBe(finite(p), "places that are numbers");
  if (path->places.size() > 10'000) return;  // some bytes can last for hours
  const auto again = readHandPath(fileOf(textOf(*path), "b.hand"));
  mustBe(again && again->places.size() == path->places.size() && again->on_molecule == path->on_molecule,
         "a way that can be written");
  for (std::size_t k = 0; k < path->places.size(); ++k)
    mustBe(glm::distance(again->places[k], path->places[k]) < 1e-3, "the same way");
}

}  // namespace moltact::fuzz
