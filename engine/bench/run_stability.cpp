// The measurement part of stability.h; its tables are in stability_tables.cpp.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>

#include "engine/bench/many_threads.h"
#include "engine/bench/oracle.h"
#include "engine/bench/path_energy.h"
#include "engine/bench/right_answer.h"
#include "engine/bench/stability.h"
#include "engine/haptics/friction.h"
#include "engine/haptics/pull_spring.h"
#include "engine/haptics/sphere_motion.h"

namespace moltact::bench {
namespace {

// Peak to peak about the regression line through the positions: slow settling against friction is not jitter.
double shaking_mm(const std::vector<Vec3>& places) {
  if (places.size() < 3) return 0;
  const double n = double(places.size()), mid = (n - 1) / 2;
  Vec3 mean(0.0), slope(0.0);
  for (const Vec3& p : places) mean += p / n;
  for (std::size_t k = 0; k < places.size(); ++k)
    slope += (places[k] - mean) * ((double(k) - mid) * 12 / (n * (n * n - 1)));
  Vec3 low(1e300), high(-1e300);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Vec3 off = places[k] - mean - slope * (double(k) - mid);
    low = glm::min(low, off), high = glm::max(high, off);
  }
  return glm::length(high - low);
}

// Collects the results of each tick.
class Judge {
 public:
  Judge(const StabilityScene& scene, const Method& method, const LoopSettings& loop, const StabilityLimits& limits)
      : loop_(loop), limits_(limits), check_jump_(scene.jump) {
    out_.scene = scene.name;
    out_.method = &method;
    out_.changing = scene.changing();
  }

  void tick(const scenes::Scene& now, const Vec3& hip, const Contact& c, const RightAnswer::Answer& right) {
    ++out_.ticks;
    if (!finite(c.scp.A)) {
      ++out_.broken;
      return;
    }
    if (c.touching()) {
      const double deep = oracle::deepest(now.spheres, now.probe_A, c.scp.A);
      out_.penetration_A = std::max(out_.penetration_A, deep);
      out_.sunk += deep > limits_.place_A;
    }
    if (right.known && (right.touching || c.touching())) {
      const Vec3 place = c.touching() ? c.scp.A : hip, right_place = right.touching ? right.scp_A : hip;
      const double held_away = glm::distance(right_place, hip);
      ++out_.contact_ticks;
      out_.off += glm::distance(place, right_place) > limits_.place_A;
      const bool inside = !c.touching() && oracle::deepest(now.spheres, now.probe_A, hip) > 0;
      const bool behind = right.touching && !c.touching() && !inside && held_away > kBehind_A;
      out_.tunnelled += behind && !behind_;
      behind_ = behind;
      out_.lost += right.touching && !c.touching() && inside && held_away > limits_.place_A;
      out_.stuck += !right.touching && glm::distance(place, hip) > limits_.place_A;
    } else {
      behind_ = false;
    }
    force_.push_back(springForce(loop_, c, loop_.device.max_force_N).N);
    Contact ideal;
    ideal.displacement_A = right.displacement_A;
    right_force_.push_back(springForce(loop_, ideal, loop_.device.max_force_N).N);
    path_.push_back(hip);
  }

  // The tracker is reset: earlier ticks must not count.
  void cut() { cuts_.push_back(force_.size()); }

  const scenes::Path& path() const { return path_; }

  StabilityResult result(const std::vector<Vec3>& held_mm) {
    const auto step = [](const std::vector<Vec3>& f, std::size_t k) { return glm::distance(f[k], f[k - 1]); };
    for (std::size_t k = 1; k < force_.size(); ++k) {
      out_.step_N = std::max(out_.step_N, step(force_, k));
      if (!check_jump_ || std::find(cuts_.begin(), cuts_.end(), k) != cuts_.end()) continue;
      double true_step = 0;
      for (std::size_t j = std::max<std::size_t>(k, 3) - 2; j <= std::min(k + 2, force_.size() - 1); ++j)
        true_step = std::max(true_step, step(right_force_, j));
      const double over = step(force_, k) - true_step;
      out_.step_over_N = std::max(out_.step_over_N, over);
      out_.jumps += over > limits_.step_over_N;
    }
    out_.jitter_mm = shaking_mm(held_mm);
    return out_;
  }

 private:
  static constexpr double kBehind_A = 0.5;

  LoopSettings loop_;
  StabilityLimits limits_;
  bool check_jump_, behind_ = false;
  StabilityResult out_;
  scenes::Path path_;
  std::vector<Vec3> force_, right_force_;
  std::vector<std::size_t> cuts_;
};

// Where the spheres of a scene are.
class Motions {
 public:
  explicit Motions(const StabilityScene& scene) {
    for (const StabilityMotion& m : scene.motions) {
      auto next = made_.empty() ? SphereMotion::make(scene.scene.spheres, m.to, m.ticks)
                                : SphereMotion::after(*made_.back(), m.to, m.ticks);
      made_.push_back(*std::move(next));
    }
  }
  /// One tick further; `begin` as StabilityTick::motion.
  MotionPhase tick(int begin) {
    if (begin >= 0) now_ = made_[std::size_t(begin)].get(), ticks_ = 0;
    if (!now_) return {};
    ticks_ = std::min(ticks_ + 1, now_->ticks());
    return {now_, double(ticks_) / now_->ticks()};
  }

