#include "tests/servo/fault_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "engine/bench/scenes.h"
#include "engine/device/device_model.h"
#include "engine/haptics/methods.h"
#include "engine/servo/force_monitor.h"
#include "engine/servo/servo_step.h"
#include "engine/workspace/scale.h"
#include "tests/haptics/walk.h"

namespace moltact::test {
namespace {

// The promises, as docs/safety.md makes them.
constexpr double kPeak_N = 3.3;
constexpr double kRest_m_per_s = 0.03;  // half a step of the sensor a tick is what its rounding makes
constexpr double kRounding_J = 1e-5;    // a step of the sensor at 0.5 N
// What a tick may show above the least of the ticks before it: a hundredth of what 3.3 N store at 0.5 N/mm.
constexpr double kMade_J = 1e-4;

enum class Fault : int {
  Late,
  Stall,
  LongStall,
  Doubled,
  ClockBack,
  ClockAhead,
  ClockNaN,
  Teleport,
  PlaceNaN,
  Stale,
  Unplug,
  RendererStalls,
  SceneSwap,
  MethodSwap,
  BadSettings,
  ProbeJump,
  Panic,
  ForceOff,
  BadTracker,
  Rescaled,
  FallBack,
  WeakDevice,
  PanicUnplugged,
  LessonSwap,
  OrientationLeap,
  OrientationNaN,
  AtomLeaps,
  ProteinShakes,
  Count,
};
constexpr std::array<const char*, static_cast<int>(Fault::Count)> kNames{"late",
                                                                         "stall",
                                                                         "long stall",
                                                                         "doubled",
                                                                         "clock back",
                                                                         "clock ahead",
                                                                         "clock NaN",
                                                                         "teleport",
                                                                         "place NaN",
                                                                         "stale",
                                                                         "unplug",
                                                                         "renderer stalls",
                                                                         "scene swap",
                                                                         "method swap",
                                                                         "bad settings",
                                                                         "probe jump",
                                                                         "panic",
                                                                         "force off",
                                                                         "bad tracker",
                                                                         "rescaled",
                                                                         "fall back",
                                                                         "weak device",
                                                                         "panic unplugged",
                                                                         "lesson swap",
                                                                         "orientation leap",
                                                                         "orientation NaN",
                                                                         "atom leaps",
                                                                         "protein shakes"};

// A method that answers with what no place is.
class BadTracker final : public Tracker {
 public:
  explicit BadTracker(Vec3 scp) : scp_(scp) {}
  Contact step(PointA hip) noexcept override {
    Contact out{.scp = {scp_}, .atoms = {0, -1, -1}, .feature = Feature::Sphere};
    stretchToScp(out, hip);
    return out;
  }
  void reset() noexcept override {}
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return kWaterProbe_A; }
  MemoryUsage memoryUsage() const noexcept override { return {}; }

 private:
  Vec3 scp_;
};

// Two spheres at the ends of a bar, a rigid body in the hand: each kept out by a tracker of its own, each with its
// spring.
class RigidPair final : public Interaction {
 public:
  static constexpr double kArm_A = 1.5;

