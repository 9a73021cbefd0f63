#include "engine/servo/device_check.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

#include "engine/device/mouse_device.h"
#include "engine/servo/faulty_device.h"
#include "engine/servo/plain_trackers.h"
#include "engine/servo/servo_thread.h"

namespace moltact {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kTry_N = 0.4, kWall_N_per_mm = 0.4, kMax_N = 2.0;
constexpr double kStill_mm = 0.5;        // largest wander of a position at rest
constexpr double kStaleFraction = 0.05;  // tolerated fraction of stale ticks; a busy computer has some
constexpr double kBack_s =
    8.0;  // time for the force to return after a fault; after a stall the loop stays soft for some seconds
constexpr double kOver_s = 1.0;  // time by which a fault is over, and by which a tick has come
constexpr auto kStep = std::chrono::milliseconds(10);

std::string text(const char* format, auto... values) {
  char out[240];
  std::snprintf(out, sizeof out, format, values...);
  return out;
}

class Check {
 public:
  Check(std::unique_ptr<Device> device, const DeviceCheckOptions& options)
      : options_(options), gives_(device->info().gives_force) {
    settings_.workspace.A_per_mm = 1.0;
    settings_.stiffness_N_per_mm = kWall_N_per_mm;
    settings_.max_force_N = std::min(kMax_N, device->info().max_force_N);
    servo_.loop().setSettings(settings_);
    auto faulty = std::make_unique<FaultyDevice>(std::move(device));
    device_ = faulty.get();
    servo_.setDevice(std::move(faulty));
  }

  std::vector<CheckedPart> run() {
    if (!ready()) stop_ = stopped() ? "broken off" : notReady();
    quiet("places at rest", [this] { still(); });
    if (!gives_) return out_;
    part("gentle pull", text("The device will pull to the right with %.1f N, slowly growing. Hold it lightly.", kTry_N),
         [this] { constantForce(); });
    part("stopped by the panic key", "It will pull again and be stopped in between.", [this] { panic(); });
    part("late, lost and doubled ticks",
         "It will pull while the program ticks badly: the force goes and comes back softly.", [this] { badTicks(); });
    part("misread places", "It will pull while its places are misread: the force goes and comes back softly.",
         [this] { badPlaces(); });
    part("a window that stands", "It will pull while the window stands: you feel nothing of that.",
         [this] { standingWindow(); });
    part("another scene in contact", "It will pull to the right and to the left by turns, softly each time.",
         [this] { swaps(); });
    part("wall", "There will be a wall in the middle, facing you. Press on it and let go, a few times.",
         [this] { wall(); });
    if (options_.unplug_s > 0.0)
      part("unplugged and plugged in", "It will pull, and you will be asked to pull out its plug.",
           [this] { unplug(); });
    return out_;
  }

 private:
  struct Seen {
    FaultyDevice::Given given;
    std::vector<ServoSample> ticks;
    double latest_ms = 0;
    bool connected = true;
  };

  bool stopped() {
    if (!stop_.empty() || !options_.interrupted || !options_.interrupted()) return !stop_.empty();
    settings_.panic = true;
    servo_.loop().setSettings(settings_);
    stop_ = "broken off";
    return true;
  }

  // Waits until the device can give force and reports fresh positions; instructs the user accordingly.
  bool ready() {
    const auto end = Clock::now() + std::chrono::duration<double>(options_.ready_s);
    device_->given();
    for (std::uint64_t fresh = 0; Clock::now() < end && !stopped();) {
      std::this_thread::sleep_for(kStep);
      servo_.loop().drain([](const ServoSample&) {});
      fresh += device_->given().fresh;
      status_ = device_->status();
      if (status_.ready && status_.connected && fresh > 0) return true;
      if (!status_.ready && options_.guide && options_.guide(status_)) device_->calibrate();
    }
    return false;
  }
  std::string notReady() const {
    return status_.ready ? "no place has come from the device" : "the device is not ready. " + status_.text;
  }

  // Observes the forces given to the device for that time, and every tick of it.
  Seen watch(double seconds) {
    Seen seen;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (Clock::now() < end && !stopped()) {
      std::this_thread::sleep_for(kStep);
      status_ = device_->status();
      seen.connected = seen.connected && status_.connected;
      servo_.loop().drain([&](const ServoSample& s) {
        seen.ticks.push_back(s);
        seen.latest_ms = std::max(seen.latest_ms, double(s.late_us) * 1e-3);
      });
    }
    seen.given = device_->given();
    all_.ticks += seen.given.ticks;
    all_.peak_N = std::max(all_.peak_N, seen.given.peak_N);
    if (!all_.broken) all_.broken = seen.given.broken;
    return seen;
  }

