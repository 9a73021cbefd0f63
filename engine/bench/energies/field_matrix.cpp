#include "engine/bench/energies/field_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "engine/bench/closed_loop.h"
#include "engine/bench/energies/energy_task.h"
#include "engine/bench/many_threads.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/field/compute_grid.h"
#include "engine/haptics/field/coupled_field.h"
#include "engine/haptics/methods.h"

namespace moltact::bench {
namespace {

constexpr double kFieldSpacing_A = 0.375, kSlow_A = 0.03;
// Friction damps what a method makes. That of a direct-drive device shows it.
constexpr double kLittleFriction_N = 0.02;
constexpr int kCalm_ticks = 5;  // slow ticks before a step counts

// The force of a field at the hand, without contact.
template <class Sum>
class FieldAtHand final : public Interaction {
 public:
  FieldAtHand(Sum sum, double N_per_kcal_mol_A) : sum_(std::move(sum)), scale_(N_per_kcal_mol_A) {}
  Response respond(const PoseA& pose) noexcept override {
    Response out;
    out.contact.scp = pose.place;
    if (!finite(pose.place.A)) {
      out.contact.fault = Fault::NotFinite;
      return out;
    }
    const PairEnergy e = sum_.at(pose);
    FeltForce field;
    field.force_N = e.force_kcal_mol_A * scale_;
    field.energy_N_A = e.energy.felt_kcal_mol * scale_;
    field.stiffness_N_per_A = e.stiffness_kcal_mol_A2 * scale_;
    out.field = field;
    return out;
  }
  void reset() noexcept override {}
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return 0.0; }
  MemoryUsage memoryUsage() const noexcept override { return {}; }

 private:
  Sum sum_;
  double scale_;
};

std::unique_ptr<Interaction> onGrid(const FieldScene& scene, const std::shared_ptr<const SphereGrid>& places,
                                    GridInterpolation interpolation) {
  Vec3 low(1e300), high(-1e300);
  for (const Vec3& p : scene.path) low = glm::min(low, p), high = glm::max(high, p);
  // The device overshoots the hand's path.
  const double round_A = 4.0 + (scene.body ? scene.body->reach_A : 0.0);
  const auto box = gridBoxRound(low - Vec3(round_A), high + Vec3(round_A), kFieldSpacing_A);
  if (!box) return nullptr;
  const std::vector<PairAtom> body = scene.held();
  const std::vector<float> sizes = gridSizes(body);
  auto maps = computeGridMaps(*places, scene.atoms, *box, sizes, scene.model, 1);
  foldWalls(*maps, kGridWall_kcal_mol);
  return std::make_unique<FieldAtHand<EnergyGrid>>(
      EnergyGrid(std::make_shared<const GridMaps>(*std::move(maps)), nullptr, gridAtoms(body, sizes), interpolation,
                 scene.model.wall_kcal_mol),
      scene.N_per_kcal_mol_A);
}

std::unique_ptr<Interaction> interactionOf(const FieldScene& scene, std::string_view method, double spring_N_per_A) {
  const auto places = std::make_shared<const SphereGrid>(scene.spheres);
  if (method == "trilinear") return onGrid(scene, places, GridInterpolation::Trilinear);
  if (method == "tricubic") return onGrid(scene, places, GridInterpolation::Tricubic);
  PairModel model = scene.model;
  if (method == "direct") model.wall_kcal_mol = std::numeric_limits<double>::infinity();
  if (method != "coupled")
    return std::make_unique<FieldAtHand<PairSum>>(PairSum(places, scene.atoms, scene.held(), model),
                                                  scene.N_per_kcal_mol_A);
  auto field = std::make_shared<PairField>();
  field->places = places;
  field->atoms = scene.atoms;
  for (std::uint32_t i = 0; i < scene.atoms.size(); ++i) field->carriers.push_back(i);
  field->held = scene.held();
  field->model = model;
  VirtualCoupling coupling;
  coupling.stiffness_kcal_mol_A2 = spring_N_per_A / scene.N_per_kcal_mol_A;
  if (scene.body) {
    auto inner = std::make_unique<ExactBody>(places, scene.body);
    coupling.lever_A = inner->lever_A();
    coupling.reach_A = scene.body->reach_A;
    return std::make_unique<CoupledField>(std::move(inner), std::move(field), coupling);
  }
  return std::make_unique<CoupledField>(findMethod("exact")->make(places, scene.probe_A), std::move(field), coupling);
}

double overlapOf(const FieldScene& scene, const PoseA& at) {
  double out = 0.0;
  const auto with = [&](const Vec3& centre_A, double radius_A) {
    for (const Sphere& s : scene.spheres)
      if (s.radius_A > 0.0) out = std::max(out, s.radius_A + radius_A - glm::distance(s.centre_A, centre_A));
  };
  if (!scene.body) with(at.place.A, scene.probe_A);
  if (scene.body)
    for (const Sphere& held : scene.body->spheres) with(at.place.A + at.orientation * held.centre_A, held.radius_A);
  return out;
}

}  // namespace