  RigidPair(std::shared_ptr<const BallScene> scene, double probe_A)
      : ends_{methods().front().make(scene, probe_A), methods().front().make(scene, probe_A)} {}
  Response respond(const PoseA& pose) noexcept override {
    Response out;
    out.contact.scp = pose.place;
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec3 arm = armOf(k, pose.orientation);
      const Contact c = ends_[k]->step({pose.place.A + arm});
      scps_[k] = c.scp.A;
      touching_[k] = c.touching();
      if (c.fault != moltact::Fault::None) out.contact.fault = c.fault;
      out.contact.feature = std::max(out.contact.feature, c.feature);
      out.contact.displacement_A += c.displacement_A;
      out.contact.energy_A2 += c.energy_A2;
      out.torque_A2 += glm::cross(arm, c.displacement_A);
    }
    if (out.contact.fault != moltact::Fault::None) return {.contact = {.scp = pose.place, .fault = out.contact.fault}};
    out.contact.scp.A += out.contact.displacement_A;
    return out;
  }
  /// What the springs hold with the SCPs where they are, over the stiffness.
  double potential_A2(PointA place, const Quat& orientation) const {
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec3 d = scps_[k] - place.A - armOf(k, orientation);
      if (touching_[k]) sum += 0.5 * glm::dot(d, d);
    }
    return sum;
  }
  bool setMotion(const SphereMotion* motion) noexcept override {
    return ends_[0]->setMotion(motion) && ends_[1]->setMotion(motion);
  }
  void advanceTo(double fraction) noexcept override { ends_[0]->advanceTo(fraction), ends_[1]->advanceTo(fraction); }
  void reset() noexcept override { ends_[0]->reset(), ends_[1]->reset(); }
  void setProbe(double probe_A) noexcept override { ends_[0]->setProbe(probe_A), ends_[1]->setProbe(probe_A); }
  double probe_A() const noexcept override { return ends_[0]->probe_A(); }
  double parallelSprings() const noexcept override { return 2.0; }
  bool hasOrientation() const noexcept override { return true; }
  MemoryUsage memoryUsage() const noexcept override { return {}; }

 private:
  static Vec3 armOf(std::size_t k, const Quat& orientation) { return orientation * Vec3(k ? -kArm_A : kArm_A, 0, 0); }
  std::array<std::unique_ptr<Tracker>, 2> ends_;
  std::array<Vec3, 2> scps_{};
  std::array<bool, 2> touching_{};
};

class Run {
 public:
  explicit Run(std::uint64_t seed)
      : random_(seed),
        seed_(seed),
        device_(deviceOf()),
        hand_(handOf()),
        model_(device_, hand_, {{40, 0, 0}}),
        step_(infoOf()) {
    // As a lesson has it, the stiffest that the panel offers, and the stiffest that a setting may ask.
    const double which = random_.uniform(0, 3);
    settings_.stiffness_N_per_mm = which < 1 ? 0.5 : which < 2 ? 2.0 : 5.0;
    newScene();
  }

  FaultRunResult go(int faults) {
    for (int k = 0; k < faults && out_.broken.empty(); ++k) {
      approach();
      const auto fault = static_cast<Fault>(int(random_.uniform(0, double(Fault::Count)) * 0.999999));
      doing_ = kNames[std::size_t(fault)];
      ++out_.faults;
      suffer(fault);
      restAfter();
    }
    return out_;
  }

 private:
  DeviceParameters deviceOf() {
    DeviceParameters device;
    device.substeps = 4;
    if (seed_ % 3 == 1) {  // an open device: slippery, fine, slow to answer
      device.friction_N = 0.03;
      device.damping_N_s_per_m = 0.05;
      device.resolution_mm = 0.02;
      device.delay_ticks = 2;
    }
    return device;
  }
  HandParameters handOf() {
    if (random_.uniform(0, 1) < 0.3) return {100, 2};
    return {random_.uniform(150, 500), random_.uniform(3, 10)};
  }
  DeviceInfo infoOf() {
    DeviceInfo info;
    info.name = "model";
    info.continuous_force_N = 0.88;
    info.gives_force = true;
    info.damping_N_s_per_m = device_.damping_N_s_per_m;
    info.friction_N = device_.friction_N;
    info.resolution_mm = device_.resolution_mm;
    info.delay_s = 0.001 * device_.delay_ticks;
    return info;
  }

  // The spheres go to these places within so many ticks.
  void moveSpheres(const std::vector<Ball>& to, int ticks) {
    auto frame =
        frames_.empty() ? SphereMotion::make(scene_.balls, to, ticks) : SphereMotion::after(*frames_.back(), to, ticks);
    frames_.push_back(*std::move(frame));
    for (int k = 1; k <= ticks; ++k) {
      fraction_ = double(k) / ticks;
      if (follows_) scene_.balls = frames_.back()->at(fraction_);
      tick({});
    }
  }

