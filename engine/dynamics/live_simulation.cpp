#include "engine/dynamics/live_simulation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moltact {
namespace {
// The positions of a frame are the mean of about this number of moments since the last frame.
constexpr int kMoments = 8;
// A relaxation ends when a slice lowers the energy by less than this.
constexpr double kRelaxed_kcal_mol = 1e-3;
}  // namespace

AtomPush pushOf(std::uint32_t atom, const Vec3& at_A, const Vec3& force_kcal_mol_A, double stiffness_kcal_mol_A2) {
  return {atom, at_A + force_kcal_mol_A / stiffness_kcal_mol_A2, glm::normalize(force_kcal_mol_A),
          stiffness_kcal_mol_A2};
}

EngineFacts factsOf(const MdEngine& engine) {
  return {engine.name(), std::string(engine.platform()), engine.step_ps(), engine.measured_steps_per_s()};
}

void SimulationRun::blowUp(const std::string& why) {
  frame_.fault = why;
  ++frame_.blow_ups;
  ++frame_.starts;
  frame_.time_ps = 0.0;
  owed_steps_ = 0.0;
  left_to_relax_ = 0;
  halted_ = true;
  frame_.dead = !engine_->push({}).empty() || !engine_->restart().empty();
}

bool SimulationRun::stable() {
  for (const Vec3& v : engine_->positions_A())
    if (!finite(v) || std::abs(v.x) > kUnstable_A || std::abs(v.y) > kUnstable_A || std::abs(v.z) > kUnstable_A)
      return false;
  const double kelvin = engine_->energies().temperature_K;
  return std::isfinite(kelvin) && kelvin < last_.temperature_K + kUnstable_K;
}

// Continues a relaxation; returns true when it has ended.
bool SimulationRun::relaxSlice() {
  const int now = std::min(kRelaxSlice, left_to_relax_);
  left_to_relax_ -= now;
  take(engine_->relax(now));
  if (halted_) return false;
  const double energy = engine_->energies().potential_kcal_mol;
  if (!(energy_before_ - energy >= kRelaxed_kcal_mol)) left_to_relax_ = 0;
  energy_before_ = energy;
  if (left_to_relax_ > 0) return false;
  ++frame_.starts;
  return true;
}

const SimulationFrame& SimulationRun::advance(const SimulationCommand& wanted, double elapsed_s, int max_steps) {
  const SimulationCommand before = last_;
  last_ = wanted;
  if (frame_.dead) return frame_;
  const bool first = frame_.serial == 0;
  if (first || wanted.temperature_K != before.temperature_K) take(engine_->setTemperature(wanted.temperature_K));
  if (wanted.restarts != before.restarts) {
    take(engine_->restart());
    frame_.time_ps = 0.0;
    frame_.fault.clear();
    ++frame_.starts;
    halted_ = false;
    left_to_relax_ = 0;
  }
  if (wanted.relaxations != before.relaxations) {
    halted_ = false;
    left_to_relax_ = kRelaxIterations;
    energy_before_ = std::numeric_limits<double>::infinity();
  }
  bool relaxed = false;
  if (left_to_relax_ > 0) {
    relaxed = relaxSlice();
    if (!relaxed && !halted_) {
      frame_.ps_per_s = 0.0;
      return frame_;
    }
  }
  if (!halted_) take(engine_->push(wanted.pushes));
  double steps = 0.0;
  if (halted_ || relaxed) {
    owed_steps_ = 0.0;
  } else if (wanted.running) {
    steps = std::min(elapsed_s * wanted.ps_per_s / engine_->step_ps() + owed_steps_, double(max_steps));
    owed_steps_ = steps - std::floor(steps);
  } else {
    owed_steps_ = 0.0;
    steps = std::min<double>(wanted.singles - before.singles, 10.0) * LiveSimulation::kSingle_ps / engine_->step_ps();
    steps = std::round(steps);
  }
  int left = int(steps), moments = 0;
  const int batch = std::max(1, left / kMoments);
  std::vector<Vec3> sum;
  while (left > 0 && !halted_) {
    const int now = std::min(batch, left);
    take(engine_->advance(now));
    if (halted_) break;
    left -= now;
    frame_.time_ps += now * engine_->step_ps();
    const std::span<const Vec3> at = engine_->positions_A();
    sum.resize(at.size(), Vec3(0.0));
    for (std::size_t i = 0; i < at.size(); ++i) sum[i] += at[i];
    ++moments;
  }
  if (!frame_.dead && !halted_ && !stable()) blowUp("");
  if (frame_.dead) return frame_;
  if (moments > 0 && !halted_) {
    for (Vec3& v : sum) v /= double(moments);
    frame_.positions_A = std::move(sum);
  } else if (first || halted_ || relaxed || wanted.restarts != before.restarts) {
    const std::span<const Vec3> at = engine_->positions_A();
    frame_.positions_A.assign(at.begin(), at.end());
  }
  frame_.energies = engine_->energies();
  if (wanted.running && !halted_ && elapsed_s > 0.0)
    frame_.ps_per_s = int(steps) * engine_->step_ps() / elapsed_s;
  else
    frame_.ps_per_s = 0.0;
  ++frame_.serial;
  return frame_;
}

}  // namespace moltact
