#include "engine/servo/device_check.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

#include "engine/device/mouse_device.h"
#include "engine/servo/plain_trackers.h"
#include "engine/servo/servo_thread.h"

namespace moltact {
namespace {

constexpr double kPull_N = 0.4, kWall_N_per_mm = 0.4;
constexpr double kStill_mm = 0.5;      // a place at rest wanders by no more
constexpr double kSlewATick_N = safety::kSlew_N_per_s * kTick_s;
constexpr double kRounding = 1e-9;

std::string text(const char* format, auto... values) {
  char out[240];
  std::snprintf(out, sizeof out, format, values...);
  return out;
}

class Check {
 public:
  Check(std::unique_ptr<Device> device, const DeviceCheckOptions& options) : options_(options), gives_(device->info().gives_force), peak_N_(device->info().max_force_N) {
    settings_.workspace.A_per_mm = 1.0;
    settings_.stiffness_N_per_mm = kWall_N_per_mm;
    settings_.max_force_N = std::min(2.0, peak_N_);
    servo_.setSettings(settings_);
    servo_.setDevice(std::move(device));
  }

  std::vector<CheckedPart> run() {
    still();
    if (gives_) {
      part("gentle pull", text("The device will pull to the right with %.1f N, slowly growing. Hold it lightly.", kPull_N), [this] { pull(); });
      part("stopped by the panic key", "It will pull again and be stopped in between.", [this] { panic(); });
      part("wall", "There will be a wall in the middle, facing you. Press on it and let go, a few times.", [this] { wall(); });
    }
    return out_;
  }

 private:
  struct Seen {
    std::vector<ServoSample> ticks;
    double greatest_N = 0, greatest_step_N = 0, latest_ms = 0;
    bool finite = true, connected = true;
  };

  Seen watch(double seconds) {
    Seen seen;
    servo_.drain([](const ServoSample&) {});
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    Vec3 last(0.0);
    bool first = true;
    while (std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      if (Device* device = servo_.device()) seen.connected = seen.connected && device->status().connected;
      servo_.drain([&](const ServoSample& s) {
        seen.ticks.push_back(s);
        seen.finite = seen.finite && finite(s.force.N);
        seen.greatest_N = std::max(seen.greatest_N, glm::length(s.force.N));
        if (!first && !s.limits.has(Limit::Panic)) seen.greatest_step_N = std::max(seen.greatest_step_N, glm::distance(s.force.N, last));
        last = s.force.N;
        first = false;
        seen.latest_ms = std::max(seen.latest_ms, double(s.late_us) * 1e-3);
      });
    }
    return seen;
  }

  void feel(std::unique_ptr<Tracker> tracker) {
    ++settings_.placements;
    servo_.setSettings(settings_);
    servo_.setTracker(std::move(tracker));
  }

  template <class Body>
  void part(const char* name, const std::string& question, Body body) {
    out_.push_back({.name = name});
    if (failed_) {
      out_.back().found = "left out, for an earlier part failed";
      return;
    }
    if (options_.ask && !options_.ask(question)) {
      out_.back().found = "left out";
      return;
    }
    out_.back().done = true;
    body();
    feel(nullptr);
    failed_ = failed_ || !out_.back().passed;
  }
  void found(bool passed, std::string words) {
    out_.back().passed = passed;
    out_.back().found = std::move(words);
  }
  // What holds of every tick.
  bool sound(const Seen& seen) const {
    return !seen.ticks.empty() && seen.finite && seen.connected && seen.greatest_N <= settings_.max_force_N + kRounding &&
           seen.greatest_step_N <= kSlewATick_N + kRounding;
  }

  void still() {
    out_.push_back({.name = "places at rest"});
    out_.back().done = true;
    if (options_.tell) options_.tell("Lay the stylus down, or hold it still.");
    const Seen seen = watch(options_.part_s);
    Vec3 low(1e300), high(-1e300);
    std::size_t strange = 0;
    for (const ServoSample& s : seen.ticks) {
      if (!finite(s.hand.mm)) ++strange;
      low = glm::min(low, s.hand.mm);
      high = glm::max(high, s.hand.mm);
      strange += s.limits.has(Limit::Jump) || s.limits.has(Limit::StalePlace);
    }
    const double wandered = seen.ticks.empty() ? 0 : glm::length(high - low);
    // A hand that moves on its own, as a simulated one does, is no fault of the places.
    const std::string rest = wandered <= kStill_mm ? "" : " (more than a device at rest: was it held still?)";
    found(!seen.ticks.empty() && strange == 0 && seen.connected && seen.greatest_N == 0,
          text("%zu ticks, wandered %.3f mm%s, %zu places strange or stale, latest tick %.1f ms late", seen.ticks.size(), wandered, rest.c_str(), strange, seen.latest_ms));
    failed_ = !out_.back().passed;
  }

  void pull() {
    feel(std::make_unique<PullTracker>(kPull_N / kWall_N_per_mm));
    const Seen seen = watch(options_.part_s);
    found(sound(seen) && seen.greatest_N > 0.5 * kPull_N, text("at most %.2f N, at most %.3f N more from tick to tick", seen.greatest_N, seen.greatest_step_N));
  }

  void panic() {
    feel(std::make_unique<PullTracker>(kPull_N / kWall_N_per_mm));
    watch(0.5 * options_.part_s);
    settings_.panic = true;
    servo_.setSettings(settings_);
    Seen seen = watch(0.5 * options_.part_s);
    settings_.panic = false;
    servo_.setSettings(settings_);
    // The ticks before the key was seen may still have force; from the first stopped one on there is none.
    std::size_t forced = 0, stopped = 0;
    for (const ServoSample& s : seen.ticks) {
      stopped += s.limits.has(Limit::Panic);
      forced += s.limits.has(Limit::Panic) && s.force.N != Vec3(0.0);
    }
    found(stopped > 0 && forced == 0, text("%zu ticks stopped, %zu of them with force", stopped, forced));
  }

  void wall() {
    feel(std::make_unique<WallTracker>(servo_.latest().hand.mm.z - 5.0));
    const Seen seen = watch(2.0 * options_.part_s);
    std::size_t touching = 0, damped = 0;
    for (const ServoSample& s : seen.ticks) {
      touching += s.contact.touching();
      damped += s.limits.has(Limit::Damping) || s.limits.has(Limit::EnergyCut);
    }
    found(sound(seen), text("%zu of %zu ticks in contact, at most %.2f N, %zu ticks in which made energy was braked away", touching, seen.ticks.size(), seen.greatest_N, damped));
    if (touching == 0) out_.back().found += "; nobody pressed on it";
  }

  const DeviceCheckOptions& options_;
  bool gives_;
  double peak_N_;
  MouseDevice mouse_;
  ServoSettings settings_;
  ServoThread servo_{mouse_};
  std::vector<CheckedPart> out_;
  bool failed_ = false;
};

}  // namespace

std::vector<CheckedPart> checkDevice(std::unique_ptr<Device> device, const DeviceCheckOptions& options) {
  return Check(std::move(device), options).run();
}

}  // namespace moltact