  void newScene() {
    scene_ = scenes::cluster(int(random_.uniform(2, 30)), seed_ + out_.faults);
    newTracker();
  }
  void newTracker() {
    const auto all = methods();
    const Method& method =
        random_.uniform(0, 1) < 0.6 ? all.front() : all[std::size_t(random_.uniform(0, double(all.size())) * 0.999)];
    pair_ = nullptr;
    frames_.clear();
    follows_ = true;
    if (seed_ % 5 == 4) {  // a rigid body, not a point
      auto pair = std::make_unique<RigidPair>(makeScene(scene_.balls), settings_.probe_A);
      pair_ = pair.get();
      tracker_ = std::move(pair);
      method_ = "rigid pair";
      return;
    }
    tracker_ = method.make(makeScene(scene_.balls), settings_.probe_A);
    method_ = method.name;
    follows_ = method.follows_motion;
  }

  // The hand goes from outside to some place under the surface, and slides a little.
  void approach() {
    const Vec3 out = random_.direction(), side = random_.direction();
    const double depth_A = random_.uniform(0, 2.0);
    double far_A = 1;
    for (const Ball& ball : scene_.balls) {
      const double along = glm::dot(ball.centre_A, out),
                   aside2 = glm::dot(ball.centre_A, ball.centre_A) - along * along;
      const double radius = ball.radius_A + settings_.probe_A;
      if (aside2 < radius * radius) far_A = std::max(far_A, along + std::sqrt(radius * radius - aside2));
    }
    if (pair_) far_A += RigidPair::kArm_A;
    const Vec3 away = settings_.workspace.toDevice({out * (far_A + 1.0)}).mm;
    lead(away, 150);
    lead(settings_.workspace.toDevice({out * (far_A - depth_A)}).mm, 250);
    lead(settings_.workspace.toDevice({out * (far_A - depth_A) + side * random_.uniform(0, 1.0)}).mm, 150);
    for (int k = 0; k < 450; ++k) tick({});
  }
  void lead(const Vec3& to_mm, int ticks) {
    const Vec3 from = target_mm_;
    for (int k = 1; k <= ticks; ++k) {
      target_mm_ = from + (to_mm - from) * (double(k) / ticks);
      orientation_ = glm::normalize(glm::angleAxis(0.002, axis_) * orientation_);
      tick({});
    }
  }

  struct How {
    TickTime time = {};
    std::optional<Vec3> place_mm = {};     // instead of the device's
    std::optional<Quat> orientation = {};  // likewise
    bool fresh = true, connected = true;
    bool moves = true;     // false: no time passes for the device
    bool to_model = true;  // false: the force is for another device
    bool leaps = false;    // the place is far from the one before

    // Something is wrong that no force may outlast, not even for a tick.
    bool wrong() const {
      const bool on_time = time.dt_s >= 0.0 && time.dt_s <= 0.020;
      return !on_time || !connected || leaps || (place_mm && !finite(*place_mm)) ||
             (orientation && !rotates(*orientation));
    }
  };