FieldResult runFieldScene(const FieldScene& scene, std::string_view method) {
  FieldResult out{.scene = scene.name, .method = method};
  LoopSettings loop;
  loop.device.friction_N = kLittleFriction_N;
  loop.stiffness_N_per_mm = scene.loop_N_per_mm;
  const double spring_N_per_A = loop.stiffness_N_per_mm / loop.workspace.A_per_mm;
  const std::unique_ptr<Interaction> felt = interactionOf(scene, method, spring_N_per_A);
  ClosedLoop device(loop, {scene.path.front()});
  Vec3 low(1e300), high(-1e300), last_N(0.0);
  bool outside = false;  // once: before, an overlap is the scene's
  Vec3 last_hip = scene.path.front();
  int calm = 0;
  for (std::size_t k = 0; k < scene.path.size(); ++k) {
    const LoopTick tick = device.tick(*felt, {scene.path[k]});
    ++out.ticks;
    const PoseA at =
        method == "coupled" && tick.contact.fault == Fault::None ? tick.body : PoseA{tick.hip, kNoRotation};
    if (!finite(tick.force.N) || !finite(at.place.A)) {
      ++out.broken;
      continue;
    }
    const double overlap_A = overlapOf(scene, at);
    outside = outside || overlap_A == 0.0;
    if (outside) out.overlap_A = std::max(out.overlap_A, overlap_A);
    calm = glm::distance(tick.hip.A, last_hip) < kSlow_A ? calm + 1 : 0;
    last_hip = tick.hip.A;
    if (calm > kCalm_ticks) out.step_N = std::max(out.step_N, glm::distance(tick.force.N, last_N));
    last_N = tick.force.N;
    out.force_N = std::max(out.force_N, glm::length(tick.force.N));
    if (k >= (scene.held_from + scene.held_to) / 2 && k < scene.held_to) {
      const Vec3 place = device.device().position().mm;
      low = glm::min(low, place), high = glm::max(high, place);
    }
  }
  out.jitter_mm = glm::length(glm::max(Vec3(0.0), high - low));
  out.returned_J = device.made_J();
  out.made_J = std::max(0.0, device.made_J() - device.samplingBound_J());
  return out;
}

std::string failuresOf(const FieldResult& r, const FieldLimits& limits) {
  std::string out;
  if (r.overlap_A > limits.overlap_A) out += 'O';
  if (r.made_J > limits.made_J) out += 'E';
  if (r.step_N > limits.step_N) out += 'S';
  if (r.jitter_mm > limits.jitter_mm) out += 'J';
  if (r.broken) out += 'N';
  return out;
}

std::vector<FieldResult> measureFieldMatrix(const FieldMatrixOptions& options, const Progress& progress) {
  std::vector<std::vector<FieldScene>> drawn;
  for (std::size_t draw = 0; draw < options.draws; ++draw) drawn.push_back(fieldScenes(options.seed, draw));
  if (drawn.empty()) return {};
  const std::size_t scenes = drawn.front().size();
  std::vector<FieldResult> out(scenes * kFieldMethods.size() * options.draws);
  inScenesAndDraws(
      scenes, kFieldMethods.size(), options.draws,
      [&](std::size_t scene, std::size_t method, std::size_t draw, std::size_t k) {
        out[k] = runFieldScene(drawn[draw][scene], kFieldMethods[method]);
        out[k].draw = draw;
      },
      [&](double share, std::size_t scene) {
        if (progress) progress(share, drawn.front()[scene].name);
      });
  return out;
}

}  // namespace moltact::bench