 private:
  std::vector<std::unique_ptr<const SphereMotion>> made_;
  const SphereMotion* now_ = nullptr;
  int ticks_ = 0;
};

std::unique_ptr<Interaction> feltIn(const StabilityScene& scene, const scenes::Scene& now, const Method& method) {
  const auto grid = std::make_shared<const SphereGrid>(now.spheres);
  std::unique_ptr<Interaction> out = method.make(grid, now.probe_A);
  if (scene.rough()) out = std::make_unique<FrictionLayer>(std::move(out), grid, nullptr, nullptr, scene.friction);
  return out;
}

// From the end of the path straight up to the true surface and a little farther, where everything is released.
scenes::Path letGo(scenes::Path path, const Vec3& scp_A) {
  constexpr double kStep_A = 0.01, kBeyond_A = 0.3;
  const Vec3 from = path.back(), way = scp_A - from;
  const double length = glm::length(way);
  if (!(length > 0)) return path;
  const int pieces = static_cast<int>(std::ceil((length + kBeyond_A) / kStep_A));
  for (int k = 1; k <= pieces; ++k) path.push_back(from + way * ((length + kBeyond_A) / length * k / pieces));
  return path;
}

}  // namespace

StabilityResult runScene(const StabilityScene& scene, const Method& method, const LoopSettings& settings,
                         const StabilityLimits& limits) {
  LoopSettings loop = settings;
  loop.workspace.centre_A = middleOf(scene.scene);
  if (scene.stiffness_N_per_mm > 0) loop.stiffness_N_per_mm = scene.stiffness_N_per_mm;
  scenes::Scene now = scene.scene;
  std::unique_ptr<Interaction> felt = feltIn(scene, now, method);
  RightAnswer right(now, isReference(method), scene.rough() ? std::optional(scene.friction) : std::nullopt);
  Judge judge(scene, method, loop, limits);
  ClosedLoop device(loop, {scene.script.front().place_A});
  device.setFriction(scene.friction);
  Motions motions(scene);
  std::vector<Vec3> held_mm;
  std::vector<MotionPhase> phases;
  bool pulls = false;
  Vec3 last_scp(0.0);

  for (std::size_t k = 0; k < scene.script.size(); ++k) {
    const StabilityTick& t = scene.script[k];
    if (t.reset) {
      felt->reset();
      right.reset();
      judge.cut();
    }
    if (t.swap && scene.second) {
      now = *scene.second;
      felt = feltIn(scene, now, method);
      right.swap(now);
      judge.cut();
    }
    if (t.take >= 0 || t.let_go) {
      // As the program does it: another interaction, which begins where the hand is.
      felt = feltIn(scene, scene.scene, method);
      if (t.take >= 0)
        felt = std::make_unique<PullSpring>(std::move(felt), std::vector{std::uint32_t(t.take)}, now.spheres);
      pulls = t.take >= 0;
      right.reset();
      judge.cut();
    }
    if (t.probe_A >= 0) {
      now.probe_A = t.probe_A;
      felt->setProbe(t.probe_A);
      right.setProbe(t.probe_A);
    }
    const Friction friction{t.friction, scene.friction.stick_slip};
    if (t.friction >= 0) device.setFriction(friction);
    const MotionPhase phase = motions.tick(t.motion);
    if (phase.motion) {
      now.spheres = phase.motion->at(phase.fraction);
      right.setMotion(phase);
    }
    LoopTick tick;
    if (scene.hand) {
      tick = device.tick(*felt, {t.place_A}, t.fault, phase);
    } else {
      tick.hip = {t.place_A};
      tick.contact = felt->respond({tick.hip, kNoRotation}).contact;
    }
    // A tick without a reading has no reference; the next one has.
    if (!tick.stepped || t.fault == LoopFault::NotANumber) continue;
    if (scene.rough()) right.setSurface(felt->surface());
    RightAnswer::Answer answer = right.step(tick.hip.A, tick.contact);
    // The grip is the same for every method and its own reference.
    if (pulls) answer = {true, tick.hip.A + tick.contact.displacement_A, tick.contact.displacement_A, false};
    judge.tick(now, tick.hip.A, tick.contact, answer);
    phases.push_back(phase);
    last_scp = answer.scp_A;
    if (k + scene.held_ticks / 2 >= scene.script.size()) held_mm.push_back(device.device().position().mm);
  }
  StabilityResult out = judge.result(scene.hand && scene.held_ticks ? held_mm : std::vector<Vec3>{});
  if (scene.energy) {
    out.energy_J = scene.motions.empty() ? madeOverClosedPath([&] { return feltIn(scene, scene.scene, method); },
                                                              scene.scene, judge.path(), loop)
                                         : madeOverMoving(*feltIn(scene, scene.scene, method), scene.scene, phases,
                                                          letGo(judge.path(), last_scp), loop);
    out.loop_energy_J = device.made_J();
    out.sampling_J = device.samplingBound_J();
  }
  return out;
}

std::vector<StabilityResult> resultsWhere(const std::vector<StabilityResult>& results, bool changing) {
  std::vector<StabilityResult> out;
  std::copy_if(results.begin(), results.end(), std::back_inserter(out),
               [&](const StabilityResult& r) { return r.changing == changing; });
  return out;
}

std::vector<StabilityResult> measureStability(const StabilityOptions& options, const Progress& progress) {
  std::vector<std::vector<StabilityScene>> drawn;
  for (std::size_t draw = 0; draw < options.draws; ++draw) drawn.push_back(drawnScenes(options.seed, draw));
  if (drawn.empty()) return {};
  const std::size_t scenes = drawn.front().size(), methods = options.methods.size();
  std::vector<StabilityResult> out(scenes * methods * options.draws);
  inScenesAndDraws(
      scenes, methods, options.draws,
      [&](std::size_t scene, std::size_t method, std::size_t draw, std::size_t k) {
        out[k] = runScene(drawn[draw][scene], *options.methods[method], options.loop, options.limits);
        out[k].draw = draw;
      },
      [&](double share, std::size_t scene) {
        if (progress) progress(share, drawn.front()[scene].name);
      });
  return out;
}

}  // namespace moltact::bench
