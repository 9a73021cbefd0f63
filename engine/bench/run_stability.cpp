// The running half of stability.h; its tables are in stability_tables.cpp.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/bench/oracle.h"
#include "engine/bench/plain_wall.h"
#include "engine/bench/right_answer.h"
#include "engine/bench/stability.h"

namespace moltact::bench {
namespace {

// Shaking at 200 Hz that stays under this speed moves the hand by less than 0.01 mm, which no finger feels.
constexpr double kRest_m_per_s = 0.006;

Vec3 middleOf(const scenes::Scene& scene) {
  Vec3 low(1e300), high(-1e300);
  for (const Ball& b : scene.balls) low = glm::min(low, b.centre_A), high = glm::max(high, b.centre_A);
  return 0.5 * (low + high);
}

// Peak to peak about the straight line through the places: against friction a hand settles slowly, and that
// is no shaking.
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

// Collects what a tick shows.
class Judge {
 public:
  Judge(const StabilityScene& scene, const Method& method, const LoopSettings& loop)
      : loop_(loop), check_jump_(scene.jump), check_energy_(scene.energy) {
    out_.scene = scene.name;
    out_.method = &method;
  }

  void tick(const scenes::Scene& now, const Vec3& hip, const Contact& c, const RightAnswer::Answer& right) {
    ++out_.ticks;
    if (!finite(c.scp.A)) {
      ++out_.broken;
      return;
    }
    const double inside = oracle::deepest(now.balls, now.probe_A, hip);
    if (c.touching())
      out_.penetration_A = std::max(out_.penetration_A, oracle::deepest(now.balls, now.probe_A, c.scp.A));
    if (right.known) {
      const double held_away = right.touching ? glm::distance(right.scp_A, hip) : 0.0;
      out_.contact_ticks += right.touching;
      const bool behind = right.touching && !c.touching() && inside <= 0 && held_away > 0.5;
      out_.tunnelled += behind && !behind_;
      behind_ = behind;
      out_.lost += right.touching && !c.touching() && inside > 0 && held_away > 0.02;
      out_.stuck += !right.touching && c.touching() && glm::distance(c.scp.A, hip) > 0.2;
      out_.astray += right.touching && c.touching() && glm::distance(c.scp.A, right.scp_A) > 0.5;
    }
    force_.push_back(springForce(loop_, {hip}, c, loop_.device.max_force_N).N);
    Contact ideal;
    ideal.scp.A = right.scp_A;
    ideal.feature = right.touching ? Feature::Sphere : Feature::Free;
    right_force_.push_back(springForce(loop_, {hip}, ideal, loop_.device.max_force_N).N);

    const ForceN full = springForce(loop_, {hip}, c, std::numeric_limits<double>::infinity());
    const double k = 1e3 * loop_.stiffness_N_per_mm;
    if (out_.ticks > 1) {
      const Vec3 moved_m =
          1e-3 * (loop_.workspace.toDevice({hip}).mm - loop_.workspace.toDevice({last_hip_}).mm);
      const double stored = glm::dot(full.N, full.N) / (2 * k);
      energy_.add(0.5 * (full.N + last_full_), moved_m, stored);
    }
    last_full_ = full.N;
    last_hip_ = hip;
  }

  // The tracker begins anew: what it was is no part of what it is.
  void cut() { cuts_.push_back(force_.size()); }

  StabilityResult result(double loop_energy_J, double sampling_J, const std::vector<Vec3>& held_mm) {
    const auto step = [](const std::vector<Vec3>& f, std::size_t k) { return glm::distance(f[k], f[k - 1]); };
    for (std::size_t k = 1; k < force_.size(); ++k) {
      out_.step_N = std::max(out_.step_N, step(force_, k));
      if (!check_jump_ || std::find(cuts_.begin(), cuts_.end(), k) != cuts_.end()) continue;
      double true_step = 0;
      for (std::size_t j = std::max<std::size_t>(k, 3) - 2; j <= std::min(k + 2, force_.size() - 1); ++j)
        true_step = std::max(true_step, step(right_force_, j));
      out_.step_over_N = std::max(out_.step_over_N, step(force_, k) - true_step);
    }
    out_.jitter_mm = shaking_mm(held_mm);
    if (check_energy_)
      out_.energy_J = energy_.made_J(), out_.loop_energy_J = loop_energy_J, out_.sampling_J = sampling_J;
    return out_;
  }