  template <class Done>
  bool watchUntil(double max_s, Done done) {
    const auto end = Clock::now() + std::chrono::duration<double>(max_s);
    while (!done(watch(0.02)))
      if (Clock::now() >= end || stopped()) return false;
    return true;
  }
  bool feltAgain() {
    return watchUntil(kBack_s, [](const Seen& seen) { return seen.given.last_N > 0.5 * kTry_N; });
  }

  void feel(std::unique_ptr<Tracker> tracker) {
    ++settings_.discontinuities;
    servo_.loop().setSettings(settings_);
    servo_.loop().setInteraction(std::move(tracker));
  }
  void feelForce(double sign = 1.0) { feel(std::make_unique<ConstantForceTracker>(sign * kTry_N / kWall_N_per_mm)); }

  template <class Body>
  void quiet(const char* name, Body body) {
    out_.push_back({.name = name});
    if (stopped())
      out_.back().found = stop_;
    else
      doPart(body);
    if (options_.checked) options_.checked(out_.back());
  }
  template <class Body>
  void part(const char* name, const std::string& question, Body body) {
    out_.push_back({.name = name, .forces = true});
    if (stopped() || (options_.ask && !options_.ask(question)) || stopped())
      out_.back().found = stop_.empty() ? "not wanted" : stop_;
    else
      doPart(body);
    if (options_.checked) options_.checked(out_.back());
  }
  template <class Body>
  void doPart(Body body) {
    out_.back().done = true;
    all_ = {};
    device_->given();
    servo_.loop().drain([](const ServoSample&) {});
    body();
    feel(nullptr);
    if (stopped())
      found(false, "broken off");
    else if (!out_.back().passed && !status_.text.empty())
      out_.back().found += ". " + status_.text;
    if (!out_.back().passed && stop_.empty()) stop_ = "an earlier part failed";
  }
  void found(bool passed, std::string words) {
    out_.back().passed = passed;
    out_.back().found = std::move(words);
  }
  // Checks the conditions for every tick that the device was given, and that there was a force.
  void foundSound(bool as_wanted, const std::string& words) {
    const bool sound = !all_.broken && all_.ticks > 0 && all_.peak_N <= settings_.max_force_N + 1e-9;
    found(sound && as_wanted,
          words + text("; %llu ticks, at most %.2f N", static_cast<unsigned long long>(all_.ticks), all_.peak_N) +
              (all_.broken ? std::string("; ") + all_.broken : ""));
  }

  void still() {
    if (options_.tell) options_.tell("Lay the stylus down, or hold it still.");
    const Seen seen = watch(options_.part_s);
    Vec3 low(1e300), high(-1e300);
    std::size_t strange = 0, stale = 0;
    for (const ServoSample& s : seen.ticks) {
      if (!finite(s.hand.mm)) ++strange;
      low = glm::min(low, s.hand.mm);
      high = glm::max(high, s.hand.mm);
      strange += s.limits.has(Limit::Jump);
      stale += s.limits.has(Limit::StalePlace);
    }
    const double wandered = seen.ticks.empty() ? 0 : glm::length(high - low);
    // A hand that moves on its own, such as a simulated one, does not indicate faulty positions.
    const std::string rest = wandered <= kStill_mm ? "" : " (more than a device at rest: was it held still?)";
    const bool fresh = !seen.ticks.empty() && double(stale) <= kStaleFraction * double(seen.ticks.size());
    found(fresh && strange == 0 && seen.connected && status_.ready && seen.given.peak_N == 0.0,
          text("%zu ticks, wandered %.3f mm%s, %zu places strange, %zu stale, latest tick %.1f ms late",
               seen.ticks.size(), wandered, rest.c_str(), strange, stale, seen.latest_ms));
  }

  void constantForce() {
    feelForce();
    const Seen seen = watch(options_.part_s);
    foundSound(seen.connected && seen.given.peak_N > 0.5 * kTry_N, "it pulled");
  }

  void panic() {
    feelForce();
    watch(0.5 * options_.part_s);
    settings_.panic = true;
    servo_.loop().setSettings(settings_);
    const Seen seen = watch(0.5 * options_.part_s);
    settings_.panic = false;
    servo_.loop().setSettings(settings_);
    // Ticks before the panic key was seen may still have force; from the first stopped one on there must be none.
    std::size_t forced = 0, stopped_ticks = 0;
    for (const ServoSample& s : seen.ticks) {
      stopped_ticks += s.limits.has(Limit::Panic);
      forced += s.limits.has(Limit::Panic) && s.force.N != Vec3(0.0);
    }
    foundSound(stopped_ticks > 0 && forced == 0,
               text("%zu ticks stopped, %zu of them with force", stopped_ticks, forced));
  }