  // One tick of the loop, judged; then one millisecond of the world.
  void tick(const How& how) {
    const DevicePose pose{.position = how.place_mm ? PointMm{*how.place_mm} : model_.sensed(),
                          .fresh = how.fresh,
                          .connected = how.connected,
                          .orientation = how.orientation.value_or(orientation_)};
    sensed_ = pose.position;
    const MotionPhase phase{frames_.empty() ? nullptr : frames_.back().get(), fraction_};
    const ServoSample sample = step_.tick(settings_, bad_ ? bad_.get() : tracker_.get(), pose, how.time, phase);
    ++out_.ticks;
    out_.contact += sample.contact.touching();
    out_.turned += !bad_ && pair_ && sample.contact.touching();
    cuts_ += sample.limits.has(Limit::EnergyCut);
    judge(sample, how);
    command_ = sample.force;
    const double A_per_mm = settings_.workspace.A_per_mm;
    const double told_mm = glm::length(sample.contact.displacement_A) / A_per_mm;
    // Without the sensor's steps.
    const PointA place = settings_.workspace.toMolecule(model_.position());
    stretch_mm_ = sample.contact.touching() ? glm::distance(sample.contact.scp.A, place.A) / A_per_mm : 0.0;
    potential_mm2_ = pair_ && sample.contact.touching()
                         ? pair_->potential_A2(place, pose.orientation) / (A_per_mm * A_per_mm)
                     : method_ == "penalty" && sample.contact.touching() ? pushes_A2(place) / (A_per_mm * A_per_mm)
                                                                         : 0.5 * stretch_mm_ * stretch_mm_;
    const bool cut = sample.limits.has(Limit::Clamp) || sample.limits.has(Limit::Heat);
    felt_N_per_mm_ = told_mm > 0.0 && !cut ? glm::length(command_.N) / told_mm : -1.0;
    if (!cut) bent_mm_ = stretch_mm_;
    if (how.moves) model_.tick(how.connected && how.to_model ? command_ : ForceN{}, {target_mm_});
  }
  // Of the penalty method's springs, one a ball that the place is in.
  double pushes_A2(PointA place) const {
    double sum = 0;
    for (const Ball& ball : scene_.balls) {
      const double deep = ball.radius_A + tracker_->probe_A() - glm::distance(place.A, ball.centre_A);
      if (deep > 0.0) sum += 0.5 * deep * deep;
    }
    return sum;
  }
  void idle(int ms) {
    for (int k = 0; k < ms; ++k) model_.tick(command_, {target_mm_});
  }

  void judge(const ServoSample& sample, const How& how) {
    const double size = glm::length(sample.force.N);
    out_.greatest_N = std::max(out_.greatest_N, size);
    if (const char* promise = judge_.judge(
            sample.force.N, {.fresh = how.fresh,
                             .at_once = bad_ != nullptr || unsound_settings_ || sample.limits.has(Limit::EnergyCut),
                             .stopped = settings_.panic || how.wrong()}))
      broken(promise, size);
  }
  void broken(const char* promise, double size_N = 0) {
    if (!out_.broken.empty()) return;
    char text[320];
    std::snprintf(text, sizeof text, "seed %llu, tick %llu, %s %.0f ticks ago from %.3f N, method %.*s: %s (%.3f N)",
                  static_cast<unsigned long long>(seed_), static_cast<unsigned long long>(out_.ticks), doing_,
                  judge_.sinceFault_ticks(), judge_.beforeFault_N(), int(method_.size()), method_.data(), promise,
                  size_N);
    out_.broken = text;
  }

  // From the next tick on no more than a soft start is allowed.
  void expectSoft() { judge_.expectSoft(); }
  void lasting(int ticks, const How& how) {
    expectSoft();
    judge_.lasting(true);
    for (int k = 0; k < ticks; ++k) tick(how);
    judge_.lasting(false);
    expectSoft();
  }