 private:
  LoopSettings loop_;
  bool check_jump_, check_energy_, behind_ = false;
  StabilityResult out_;
  PassivityObserver energy_;
  Vec3 last_full_{0.0}, last_hip_{0.0};
  std::vector<Vec3> force_, right_force_;
  std::vector<std::size_t> cuts_;
};

}  // namespace

StabilityResult runScene(const StabilityScene& scene, const Method& method, const LoopSettings& settings) {
  LoopSettings loop = settings;
  loop.workspace.centre_A = middleOf(scene.scene);
  scenes::Scene now = scene.scene;
  auto tracker = method.make(std::make_shared<const BallScene>(now.balls), now.probe_A);
  RightAnswer right(now, method.name == "exact");
  Judge judge(scene, method, loop);
  ClosedLoop device(loop, {scene.script.front().place_A});
  std::vector<Vec3> held_mm;

  for (std::size_t k = 0; k < scene.script.size(); ++k) {
    const StabilityTick& t = scene.script[k];
    if (t.reset) {
      tracker->reset();
      right.reset();
      judge.cut();
    }
    if (t.swap && scene.second) {
      now = *scene.second;
      tracker = method.make(std::make_shared<const BallScene>(now.balls), now.probe_A);
      right.swap(now);
      judge.cut();
    }
    if (t.probe_A >= 0) {
      now.probe_A = t.probe_A;
      tracker->setProbe(t.probe_A);
      right.setProbe(t.probe_A);
    }
    LoopTick tick;
    if (scene.hand) {
      tick = device.tick(*tracker, {t.place_A}, t.kind);
    } else {
      tick.hip = {t.place_A};
      tick.contact = tracker->step(tick.hip);
    }
    // A tick without a reading has no right answer; the next has.
    if (!tick.stepped || t.kind == TickKind::NotANumber) continue;
    judge.tick(now, tick.hip.A, tick.contact, right.step(tick.hip.A, tick.contact));
    if (k + scene.held_ticks / 2 >= scene.script.size()) held_mm.push_back(device.device().position().mm);
  }
  return judge.result(device.made_J(), device.samplingBound_J(),
                      scene.hand && scene.held_ticks ? held_mm : std::vector<Vec3>{});
}

double stiffestStable(const std::function<std::unique_ptr<Tracker>()>& make,
                      const StabilityScene::Press& press, LoopSettings loop) {
  loop.hand = {100, 2};
  loop.workspace.centre_A = press.from;
  const auto rests = [&](double stiffness) {
    loop.stiffness_N_per_mm = stiffness;
    ClosedLoop device(loop, {press.from});
    const auto tracker = make();
    double fastest_m_per_s = 0;
    std::size_t touching = 0;
    constexpr int kTicks = 1600, kIn = 300, kStruck = 600, kWatched = 400;
    for (int k = 0; k < kTicks; ++k) {
      const Vec3 target = press.from + (press.to - press.from) * std::min(1.0, double(k) / kIn);
      if (k == kStruck) device.device().strike(glm::normalize(press.to - press.from) * 0.004);
      const LoopTick tick = device.tick(*tracker, {target});
      if (k < kTicks - kWatched) continue;
      fastest_m_per_s = std::max(fastest_m_per_s, glm::length(device.device().velocity_m_per_s()));
      touching += tick.contact.touching();
    }
    return touching > kWatched / 2 && fastest_m_per_s < kRest_m_per_s;
  };
  double stable = 0.02, unstable = 20;
  if (!rests(stable)) return 0;
  if (rests(unstable)) return unstable;
  while (unstable / stable > 1.03) {
    const double middle = std::sqrt(stable * unstable);
    (rests(middle) ? stable : unstable) = middle;
  }
  return stable;
}

double stiffestStableOnWall(const LoopSettings& loop) {
  return stiffestStable([] { return std::make_unique<PlainWall>(); }, {{0, 0, 0.3}, {0, 0, -1}}, loop);
}

std::vector<StabilityResult> measureStability(const StabilityOptions& options, const Progress& progress) {
  const std::vector<StabilityScene> scenes = stabilityScenes(options.seed);
  std::vector<StabilityResult> out;
  const double all = double(scenes.size() * options.methods.size());
  for (const StabilityScene& scene : scenes)
    for (const Method* method : options.methods) {
      if (progress) progress(double(out.size()) / all, scene.name);
      StabilityResult one = runScene(scene, *method, options.loop);
      if (options.stiffness && scene.press) {
        const auto balls = std::make_shared<const BallScene>(scene.scene.balls);
        one.stiffest_N_per_mm = stiffestStable([&] { return method->make(balls, scene.scene.probe_A); },
                                               *scene.press, options.loop);
      }
      out.push_back(std::move(one));
    }
  if (progress) progress(1, "");
  return out;
}

}  // namespace moltact::bench
