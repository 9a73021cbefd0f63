#include "engine/bench/energies/energy_trade_off.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>

#include "engine/bench/energies/double_sum.h"
#include "engine/bench/many_threads.h"
#include "engine/core/quantile.h"
#include "engine/haptics/field/compute_grid.h"

namespace moltact::bench {
namespace {

constexpr double kCoarse_A = 0.75;

// A method on a task. `make` gives a fresh one each time, which shares what has been prepared.
struct PreparedEnergy {
  using At = std::function<PairEnergy(const PoseA&)>;
  std::function<At()> make;
  std::size_t bytes = 0;
  double preparation_s = 0;
  GridBox cells;  // whose faces are crossed
};

bool isGridKind(EnergyKind kind) { return kind != EnergyKind::Double && kind != EnergyKind::Float; }

// The held atoms within 5 A of the scene at home, by index.
std::vector<std::size_t> heldNearScene(const EnergyTask& task) {
  constexpr double kNear_A = 5.0;
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < task.held.size(); ++i) {
    const Vec3 place = task.home_A + task.held[i].centre_A;
    bool near = false;
    task.scene->visitCentresNear(place, kNear_A, [&](std::uint32_t, const Sphere& s) {
      near = near || glm::distance(s.centre_A, place) < kNear_A;
    });
    if (near) out.push_back(i);
  }
  return out;
}

// Every place of these held atoms on the path.
std::pair<Vec3, Vec3> reachedBox(const EnergyTask& task, const std::vector<std::size_t>& atoms,
                                 const std::vector<PoseA>& path) {
  Vec3 low(1e300), high(-1e300);
  for (const std::size_t i : atoms)
    for (const PoseA& p : path) {
      const Vec3 at = p.place.A + p.orientation * task.held[i].centre_A;
      low = glm::min(low, at), high = glm::max(high, at);
    }
  return {low, high};
}

Expected<PreparedEnergy> preparedGrid(const EnergyTask& task, const EnergyMethod& method,
                                      const std::vector<PoseA>& path) {
  PreparedEnergy out;
  const std::vector<float> sizes = gridSizes(task.held);
  const auto from = std::chrono::steady_clock::now();
  const auto maps = [&](Vec3 low, Vec3 high, double spacing_A) -> Expected<std::shared_ptr<const GridMaps>> {
    const auto box = gridBoxRound(low, high, spacing_A);
    if (!box) return box.problem();
    if (double(box->count()) * double(sizes.size() + 1) * sizeof(float) > kMaxMeasuredMaps_bytes)
      return std::shared_ptr<const GridMaps>{};
    auto made = computeGridMaps(*task.scene, task.atoms, *box, sizes, {});
    foldWalls(*made, kGridWall_kcal_mol);
    out.bytes += made->bytes();
    return std::make_shared<const GridMaps>(*std::move(made));
  };
  const bool nested = method.kind == EnergyKind::Nested;
  std::vector<std::size_t> all(task.held.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  const auto [low, high] = reachedBox(task, all, path);
  // A hundredth more for the rounding, and a tenth for crossing a face nearby.
  const Vec3 more(0.01 + method.size_A);
  const auto coarse = maps(low - more, high + more, nested ? kCoarse_A : method.size_A);
  if (!coarse) return coarse.problem();
  if (!*coarse) return out;
  out.cells = (*coarse)->box;
  std::shared_ptr<const GridMaps> fine;
  if (nested) {
    const auto [near_low, near_high] = reachedBox(task, heldNearScene(task), path);
    const auto made = maps(glm::max(near_low - kGridBlend_A, (*coarse)->box.low_A()),
                           glm::min(near_high + kGridBlend_A, (*coarse)->box.high_A()), method.size_A);
    if (!made) return made.problem();
    if (!*made) return out;
    fine = *made;
    out.cells = fine->box;
  }
  out.preparation_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
  const auto interpolation =
      method.kind == EnergyKind::Trilinear ? GridInterpolation::Trilinear : GridInterpolation::Tricubic;
  out.make = [coarse = *coarse, fine, interpolation, body = gridAtoms(task.held, sizes)] {
    auto grid = std::make_shared<EnergyGrid>(coarse, fine, body, interpolation, PairModel{}.wall_kcal_mol);
    return [grid](const PoseA& pose) { return grid->at(pose); };
  };
  return out;
}

Expected<PreparedEnergy> preparedEnergy(const EnergyTask& task, const EnergyMethod& method,
                                        const std::vector<PoseA>& path) {
  if (isGridKind(method.kind)) return preparedGrid(task, method, path);
  PreparedEnergy out;
  out.cells = GridBox{Vec3(0.0), 0.375, {}};
  PairModel model;
  model.cutoff_A = method.size_A;
  model.switch_from_A = method.size_A - 2.0;
  if (method.kind == EnergyKind::Double) {
    out.make = [&task, cutoff_A = method.size_A] {
      auto sum = std::make_shared<DoubleSum>(task.scene, task.atoms, task.held, cutoff_A, true);
      return [sum](const PoseA& pose) { return sum->at(pose); };
    };
    DoubleSum sum(task.scene, task.atoms, task.held, method.size_A, true);
    sum.at({{task.home_A}});
    out.bytes = sum.bytes();
  } else {
    out.make = [&task, model] {
      auto sum = std::make_shared<PairSum>(task.scene, task.atoms, task.held, model);
      return [sum](const PoseA& pose) { return sum->at(pose); };
    };
    out.bytes = PairSum(task.scene, task.atoms, task.held, model).bytes();
  }
  return out;
}

void timeEnergy(const PreparedEnergy& method, const std::vector<PoseA>& path, int runs, EnergyTradeOff& out) {
  using SteadyClock = std::chrono::steady_clock;
  std::vector<double> least(path.size(), 1e300);
  for (int k = 0; k < runs; ++k) {
    const auto at = method.make();
    for (int warm = 0; warm < PairSum::kCurvatureTicks; ++warm) at(path.front());
    for (std::size_t i = 0; i < path.size(); ++i) {
      const auto from = SteadyClock::now();
      [[maybe_unused]] const volatile double felt = at(path[i]).energy.felt_kcal_mol;
      least[i] = std::min(least[i], std::chrono::duration<double, std::micro>(SteadyClock::now() - from).count());
    }
  }
  out.mean_us = std::accumulate(least.begin(), least.end(), 0.0) / double(least.size());
  std::sort(least.begin(), least.end());
  out.p999_us = percentile(least, 0.999);
}

// The force before and behind the nearest face of a cell along an axis, for one held atom.
double jumpAt(const PreparedEnergy::At& at, const GridBox& cells, PoseA pose, const PairAtom& atom, int axis) {
  constexpr double kBeside_A = 1e-7;
  const Vec3 place = pose.place.A + pose.orientation * atom.centre_A;
  const double cell = (place[axis] - cells.first_A[axis]) / cells.spacing_A;
  pose.place.A[axis] += (std::round(cell) - cell) * cells.spacing_A - kBeside_A;
  const Vec3 before = at(pose).force_kcal_mol_A;
  pose.place.A[axis] += 2 * kBeside_A;
  return glm::distance(before, at(pose).force_kcal_mol_A);
}

void judgeEnergy(const PreparedEnergy& method, const EnergyTask& task, const std::vector<PoseA>& poses,
                 const std::vector<PairEnergy>& right, const std::vector<PairEnergy>& own_right, EnergyTradeOff& out) {
  std::vector<double> energy, force, own_force, torque, jump;
  const std::vector<std::size_t> near = heldNearScene(task);
  double force2 = 0, torque2 = 0;
  const auto at = method.make();
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const PairEnergy found = at(poses[k]);
    energy.push_back(std::abs(found.energy.felt_kcal_mol - right[k].energy.felt_kcal_mol));
    force.push_back(glm::distance(found.force_kcal_mol_A, right[k].force_kcal_mol_A));
    torque.push_back(glm::distance(found.torque_kcal_mol, right[k].torque_kcal_mol));
    own_force.push_back(glm::distance(found.force_kcal_mol_A, own_right[k].force_kcal_mol_A));
    if (!near.empty())
      jump.push_back(jumpAt(at, method.cells, poses[k], task.held[near[k * 7 % near.size()]], int(k % 3)));
    force2 += glm::dot(right[k].force_kcal_mol_A, right[k].force_kcal_mol_A);
    torque2 += glm::dot(right[k].torque_kcal_mol, right[k].torque_kcal_mol);
  }
  out.judged = poses.size();
  out.right_force = std::sqrt(force2 / double(poses.size()));
  out.right_torque = std::sqrt(torque2 / double(poses.size()));
  out.energy = statisticsOf(std::move(energy));
  out.force = statisticsOf(std::move(force));
  out.own_force = statisticsOf(std::move(own_force));
  out.torque = statisticsOf(std::move(torque));
  out.jump = statisticsOf(std::move(jump));
}

std::vector<PairEnergy> rightEnergies(const EnergyTask& task, const std::vector<PoseA>& poses, double cutoff_A) {
  std::vector<PairEnergy> out(poses.size());
  inManyThreads(
      poses.size(),
      [&](std::size_t k) { out[k] = DoubleSum(task.scene, task.atoms, task.held, cutoff_A, false).at(poses[k]); },
      [](std::size_t) {});
  return out;
}

}  // namespace

