// A simulation that runs while the window shows it: positions come out, the hand's pushes go in. It may run on a thread
// of its own (simulation_thread.h), between frames, or in another program. All functions: one thread, the window's; none
// waits for the simulation. Units: angstrom, kcal/mol, picosecond, kelvin, second.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/dynamics/md_engine.h"

namespace moltact {

/// A spring that pushes an atom, now at `at_A`, with this force (unit: kcal/mol/A), which must not be zero.
AtomPush pushOf(std::uint32_t atom, const Vec3& at_A, const Vec3& force_kcal_mol_A, double stiffness_kcal_mol_A2);

/// The window's requests. The newest command replaces the earlier ones; the counters never decrease, so that a request is
/// carried out once even if commands are skipped.
struct SimulationCommand {
  std::vector<AtomPush> pushes;
  bool running = true;
  double ps_per_s = 1.0;         ///< simulated time per second
  double temperature_K = 300.0;  ///< of the bath
  /// Requests so far: make one step of kSingle_ps while it stands still, relax to a minimum, start again.
  std::uint32_t singles = 0, relaxations = 0, restarts = 0;
};

/// The newest state.
struct SimulationFrame {
  std::uint64_t serial = 0;       ///< grows with each frame
  std::vector<Vec3> positions_A;  ///< mean over the steps since the frame before
  double time_ps = 0.0;           ///< since the start or restart
  MdEnergies energies;
  double ps_per_s = 0.0;       ///< what the engine achieves, less than asked for where the system is too large
  std::uint32_t starts = 0;    ///< how often the atoms jumped: restarts, relaxations and blow-ups
  std::uint32_t blow_ups = 0;  ///< how often it became unstable and started again
  std::string fault;           ///< the engine's words for the last one; empty: none
  bool dead = false;           ///< it cannot be started again
  bool lost = false;           ///< it has ended without being unstable; `fault` says why, in words for people
  // Of a simulation in another program (imd/imd_simulation.h), which may send less.
  double frames_per_s = 0.0;  ///< that arrive
  bool silent = false;        ///< none has arrived for a while: the hand must not feel the last one
  bool wrapped = false;       ///< atoms that leave its box come back on the other side: they jump
  bool has_time = true, has_temperature = true, has_energy = true;
};

/// What computes a simulation; empty and 0 for another program.
struct EngineFacts {
  std::string name, platform;  ///< "OpenMM 7.7", "CPU"
  double step_ps = 0.0, measured_steps_per_s = 0.0;
};
EngineFacts factsOf(const MdEngine& engine);

class LiveSimulation {
 public:
  /// Duration of a single step (SimulationCommand::singles).
  static constexpr double kSingle_ps = 0.02;

  virtual ~LiveSimulation() = default;
  /// The reference is valid until the next call.
  virtual const SimulationFrame& newest() = 0;
  virtual void command(const SimulationCommand& wanted) = 0;
  /// Called once per frame with the time since the last one, for a simulation that runs between frames.
  virtual void pass(double /*dt_s*/) {}
  /// Whether all members of a command have an effect; else `pushes` and `running` only.
  virtual bool obeysAll() const { return true; }
  /// Whether it is still being prepared: there is no frame, and engine() is empty.
  virtual bool opening() const { return false; }
  virtual EngineFacts engine() const { return {}; }
};

/// The logic of a simulation beside a window, without a thread or a clock.
class SimulationRun {
 public:
  explicit SimulationRun(std::unique_ptr<MdEngine> engine) : engine_(std::move(engine)) {}

  const MdEngine& engine() const { return *engine_; }
  /// Carries out the command for `elapsed_s` of the window's time, with at most this number of steps. The rest is left
  /// out, so a slow engine slows the simulated time down. An unstable run starts again and stands still until the next
  /// restart or relaxation is asked for. A relaxation takes several calls, each of at most kRelaxSlice iterations and
  /// without a step; the frame stays as it is until the last of them. The reference is valid until the next call.
  const SimulationFrame& advance(const SimulationCommand& wanted, double elapsed_s, int max_steps);

  /// A run is unstable beyond this temperature above the bath's, or if an atom is farther than this from the origin.
  static constexpr double kUnstable_K = 3000.0, kUnstable_A = 1e4;
  /// Limits on the iterations of a relaxation, and on those of one call. A thread that ends waits for one call at most.
  static constexpr int kRelaxIterations = 500, kRelaxSlice = 50;
  /// A relaxation has begun and not ended.
  bool relaxing() const { return left_to_relax_ > 0; }

 private:
  void blowUp(const std::string& why);
  bool stable();
  bool relaxSlice();
  void take(std::string why) {
    if (!why.empty() && !frame_.dead) blowUp(why);
  }

  std::unique_ptr<MdEngine> engine_;
  SimulationFrame frame_;
  SimulationCommand last_;
  double owed_steps_ = 0.0;
  int left_to_relax_ = 0;       // iterations
  double energy_before_ = 0.0;  // after the last slice
  bool halted_ = false;         // after a blow-up
};

/// Runs between frames: for a window whose clock is its frames.
class SteppedSimulation final : public LiveSimulation {
 public:
  explicit SteppedSimulation(std::unique_ptr<MdEngine> engine) : run_(std::move(engine)) {}
  EngineFacts engine() const override { return factsOf(run_.engine()); }
  const SimulationFrame& newest() override { return newest_; }
  void command(const SimulationCommand& wanted) override { wanted_ = wanted; }
  void pass(double dt_s) override { newest_ = run_.advance(wanted_, dt_s, 1'000'000); }

 private:
  SimulationRun run_;
  SimulationCommand wanted_;
  SimulationFrame newest_;
};

}  // namespace moltact