  // The faults one after another, each starting from full force.
  struct Injected {
    LoopFault fault;
    int ticks;
  };
  void suffer(std::initializer_list<Injected> faults) {
    feelForce();
    std::size_t felt = 0, over = 0;
    for (const Injected& one : faults) {
      felt += feltAgain();
      device_->inject(one.fault, one.ticks);
      over += watchUntil(kOver_s, [this](const Seen&) { return device_->faultIsOver(); });
    }
    const bool back = feltAgain();
    foundSound(felt == faults.size() && over == faults.size() && back,
               text("%zu of %zu faults met its force, which %s after the last", felt, faults.size(),
                    back ? "came back" : "did not come back"));
  }
  void badTicks() {
    suffer({{LoopFault::Late, 15}, {LoopFault::Doubled, 50}, {LoopFault::Lost, 60}, {LoopFault::Stall, 60}});
  }
  void badPlaces() {
    suffer({{LoopFault::PositionJump, 1},
            {LoopFault::NotANumber, 50},
            {LoopFault::PositionJump, 5},
            {LoopFault::Frozen, 100},
            {LoopFault::NotANumber, 1}});
  }

  void standingWindow() {
    feelForce();
    feltAgain();
    const auto end = Clock::now() + std::chrono::duration<double>(options_.part_s);
    while (Clock::now() < end && !stopped())
      std::this_thread::sleep_for(kStep);  // neither the device nor the ticks are read
    const Seen seen = watch(0.1);
    foundSound(seen.given.last_N > 0.5 * kTry_N, text("the window stood for %.1f s", options_.part_s));
  }

  void swaps() {
    std::vector<ServoSample> ticks;
    for (int k = 0; k < 6; ++k) {
      feelForce(k % 2 ? -1.0 : 1.0);
      const Seen seen = watch(0.2 + 0.05 * k);
      ticks.insert(ticks.end(), seen.ticks.begin(), seen.ticks.end());
    }
    // After each tick that discarded the contact, the force must return softly.
    ForceMonitor judge(settings_.max_force_N);
    std::size_t placed = 0;
    const char* broken = nullptr;
    for (const ServoSample& s : ticks) {
      if (s.contact_reset) judge.expectSoft(), ++placed;
      if (const char* now = judge.judge(s.force.N, {.at_once = s.limits.has(Limit::LateLoop)}); now && !broken)
        broken = now;
    }
    foundSound(placed >= 6 && !broken,
               text("%zu times placed anew", placed) + (broken ? std::string(", ") + broken : ""));
  }

  void wall() {
    PointMm hand;
    const bool ticked = watchUntil(kOver_s, [&hand](const Seen& seen) {
      if (!seen.ticks.empty()) hand = seen.ticks.back().hand;
      return !seen.ticks.empty();
    });
    if (!ticked) return found(false, "no tick has come");
    feel(std::make_unique<WallTracker>(hand.mm.z - 5.0));
    const Seen seen = watch(2.0 * options_.part_s);
    std::size_t touching = 0, damped = 0;
    for (const ServoSample& s : seen.ticks) {
      touching += s.contact.touching();
      damped += s.limits.has(Limit::Damping) || s.limits.has(Limit::EnergyCut);
    }
    foundSound(seen.connected, text("%zu of %zu ticks in contact, %zu in which made energy was braked away%s", touching,
                                    seen.ticks.size(), damped, touching ? "" : "; nobody pressed on it"));
  }

  void unplug() {
    feelForce();
    feltAgain();
    if (options_.tell) options_.tell("Pull the device's plug out now.");
    if (!waitForPlug(false)) return notDone("it was not unplugged");
    const Seen away = watch(0.5);
    const bool silent = away.given.last_N == 0.0;
    if (options_.tell) options_.tell("Now plug it in again, and hold it lightly.");
    if (!waitForPlug(true)) return notDone("it was not plugged in again");
    const bool back = feltAgain();
    foundSound(silent && back, (silent ? "no force" : text("%.2f N", away.given.last_N)) + " while it was away, " +
                                   (back ? "and softly back" : "and none after it"));
  }
  bool waitForPlug(bool in) {
    return watchUntil(options_.unplug_s, [&](const Seen&) {
      if (in && status_.connected && !status_.ready && options_.guide && options_.guide(status_)) device_->calibrate();
      return in ? status_.connected && status_.ready : !status_.connected;
    });
  }
  void notDone(const char* why) {
    out_.back().done = false;
    found(true, why);
  }

  const DeviceCheckOptions& options_;
  bool gives_;
  MouseDevice mouse_;
  ServoSettings settings_;
  ServoThread servo_{mouse_};
  FaultyDevice* device_ = nullptr;  // owned by the loop
  DeviceStatus status_;
  FaultyDevice::Given all_;  // of the present part
  std::string stop_;         // why the check was ended
  std::vector<CheckedPart> out_;
};

}  // namespace

std::vector<CheckedPart> checkDevice(std::unique_ptr<Device> device, const DeviceCheckOptions& options) {
  return Check(std::move(device), options).run();
}

}  // namespace moltact