double EnergyMethod::cutoff_A() const { return isGridKind(kind) ? PairModel{}.cutoff_A : size_A; }

std::string EnergyMethod::name() const {
  const char* kinds[] = {"double", "float", "trilinear", "tricubic", "nested"};
  return std::string(kinds[std::size_t(kind)]) + ' ' + constant(size_A) + " A";
}

std::vector<EnergyMethod> energyMethods() {
  std::vector<EnergyMethod> out{{EnergyKind::Double, 10.0}};
  for (const double cutoff_A : {6.0, 8.0, 10.0, 12.0, 14.0}) out.push_back({EnergyKind::Float, cutoff_A});
  for (const EnergyKind kind : {EnergyKind::Trilinear, EnergyKind::Tricubic})
    for (const double spacing_A : {0.2, 0.375, 0.5, 0.75}) out.push_back({kind, spacing_A});
  out.push_back({EnergyKind::Nested, 0.2});
  return out;
}

Expected<std::vector<EnergyTradeOff>> measureEnergies(const EnergyTradeOffOptions& options, const OpenMolecule& open,
                                                      const Progress& progress) {
  std::vector<EnergyTradeOff> out;
  const std::vector<EnergyMethod>& methods = options.methods;
  for (std::size_t b = 0; b < options.bodies.size(); ++b) {
    const auto task = energyTask(options.bodies[b], open);
    if (!task) return task.problem();
    const std::vector<PoseA> path = energyPath(*task, options.ticks);
    const double pairs = double(task->held.size()) * double(task->atoms.size());
    const auto judged = std::size_t(std::clamp(options.judged_pairs / pairs, 20.0, 400.0));
    std::vector<PoseA> poses;
    for (std::size_t k = 0; k < judged; ++k) poses.push_back(path[k * path.size() / judged]);
    const std::vector<PairEnergy> right = rightEnergies(*task, poses, std::numeric_limits<double>::infinity());
    std::map<double, std::vector<PairEnergy>> own_right;  // by cut-off
    for (const EnergyMethod& m : methods)
      if (auto& own = own_right[m.cutoff_A()]; own.empty()) own = rightEnergies(*task, poses, m.cutoff_A());
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (progress)
        progress((double(b) + double(m) / double(methods.size())) / double(options.bodies.size()),
                 task->name + ", " + methods[m].name());
      if (isGridKind(methods[m].kind) && methods[m].size_A < options.min_spacing_A) continue;
      EnergyTradeOff one;
      one.body = task->name;
      one.held = task->held.size();
      one.scene = task->atoms.size();
      one.method = methods[m];
      const auto prepared = preparedEnergy(*task, methods[m], path);
      if (!prepared) return prepared.problem();
      one.bytes = prepared->bytes;
      one.preparation_s = prepared->preparation_s;
      one.measured = bool(prepared->make);
      if (one.measured) {
        timeEnergy(*prepared, path, options.runs, one);
        judgeEnergy(*prepared, *task, poses, right, own_right[methods[m].cutoff_A()], one);
      }
      out.push_back(std::move(one));
    }
  }
  if (progress) progress(1, "");
  return out;
}

}  // namespace moltact::bench
