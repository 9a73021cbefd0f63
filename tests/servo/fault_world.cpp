#include "tests/servo/fault_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "tests/haptics/walk.h"

namespace moltact::test {
namespace {

// The promises, as docs/safety.md makes them.
constexpr double kPeak_N = 3.3;
constexpr double kRest_m_per_s = 0.03;  // half a step of the sensor a tick is what its rounding makes
constexpr double kRounding_J = 1e-5;    // a step of the sensor at 0.5 N
// What a tick may show above the least of the ticks before it: a hundredth of what 3.3 N store at 0.5 N/mm.
constexpr double kMade_J = 1e-4;

}  // namespace

FaultWorld::FaultWorld(std::uint64_t seed)
    : random(seed),
      seed_(seed),
      device_(deviceOf(seed)),
      hand_(handOf(random)),
      model_(device_, hand_, {{40, 0, 0}}),
      step_(info()),
      judge_(kPeak_N) {
  // As a lesson has it, the stiffest that the panel offers, and the stiffest that a setting may ask.
  const double which = random.uniform(0, 3);
  settings.stiffness_N_per_mm = which < 1 ? 0.5 : which < 2 ? 2.0 : 5.0;
  newScene();
}

DeviceParameters FaultWorld::deviceOf(std::uint64_t seed) {
  DeviceParameters device;
  device.substeps = 4;
  if (seed % 3 == 1) {  // an open device: slippery, fine, slow to answer
    device.friction_N = 0.03;
    device.damping_N_s_per_m = 0.05;
    device.resolution_mm = 0.02;
    device.delay_ticks = 2;
  }
  return device;
}

HandParameters FaultWorld::handOf(scenes::Random& random) {
  if (random.uniform(0, 1) < 0.3) return {100, 2};
  return {random.uniform(150, 500), random.uniform(3, 10)};
}

DeviceInfo FaultWorld::info() const {
  DeviceInfo out{phantomOmniFigures(), "model"};
  out.gives_force = true;
  out.damping_N_s_per_m = device_.damping_N_s_per_m;
  out.friction_N = device_.friction_N;
  out.resolution_mm = device_.resolution_mm;
  out.delay_s = 0.001 * device_.delay_ticks;
  return out;
}

void FaultWorld::moveSpheres(const std::vector<Sphere>& to, int in_ticks) {
  auto frame = frames_.empty() ? SphereMotion::make(scene_.spheres, to, in_ticks)
                               : SphereMotion::after(*frames_.back(), to, in_ticks);
  frames_.push_back(*std::move(frame));
  for (int k = 1; k <= in_ticks; ++k) {
    fraction_ = double(k) / in_ticks;
    if (follows_) scene_.spheres = frames_.back()->at(fraction_);
    tick();
  }
}

void FaultWorld::newScene() {
  scene_ = scenes::cluster(int(random.uniform(2, 30)), seed_ + out_.faults);
  newTracker();
}

void FaultWorld::newTracker() {
  const auto all = methods();
  const Method& method =
      random.uniform(0, 1) < 0.6 ? all.front() : all[std::size_t(random.uniform(0, double(all.size())) * 0.999)];
  body_ = nullptr;
  frames_.clear();
  follows_ = true;
  summed_ = false;
  exact_ = seed_ % 5 == 3;
  if (exact_ || seed_ % 5 == 4) {  // a rigid body, not a point: the program's default, or the springs of its atoms
    std::vector<Sphere> atoms;
    for (int k = int(random.uniform(2, 7)); k > 0; --k)
      atoms.push_back({random.direction() * WatchedBody::kArm_A, settings.probe_A + kBodyOverlap_A});
    std::unique_ptr<WatchedBody> body;
    if (exact_)
      body = std::make_unique<WatchedExactBody>(makeScene(scene_.spheres), atoms);
    else
      body = std::make_unique<WatchedSprings>(makeScene(scene_.spheres), atoms);
    body_ = body.get();
    tracker_ = std::move(body);
    method_ = exact_ ? "exact body" : "springs";
    return;
  }
  tracker_ = method.make(makeScene(scene_.spheres), settings.probe_A);
  method_ = method.name;
  follows_ = method.follows_motion;
  summed_ = method.summed;
}

void FaultWorld::approach() {
  const Vec3 out = random.direction(), side = random.direction();
  const double depth_A = random.uniform(0, 2.0);
  double far_A = 1;
  for (const Sphere& sphere : scene_.spheres) {
    const double along = glm::dot(sphere.centre_A, out),
                 aside2 = glm::dot(sphere.centre_A, sphere.centre_A) - along * along;
    const double radius = sphere.radius_A + settings.probe_A;
    if (aside2 < radius * radius) far_A = std::max(far_A, along + std::sqrt(radius * radius - aside2));
  }
  if (body_) far_A += 2.0 * WatchedBody::kArm_A;
  const Vec3 away = settings.workspace.toDevice({out * (far_A + 1.0)}).mm;
  lead(away, 150);
  lead(settings.workspace.toDevice({out * (far_A - depth_A)}).mm, 250);
  lead(settings.workspace.toDevice({out * (far_A - depth_A) + side * random.uniform(0, 1.0)}).mm, 150);
  ticks(450);
}

void FaultWorld::lead(const Vec3& to_mm, int in_ticks) {
  const Vec3 from = target_mm_;
  for (int k = 1; k <= in_ticks; ++k) {
    target_mm_ = from + (to_mm - from) * (double(k) / in_ticks);
    orientation_ = glm::normalize(glm::angleAxis(0.002, axis_) * orientation_);
    tick();
  }
}

bool TickInput::wrong() const {
  const bool on_time = time.dt_s >= 0.0 && time.dt_s <= 0.020;
  return !on_time || !connected || leaps || (place_mm && !finite(*place_mm)) || (orientation && !rotates(*orientation));
}

void FaultWorld::tick(const TickInput& how) {
  const DevicePose pose{.position = how.place_mm ? PointMm{*how.place_mm} : model_.sensed(),
                        .fresh = how.fresh,
                        .connected = how.connected,
                        .orientation = how.orientation.value_or(orientation_)};
  sensed_ = pose.position;
  const MotionPhase phase{frames_.empty() ? nullptr : frames_.back().get(), fraction_};
  const ServoSample sample = step_.tick(settings, bad ? bad.get() : tracker_.get(), pose, how.time, phase);
  ++out_.ticks;
  out_.contact += sample.contact.touching();
  out_.turned += !bad && body_ && sample.contact.touching();
  out_.exact += !bad && exact_ && sample.contact.touching();
  if (!bad && body_ && sample.has_interaction) {
    const double overlap_A = body_->overlap_A(scene_.spheres);
    if (overlap_A > 1e-9) broken("the body overlaps the molecule", overlap_A);
  }
  cuts_ += sample.limits.has(Limit::EnergyCut);
  judge(sample, how);
  command_ = sample.force;
  const double A_per_mm = settings.workspace.A_per_mm;
  const double reported_mm = glm::length(sample.contact.displacement_A) / A_per_mm;
  // Without the sensor's steps.
  const PointA place = settings.workspace.toMolecule(model_.position());
  stretch_mm_ = sample.contact.touching() ? glm::distance(sample.contact.scp.A, place.A) / A_per_mm : 0.0;
  potential_mm2_ = body_ && sample.contact.touching()
                       ? body_->potential_A2(place, pose.orientation) / (A_per_mm * A_per_mm)
                   : summed_ && sample.contact.touching() ? pushes_A2(place) / (A_per_mm * A_per_mm)
                                                          : 0.5 * stretch_mm_ * stretch_mm_;
  const bool cut = sample.limits.has(Limit::Clamp) || sample.limits.has(Limit::Heat);
  felt_N_per_mm_ = reported_mm > 0.0 && !cut ? glm::length(command_.N) / reported_mm : -1.0;
  if (!cut) bent_mm_ = stretch_mm_;
  if (how.moves) model_.tick(how.connected && how.to_model ? command_ : ForceN{}, {target_mm_});
}

// Of the penalty method's springs, one a sphere that the place is in.
double FaultWorld::pushes_A2(PointA place) const {
  double sum = 0;
  for (const Sphere& sphere : scene_.spheres) {
    const double deep = sphere.radius_A + tracker_->probe_A() - glm::distance(place.A, sphere.centre_A);
    if (deep > 0.0) sum += 0.5 * deep * deep;
  }
  return sum;
}

void FaultWorld::idle(int ms) {
  for (int k = 0; k < ms; ++k) model_.tick(command_, {target_mm_});
}

void FaultWorld::judge(const ServoSample& sample, const TickInput& how) {
  const double size = glm::length(sample.force.N);
  out_.peak_N = std::max(out_.peak_N, size);
  if (const char* promise = judge_.judge(
          sample.force.N, {.fresh = how.fresh,
                           .at_once = bad != nullptr || unsound_settings || sample.limits.has(Limit::EnergyCut),
                           .stopped = settings.panic || how.wrong()}))
    broken(promise, size);
}

void FaultWorld::broken(const char* promise, double size_N) {
  if (!out_.broken.empty()) return;
  char text[320];
  std::snprintf(text, sizeof text, "seed %llu, tick %llu, %s %.0f ticks ago from %.3f N, method %.*s: %s (%.3f N)",
                static_cast<unsigned long long>(seed_), static_cast<unsigned long long>(out_.ticks), fault_,
                judge_.sinceFault_ticks(), judge_.beforeFault_N(), int(method_.size()), method_.data(), promise,
                size_N);
  out_.broken = text;
}

void FaultWorld::lasting(int count, const TickInput& how) {
  expectSoft();
  judge_.lasting(true);
  ticks(count, how);
  judge_.lasting(false);
  expectSoft();
}

void FaultWorld::begin(const char* fault) {
  fault_ = fault;
  ++out_.faults;
}

void FaultWorld::otherDevice(const DeviceInfo& info) {
  step_.setDevice(info);
  judge_.otherDevice(info.max_force_N);
  command_ = ForceN{};
}

// A stiffness that comes back after late ticks stores more in the same stretch, and may.
void FaultWorld::restAfter() {
  ticks(600);
  cuts_ = 0;
  std::array<double, 2> fastest{}, energy{};
  double softest = 1e9, stiffest = 0, potential_mm2 = 0, least_J = 1e9, risen_J = 0;
  bool known = true;
  for (std::size_t w = 0; w < 2; ++w)
    for (int k = 0; k < 200; ++k) {
      tick();
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
  if (body_ && !known) {
    out_.body_cuts += cuts_ > 0;
    return judge_.expectAny();
  }
  out_.cuts += cuts_;
  // What slides off a sphere sets out on energy that was there, or continues while its energy falls by more than the
  // speed is; what buzzes does neither.
  const bool slides = (faster && !grown) || energy[0] - energy[1] > 0.5 * device_.mass_kg * fastest[1] * fastest[1];
  if (!slides) out_.restless_m_per_s = std::max(out_.restless_m_per_s, fastest[1]);
  if (faster && grown) broken("energy grows while the hand is still", fastest[1]);
  // Tick by tick, where the spring's force is not cut and what it stores so is known.
  if (known && risen_J > stiffened_J + kMade_J) broken("energy is made while the hand is still", 1e3 * risen_J);
  judge_.expectAny();
}

// Of the device's motion, of the hand that holds it, and of the surface's spring.
double FaultWorld::energy_J() const {
  const double v = glm::length(model_.velocity_m_per_s()), d_m = 1e-3 * glm::distance(model_.position().mm, target_mm_);
  return 0.5 * device_.mass_kg * v * v + 0.5 * hand_.stiffness_N_per_m * d_m * d_m + stored_J();
}

// What a spring holds; one whose force is cut gives it back all the way.
double FaultWorld::stored_J() const {
  const double force_N = glm::length(command_.N);
  if (felt_N_per_mm_ >= 0.0) return 1e-3 * felt_N_per_mm_ * potential_mm2_;
  return 1e-3 * force_N * (stretch_mm_ - 0.5 * bent_mm_);
}

}  // namespace moltact::test