  void suffer(Fault fault) {
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    const int some = 1 + int(random_.uniform(0, 60));
    switch (fault) {
      case Fault::Late:
        for (int k = 0; k < some; ++k) {
          const int late = int(random_.uniform(0, 15));
          idle(late);
          tick({.time = {.dt_s = 0.001 * (late + 1), .delay_s = random_.uniform(0, 0.003)}});
        }
        break;
      case Fault::Stall:
      case Fault::LongStall: {
        const int ms = int(fault == Fault::Stall ? random_.uniform(21, 99) : random_.uniform(101, 3000));
        idle(ms);
        expectSoft();
        tick({.time = {.dt_s = 0.001 * ms}});
        break;
      }
      case Fault::Doubled:
        for (int k = 0; k < some; ++k) {
          tick({.time = {.dt_s = 0}, .moves = false});
          tick({});
        }
        break;
      case Fault::ClockBack:
        expectSoft();
        tick({.time = {.dt_s = -random_.uniform(1e-6, 1e6)}});
        break;
      case Fault::ClockAhead:
        expectSoft();
        tick({.time = {.dt_s = random_.uniform(0.021, 1e9)}});
        break;
      case Fault::ClockNaN:
        expectSoft();
        tick({.time = {.dt_s = some % 2 ? nan : inf, .delay_s = nan}});
        break;
      case Fault::Teleport:
        expectSoft();
        for (int k = 0; k < some % 5 + 1; ++k)
          tick({.place_mm = model_.sensed().mm + random_.direction() * random_.uniform(8, 200), .leaps = k == 0});
        expectSoft();
        break;
      case Fault::PlaceNaN:
        lasting(some * 4, {.place_mm = some % 3 ? Vec3(nan, 0, 0) : Vec3(0, inf, -inf)});
        break;
      case Fault::Stale: {
        const Vec3 frozen = model_.sensed().mm;
        for (int k = 0; k < some * 5; ++k) tick({.place_mm = frozen, .fresh = false});
        break;
      }
      case Fault::Unplug:
        lasting(some * 20, {.connected = false});
        break;
      case Fault::RendererStalls:  // nobody writes settings or leads the hand for 5 s
        for (int k = 0; k < 5000; ++k) tick({});
        break;
      case Fault::SceneSwap:
        expectSoft();
        newScene();
        ++settings_.discontinuities;
        tick({});
        break;
      case Fault::MethodSwap:
        expectSoft();
        newTracker();
        tick({});
        break;
      case Fault::BadSettings: {
        const ServoSettings kept = settings_;
        const std::array<double, 6> bad{nan, inf, -inf, -1.0, 1e300, 0.0};
        const auto pick = [&] { return bad[std::size_t(random_.uniform(0, 5.999))]; };
        settings_.stiffness_N_per_mm = pick();
        settings_.max_force_N = pick();
        settings_.probe_A = pick();
        if (some % 3 == 0) settings_.workspace.A_per_mm = some % 2 ? nan : 0.0;
        unsound_settings_ = true;
        for (int k = 0; k < some * 3; ++k) tick({});
        unsound_settings_ = false;
        settings_ = kept;
        break;
      }
      case Fault::ProbeJump:
        settings_.probe_A = random_.uniform(0.5, 2.5);
        for (int k = 0; k < some * 3; ++k) tick({});
        settings_.probe_A = kWaterProbe_A;
        break;
      case Fault::Panic:
        settings_.panic = true;
        for (int k = 0; k < some * 10; ++k) tick({});
        settings_.panic = false;
        expectSoft();
        break;
      case Fault::ForceOff:
        settings_.force_on = false;
        lasting(some * 10, {});
        settings_.force_on = true;
        break;
      case Fault::BadTracker:
        expectSoft();
        bad_ = std::make_unique<BadTracker>(some % 3 == 0   ? Vec3(nan, nan, nan)
                                            : some % 3 == 1 ? Vec3(1e300, 0, 0)
                                                            : Vec3(0, -inf, 0));
        for (int k = 0; k < some * 3; ++k) tick({});
        bad_.reset();
        expectSoft();
        tick({});
        break;
      case Fault::Rescaled: {  // a part is magnified, or no longer
        expectSoft();
        const Workspace kept = settings_.workspace;
        settings_.workspace = rescaled(kept, kept.A_per_mm * (some % 2 ? 0.4 : 1.5), sensed_, kept.toMolecule(sensed_));
        for (int k = 0; k < some * 3; ++k) tick({});
        expectSoft();
        settings_.workspace = rescaled(kept, kept.A_per_mm, sensed_, settings_.workspace.toMolecule(sensed_));
        for (int k = 0; k < some * 3; ++k) tick({});
        break;
      }
      case Fault::FallBack: {  // the stylus goes, a mouse presses as deep as it likes, the stylus comes back
        otherDevice(DeviceInfo{});
        const Vec3 deep = sensed_.mm * random_.uniform(0.2, 1.0);
        for (int k = 0; k < some * 20; ++k)
          tick({.place_mm = deep + (sensed_.mm - deep) * std::exp(-0.01 * k), .to_model = false});
        otherDevice(infoOf());
        for (int k = 0; k < some * 3; ++k) tick({});
        break;
      }
      case Fault::WeakDevice: {  // a weaker one is plugged in, and the first one again
        DeviceInfo weak = infoOf();
        weak.max_force_N = 1.0;
        otherDevice(weak);
        for (int k = 0; k < some * 10; ++k) tick({});
        otherDevice(infoOf());
        for (int k = 0; k < some * 3; ++k) tick({});
        break;
      }
      case Fault::PanicUnplugged:  // stopped, unplugged, allowed again while it is away
        settings_.panic = true;
        for (int k = 0; k < some; ++k) tick({});
        expectSoft();
        for (int k = 0; k < some; ++k) tick({.connected = false});
        settings_.panic = false;
        lasting(some * 5, {.connected = false});
        break;
      case Fault::LessonSwap:  // another molecule, spring, probe and scale in one tick
        expectSoft();
        settings_.probe_A = random_.uniform(0.5, 2.5);
        settings_.stiffness_N_per_mm = random_.uniform(0.1, 2.0);
        settings_.workspace.A_per_mm = random_.uniform(0.1, 0.4);
        newScene();
        ++settings_.discontinuities;
        for (int k = 0; k < some * 3; ++k) tick({});
        break;
      case Fault::OrientationLeap:
        expectSoft();
        tick({.orientation = glm::angleAxis(1.5, random_.direction()) * orientation_, .leaps = true});
        expectSoft();
        tick({.leaps = true});
        expectSoft();
        break;
      case Fault::OrientationNaN:
        lasting(some * 4, {.orientation = some % 2 ? Quat(nan, 0, 0, 0) : Quat(3, 0, 0, 0)});
        break;
      case Fault::AtomLeaps: {  // the ball nearest to the hand, by 3 A at it or across it, at once or within a frame
        const Vec3 hip = settings_.workspace.toMolecule(sensed_).A;
        std::vector<Ball> to = scene_.balls;
        const auto near = std::min_element(to.begin(), to.end(), [&](const Ball& a, const Ball& b) {
          return glm::distance(a.centre_A, hip) - a.radius_A < glm::distance(b.centre_A, hip) - b.radius_A;
        });
        const Vec3 at_it = hip - near->centre_A;
        near->centre_A += 3.0 * (some % 2 && glm::length(at_it) > 0.1 ? glm::normalize(at_it) : random_.direction());
        moveSpheres(to, some % 3 == 0 ? 1 : 33);
        break;
      }
      case Fault::ProteinShakes: {  // every ball by up to 1 A and a tenth of its radius, frame after frame
        const std::vector<Ball> rest = scene_.balls;
        for (int k = 0; k < 1 + some / 3; ++k) {
          std::vector<Ball> to = rest;
          for (Ball& ball : to) {
            ball.centre_A += random_.direction() * random_.uniform(0, 1.0);
            ball.radius_A *= random_.uniform(0.9, 1.1);
          }
          moveSpheres(to, 33);
        }
        break;
      }
      case Fault::Count:
        break;
    }
  }
  // Nothing has been given to it yet.
  void otherDevice(const DeviceInfo& info) {
    step_.setDevice(info);
    judge_.otherDevice(info.max_force_N);
    command_ = ForceN{};
  }
  // The hand is held still: what moves the device comes to rest, or slides off on energy that was there. A stiffness
  // that comes back after late ticks stores more in the same stretch, and may.
  void restAfter() {
    for (int k = 0; k < 600; ++k) tick({});
    cuts_ = 0;
    std::array<double, 2> fastest{}, energy{};
    double softest = 1e9, stiffest = 0, potential_mm2 = 0, least_J = 1e9, risen_J = 0;
    bool known = true;
    for (std::size_t w = 0; w < 2; ++w)
      for (int k = 0; k < 200; ++k) {
        tick({});
        known = known && felt_N_per_mm_ >= 0.0;
        softest = std::min(softest, felt_N_per_mm_);
        stiffest = std::max(stiffest, felt_N_per_mm_);
        potential_mm2 = std::max(potential_mm2, potential_mm2_);
        fastest[w] = std::max(fastest[w], glm::length(model_.velocity_m_per_s()));
        const double now_J = energy_J();
        energy[w] = std::max(energy[w], now_J);
        least_J = std::min(least_J, now_J);
        risen_J = std::max(risen_J, now_J - least_J);
      }
    const double stiffened_J = known ? 1e-3 * potential_mm2 * std::max(0.0, stiffest - softest) : 0.0;
    const bool faster = fastest[1] > std::max(fastest[0], kRest_m_per_s),
               grown = energy[1] > energy[0] + (known ? kRounding_J : kMade_J) + stiffened_J;
    // Of a body that is pressed beyond the greatest force it is not known what its springs store together.
    if (pair_ && !known) {
      out_.body_cuts += cuts_ > 0;
      return judge_.expectAny();
    }
    out_.cuts += cuts_;
    // What slides off a ball sets out on energy that was there, or goes on while its energy falls by more than the
    // speed is; what buzzes does neither.
    const bool slides = (faster && !grown) || energy[0] - energy[1] > 0.5 * device_.mass_kg * fastest[1] * fastest[1];
    if (!slides) out_.restless_m_per_s = std::max(out_.restless_m_per_s, fastest[1]);
    if (faster && grown) broken("energy grows while the hand is still", fastest[1]);
    // Tick by tick, where the spring's force is not cut and what it stores so is known.
    if (known && risen_J > stiffened_J + kMade_J) broken("energy is made while the hand is still", 1e3 * risen_J);
    judge_.expectAny();
  }

