// What a simulation does to the window over a long time: an hour of pulling with flat memory, and a window that closes
// during a relaxation. MOLTACT_PULL_MINUTES=60 MOLTACT_PULL_MOLECULE=ala10 build/release/test_dynamics -tc='*pulls and lets go*'
// pulls for an hour, at a molecule that `moltact simulate prepare` wrote. Where OpenMM is not installed the tests say that
// they did not run.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "engine/core/random.h"
#include "engine/dynamics/simulation_engines.h"
#include "engine/dynamics/simulation_thread.h"
#include "engine/molecule/reader.h"
#include "tests/dynamics/shipped_system.h"
#include "tests/resident_memory.h"

using namespace moltact;
using namespace moltact::test;

namespace {

struct Draws {
  std::uint64_t state;
  double uniform(double low, double high) { return low + (high - low) * nextFraction(state); }
  Vec3 direction() {
    const double z = uniform(-1.0, 1.0), angle = uniform(0.0, kTwoPi), r = std::sqrt(1.0 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
};

// A chain of 12 u with springs of 100 kcal/mol/A^2 between neighbours, which begins crumpled.
MdStart chainOf(std::size_t atoms) {
  MdStart start;
  std::string masses, bonds;
  Draws random{7};
  for (std::size_t i = 0; i < atoms; ++i) {
    masses += "<Particle mass=\"12\"/>";
    if (i > 0)
      bonds += "<Bond d=\"0.15\" k=\"41840\" p1=\"" + std::to_string(i - 1) + "\" p2=\"" + std::to_string(i) + "\"/>";
    start.positions_A.push_back(Vec3(0.5 * double(i % 100), 0.5 * double(i / 100), 0.0) + 0.8 * random.direction());
  }
  start.system =
      "<?xml version=\"1.0\" ?><System openmmVersion=\"7.7\" type=\"System\" version=\"1\"><PeriodicBoxVectors>"
      "<A x=\"2\" y=\"0\" z=\"0\"/><B x=\"0\" y=\"2\" z=\"0\"/><C x=\"0\" y=\"0\" z=\"2\"/></PeriodicBoxVectors>"
      "<Particles>" +
      masses +
      "</Particles><Constraints/><Forces><Force forceGroup=\"0\" type=\"HarmonicBondForce\" usesPeriodic=\"0\" "
      "version=\"2\"><Bonds>" +
      bonds + "</Bonds></Force></Forces></System>";
  start.platform = "Reference";
  return start;
}

// The first relaxation waits until the window closes; all iterations that were asked for are counted.
struct Closing {
  std::atomic<bool> relaxing{false}, closes{false};
  std::atomic<int> iterations{0};
};
class Watched final : public MdEngine {
 public:
  Watched(std::unique_ptr<MdEngine> engine, Closing& closing) : engine_(std::move(engine)), closing_(closing) {}
  std::size_t atomCount() const override { return engine_->atomCount(); }
  std::span<const double> masses_u() const override { return engine_->masses_u(); }
  double step_ps() const override { return engine_->step_ps(); }
  std::string_view platform() const override { return engine_->platform(); }
  std::string name() const override { return engine_->name(); }
  double measured_steps_per_s() const override { return engine_->measured_steps_per_s(); }
  std::span<const PlatformRate> measured() const override { return engine_->measured(); }
  std::string push(std::span<const AtomPush> pushes) override { return engine_->push(pushes); }
  std::string setTemperature(double kelvin) override { return engine_->setTemperature(kelvin); }
  std::string advance(int steps) override { return engine_->advance(steps); }
  std::string relax(int iterations) override {
    closing_.iterations += iterations;
    std::string why = engine_->relax(iterations);
    closing_.relaxing = true;
    while (!closing_.closes) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // the window is in the destructor by now
    return why;
  }
  std::string restart() override { return engine_->restart(); }
  std::span<const Vec3> positions_A() override { return engine_->positions_A(); }
  MdEnergies energies() override { return engine_->energies(); }

 private:
  std::unique_ptr<MdEngine> engine_;
  Closing& closing_;
};

}  // namespace

TEST_CASE(
    "a window that closes during a relaxation of 5000 atoms, the most that are simulated, waits for the 50 iterations "
    "of the present slice and not for 500") {
  MdStart start = chainOf(kMaxSimulated);
  auto engine = engineOf(start);
  if (!engine) return;
  Closing closing;
  auto simulation = std::make_unique<SimulationThread>(std::make_unique<Watched>(std::move(engine), closing));
  SimulationCommand wanted;
  wanted.relaxations = 1;
  simulation->command(wanted);
  while (!closing.relaxing) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  closing.closes = true;
  simulation.reset();
  CHECK(closing.iterations == SimulationRun::kRelaxSlice);
}

TEST_CASE(
    "relaxed in slices of 50 iterations the shipped system reaches the minimum of one call of 500: energies within "
    "0.01 "
    "kcal/mol") {
  const MdStart start = shippedSystem();
  auto whole = engineOf(start);
  if (!whole) return;
  const double before = whole->energies().potential_kcal_mol;
  REQUIRE(whole->advance(2000).empty());
  REQUIRE(whole->relax(SimulationRun::kRelaxIterations).empty());
  const double once = whole->energies().potential_kcal_mol;
  auto engine = engineOf(start);
  MdEngine* const sliced = engine.get();
  REQUIRE(sliced->advance(2000).empty());
  SimulationRun run(std::move(engine));
  SimulationCommand wanted;
  wanted.running = false;
  wanted.relaxations = 1;
  int calls = 0;
  do {
    run.advance(wanted, 0.01, 1000);
    ++calls;
  } while (run.relaxing());
  const double parts = sliced->energies().potential_kcal_mol;
  MESSAGE("energy ", before, " kcal/mol, relaxed at once ", once, ", in ", calls, " slices ", parts);
  CHECK(std::abs(parts - once) < 0.01);
}

TEST_CASE(
    "a hand pulls and lets go, the bath changes, the atoms relax and start again: the resident memory of the program "
    "stays within 4 MB of what it is after the first tenth") {
  const char* const minutes = std::getenv("MOLTACT_PULL_MINUTES");
  const double seconds = minutes ? 60.0 * std::atof(minutes) : 5.0;
  std::unique_ptr<MdEngine> engine;
  std::size_t atoms = 22;
  if (const char* const name = std::getenv("MOLTACT_PULL_MOLECULE")) {
    MoleculeKey key;
    key.file = std::string(name) + ".pdb";
    const auto molecule = readMolecule(key);
    REQUIRE(molecule);
    atoms = molecule->atoms.size();
    engine = madeOf(simulationOf(systemBeside(key.file), *molecule, {}));
  } else {
    engine = engineOf(shippedSystem());
  }
  if (!engine) return;
  if (!residentMemory()) {
    MESSAGE("not run: the system does not say how much memory is resident");
    return;
  }
  SimulationThread simulation(std::move(engine));
  SimulationCommand wanted;
  simulation.command(wanted);
  while (simulation.newest().positions_A.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  constexpr std::uint64_t kSeed = 20261127;
  Draws random{kSeed};
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  std::size_t pulls = 0, relaxations = 0, restarts = 0, frames = 0;
  double settled_MB = 0.0, most_MB = 0.0, printed_s = 0.0, farthest_A = 0.0;
  while (elapsed() < seconds) {
    // Takes an atom, moves 6 A in 0.8 s, stays for 0.2 s, and lets go.
    const auto atom = std::size_t(random.uniform(0.0, double(atoms) - 0.001));
    const Vec3 from = simulation.newest().positions_A[atom], way = 6.0 * random.direction();
    ++pulls;
    for (int frame = 0; frame < 50 && elapsed() < seconds; ++frame) {
      const double share = std::min(1.0, frame / 40.0);
      wanted.pushes.assign(1, {std::uint32_t(atom), from + share * way, Vec3(0.0), 5.0});
      simulation.command(wanted);
      const SimulationFrame& now = simulation.newest();
      frames = std::size_t(now.serial);
      if (now.positions_A.size() == atoms)
        farthest_A = std::max(farthest_A, glm::distance(now.positions_A[atom], from));
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    wanted.pushes.clear();
    wanted.temperature_K = random.uniform(250.0, 350.0);
    wanted.ps_per_s = random.uniform(0.5, 3.0);
    if (random.uniform(0.0, 1.0) < 0.2) ++wanted.relaxations, ++relaxations;
    if (random.uniform(0.0, 1.0) < 0.1) ++wanted.restarts, ++restarts;
    simulation.command(wanted);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const double now_MB = residentMemory()->now_MB;
    if (elapsed() < 0.1 * seconds) settled_MB = std::max(settled_MB, now_MB);
    if (settled_MB == 0.0) settled_MB = now_MB;
    most_MB = std::max(most_MB, now_MB);
    if (elapsed() - printed_s >= 60.0) {
      printed_s = elapsed();
      std::printf("%4.0f min %8.2f MB resident, %zu pulls, %zu frames\n", printed_s / 60.0, now_MB, pulls, frames);
      std::fflush(stdout);
    }
  }
  const SimulationFrame& last = simulation.newest();
  MESSAGE("seed ", kSeed, ", ", atoms, " atoms, ", seconds, " s: ", pulls, " pulls, ", relaxations, " relaxations, ",
          restarts, " restarts, ", frames, " frames, ", last.blow_ups, " unstable runs; a pulled atom moved by up to ",
          farthest_A, " A; ", settled_MB, " MB resident after a tenth, at most ", most_MB, " MB");
  CHECK(pulls > 2);
  CHECK(farthest_A > 1.0);
  CHECK(most_MB < settled_MB + 4.0);
}