  // Of the device's motion, of the hand that holds it, and of the surface's spring.
  double energy_J() const {
    const double v = glm::length(model_.velocity_m_per_s()),
                 d_m = 1e-3 * glm::distance(model_.position().mm, target_mm_);
    return 0.5 * device_.mass_kg * v * v + 0.5 * hand_.stiffness_N_per_m * d_m * d_m + stored_J();
  }
  // What a spring holds; one whose force is cut gives it back all the way.
  double stored_J() const {
    const double force_N = glm::length(command_.N);
    if (felt_N_per_mm_ >= 0.0) return 1e-3 * felt_N_per_mm_ * potential_mm2_;
    return 1e-3 * force_N * (stretch_mm_ - 0.5 * bent_mm_);
  }

  scenes::Random random_;
  std::uint64_t seed_;
  DeviceParameters device_;
  HandParameters hand_;
  DeviceModel model_;
  ServoStep step_;
  ServoSettings settings_;
  scenes::Scene scene_;
  std::unique_ptr<Interaction> tracker_, bad_;
  std::vector<std::unique_ptr<const SphereMotion>> frames_;  // of tracker_; the last is in force
  double fraction_ = 1.0;                                    // of it
  bool follows_ = true;                                      // tracker_ goes with the spheres
  RigidPair* pair_ = nullptr;                                // of tracker_, where it is one
  Quat orientation_ = kNoRotation;
  Vec3 axis_ = glm::normalize(Vec3(0.3, 0.8, 0.5));
  std::string_view method_;
  const char* doing_ = "none";
  bool unsound_settings_ = false;
  Vec3 target_mm_{40, 0, 0};
  ForceN command_;
  PointMm sensed_;
  double stretch_mm_ = 0, bent_mm_ = 0;  // the latter where the force began to be cut
  double potential_mm2_ = 0;             // what is stored, over the stiffness
  double felt_N_per_mm_ = -1;            // negative: none, or the force is cut
  ForceMonitor judge_{kPeak_N};
  std::uint64_t cuts_ = 0;
  FaultRunResult out_;
};

}  // namespace

FaultRunResult runFaults(std::uint64_t seed, int faults) { return Run(seed).go(faults); }

}  // namespace moltact::test
