// OpenMM behind our interface, against closed forms: an isolated pair, a pushed atom, the temperature of a bath, the
// conservation of energy. Where OpenMM is not installed the tests say that they did not run.
#include "engine/dynamics/openmm_engine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "engine/dynamics/simulation_engines.h"
#include "engine/dynamics/simulation_thread.h"
#include "engine/platform/folders.h"
#include "engine/platform/read_file.h"
#include "tests/dynamics/shipped_system.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr double kBoltzmann_kcal_mol_K = 0.0019872042586;

// A system without forces but these; masses in dalton.
std::string systemOf(const std::vector<double>& masses, const std::string& forces) {
  std::string out =
      "<?xml version=\"1.0\" ?><System openmmVersion=\"7.7\" type=\"System\" version=\"1\"><PeriodicBoxVectors>"
      "<A x=\"2\" y=\"0\" z=\"0\"/><B x=\"0\" y=\"2\" z=\"0\"/><C x=\"0\" y=\"0\" "
      "z=\"2\"/></PeriodicBoxVectors><Particles>";
  for (const double m : masses) out += "<Particle mass=\"" + std::to_string(m) + "\"/>";
  return out + "</Particles><Constraints/><Forces>" + forces + "</Forces></System>";
}

// A harmonic bond; OpenMM's units: nm, kJ/mol/nm^2.
std::string bond(double length_nm, double k) {
  return "<Force forceGroup=\"0\" type=\"HarmonicBondForce\" usesPeriodic=\"0\" version=\"2\"><Bonds><Bond d=\"" +
         std::to_string(length_nm) + "\" k=\"" + std::to_string(k) + "\" p1=\"0\" p2=\"1\"/></Bonds></Force>";
}

}  // namespace

TEST_CASE(
    "an isolated pair, 12 u and 4 u on a spring of 10 kcal/mol/A^2 stretched by 0.1 A: energy 0.05 kcal/mol, period "
    "2 pi sqrt(m/k) within 0.1 %, and the sum of energies stays within 1e-5 of it") {
  MdStart start;
  start.system = systemOf({12.0, 4.0}, bond(0.15, 4184.0));
  start.positions_A = {Vec3(0.0), Vec3(1.6, 0, 0)};
  start.temperature_K = 0.0;
  start.friction_per_ps = 0.0;
  start.step_ps = 0.0001;
  start.platform = "Reference";
  const auto engine = engineOf(start);
  if (!engine) return;
  CHECK(engine->energies().potential_kcal_mol == doctest::Approx(0.05).epsilon(1e-6));
  const double reduced_u = 12.0 * 4.0 / 16.0, period_ps = kTwoPi * std::sqrt(reduced_u / 4184.0 * 1.0);
  // The bond passes its rest length downward a quarter of a period after the start, then once each period.
  std::vector<double> passes;
  double last = 0.1, greatest = 0.0;
  for (int k = 1; k <= 10000 && passes.size() < 6; ++k) {
    REQUIRE(engine->advance(1).empty());
    const std::span<const Vec3> at = engine->positions_A();
    const double stretch = glm::distance(at[0], at[1]) - 1.5;
    if (last > 0.0 && stretch <= 0.0) passes.push_back((k - stretch / (stretch - last)) * start.step_ps);
    last = stretch;
    const MdEnergies e = engine->energies();
    greatest = std::max(greatest, std::abs(e.potential_kcal_mol + e.kinetic_kcal_mol - 0.05));
  }
  REQUIRE(passes.size() == 6);
  CHECK((passes[5] - passes[0]) / 5.0 == doctest::Approx(period_ps).epsilon(1e-3));
  CHECK(passes[0] == doctest::Approx(0.25 * period_ps).epsilon(0.02));
  MESSAGE("greatest error of the energy, relative: ", greatest / 0.05);
  CHECK(greatest < 0.05 * 1e-5);
  // The centre of mass rests.
  const std::span<const Vec3> at = engine->positions_A();
  CHECK(glm::length((12.0 * at[0] + 4.0 * at[1]) / 16.0 - Vec3(0.4, 0, 0)) < 1e-6);
}

TEST_CASE(
    "an atom pushed by a spring of 8 kcal/mol/A^2 against a bond of 2 comes to rest where both balance, within 0.001 "
    "A: "
    "the force there is the closed form's, and it is gone when the push ends") {
  MdStart start;
  start.system = systemOf({1e9, 12.0}, bond(0.15, 2.0 * 418.4));
  start.positions_A = {Vec3(0.0), Vec3(1.5, 0, 0)};
  start.temperature_K = 0.0;
  start.friction_per_ps = 20.0;
  start.step_ps = 0.002;
  start.platform = "Reference";
  const auto engine = engineOf(start);
  if (!engine) return;
  // The hand's end is 0.5 A farther out: 8 (0.5 - d) = 2 d.
  const AtomPush push = pushOf(1, Vec3(1.5, 0, 0), Vec3(4.0, 0, 0), 8.0);
  CHECK(glm::distance(push.to_A, Vec3(2.0, 0, 0)) < 1e-9);
  REQUIRE(engine->push(std::array{push}).empty());
  REQUIRE(engine->advance(5000).empty());
  CHECK(engine->positions_A()[1].x == doctest::Approx(1.9).epsilon(0.001 / 1.9));
  CHECK(push.force_kcal_mol_A(engine->positions_A()[1]) == doctest::Approx(0.8).epsilon(0.01));
  // The push is not part of the molecule's energy.
  CHECK(engine->energies().potential_kcal_mol == doctest::Approx(0.5 * 2.0 * 0.4 * 0.4).epsilon(0.01));
  REQUIRE(engine->push({}).empty());
  REQUIRE(engine->advance(5000).empty());
  CHECK(engine->positions_A()[1].x == doctest::Approx(1.5).epsilon(0.001 / 1.5));
  // From the other side the spring does not reach the atom.
  REQUIRE(engine->push(std::array{pushOf(1, Vec3(1.3, 0, 0), Vec3(0.8, 0, 0), 8.0)}).empty());
  REQUIRE(engine->advance(5000).empty());
  CHECK(engine->positions_A()[1].x == doctest::Approx(1.5).epsilon(0.001 / 1.5));
}

TEST_CASE(
    "a grip of 6 kcal/mol/A^2 against a bond of 2: the atom rests at 3/4 of the way to the hand on either side of its "
    "rest "
    "and the grip draws it back from the side; in a bath the energy of a free atom in it is 3/2 kT, its variance along "
    "each axis kT/k, and 68 % of its places are within one deviation, all within four of their sampling errors") {
  MdStart start;
  start.system = systemOf({1e9, 12.0}, bond(0.15, 2.0 * 418.4));
  start.positions_A = {Vec3(0.0), Vec3(1.5, 0, 0)};
  start.temperature_K = 0.0;
  start.friction_per_ps = 20.0;
  start.step_ps = 0.002;
  start.platform = "Reference";
  const auto engine = engineOf(start);
  if (!engine) return;
  for (const double hand : {0.4, -0.4}) {
    const AtomPush grip{1, Vec3(1.5 + hand, 0, 0), Vec3(0.0), 6.0};
    REQUIRE(engine->push(std::array{grip}).empty());
    REQUIRE(engine->advance(5000).empty());
    CHECK(engine->positions_A()[1].x == doctest::Approx(1.5 + 0.75 * hand).epsilon(0.001));
    CHECK(grip.force_kcal_mol_A(engine->positions_A()[1]) == doctest::Approx(0.6).epsilon(0.01));
  }
  // The bond has no stiffness across: the atom turns toward the hand.
  REQUIRE(engine->push(std::array{AtomPush{1, Vec3(0, 1.5, 0), Vec3(0.0), 6.0}}).empty());
  REQUIRE(engine->advance(20000).empty());
  CHECK(glm::distance(engine->positions_A()[1], Vec3(0, 1.5, 0)) < 0.01);
  // Boltzmann: a free atom in a grip alone.
  MdStart free = start;
  free.system = systemOf({12.0}, "");
  free.positions_A = {Vec3(0.0)};
  free.temperature_K = 300.0;
  free.friction_per_ps = 10.0;
  free.seed = 3;
  const auto bath = engineOf(free);
  const AtomPush hold{0, Vec3(0.0), Vec3(0.0), 6.0};
  REQUIRE(bath->push(std::array{hold}).empty());
  // The friction of 10/ps decorrelates squares in 0.1 ps. Samples are 0.2 ps apart, whose correlation is below e^-2: of n
  // at least 3 n/4 are independent.
  constexpr int kSamples = 4000;
  double squares_A2[3] = {0.0, 0.0, 0.0};
  int within = 0;
  const double deviation_A = std::sqrt(kBoltzmann_kcal_mol_K * 300.0 / 6.0);
  for (int k = 0; k < kSamples; ++k) {
    REQUIRE(bath->advance(100).empty());
    const Vec3 at = bath->positions_A()[0];
    for (int c = 0; c < 3; ++c) {
      squares_A2[c] += at[c] * at[c] / kSamples;
      within += std::abs(at[c]) < deviation_A;
    }
  }
  const double independent = 0.75 * kSamples, expected = 1.5 * kBoltzmann_kcal_mol_K * 300.0;
  const double energy = 0.5 * 6.0 * (squares_A2[0] + squares_A2[1] + squares_A2[2]);
  MESSAGE("seed ", free.seed, ": mean energy of the grip ", energy, " kcal/mol, 3/2 kT is ", expected,
          "; variances over kT/k ", squares_A2[0] / (deviation_A * deviation_A), ", ",
          squares_A2[1] / (deviation_A * deviation_A), ", ", squares_A2[2] / (deviation_A * deviation_A), "; ",
          within / (3.0 * kSamples), " within one deviation");
  CHECK(std::abs(energy / expected - 1.0) < 4.0 * std::sqrt(2.0 / (3.0 * independent)));
  for (const double square : squares_A2)
    CHECK(std::abs(square / (deviation_A * deviation_A) - 1.0) < 4.0 * std::sqrt(2.0 / independent));
  // A normal distribution has erf(1/sqrt 2) of its values there.
  const double share = std::erf(std::sqrt(0.5));
  CHECK(std::abs(within / (3.0 * kSamples) - share) < 4.0 * std::sqrt(share * (1.0 - share) / (3.0 * independent)));
}

TEST_CASE("the centre of mass is held: pushed with 2 kcal/mol/A, a free atom of 12 u held by 5 moves by 0.4 A") {
  MdStart start;
  start.system = systemOf({12.0}, "");
  start.positions_A = {Vec3(1, 2, 3)};
  start.temperature_K = 0.0;
  start.friction_per_ps = 20.0;
  start.step_ps = 0.002;
  start.hold_kcal_mol_A2 = 5.0;
  start.platform = "Reference";
  const auto engine = engineOf(start);
  if (!engine) return;
  // A weak spring with a far end is nearly a constant force: 0.01 (200 - 0.4) = 1.996.
  REQUIRE(engine->push(std::array{pushOf(0, Vec3(1, 2, 3), Vec3(0, 0, 2.0), 0.01)}).empty());
  REQUIRE(engine->advance(5000).empty());
  CHECK(glm::distance(engine->positions_A()[0], Vec3(1, 2, 3 + 2.0 / 5.01)) < 0.002);
}

TEST_CASE("equipartition: alanine dipeptide in a bath of 300 K has 300 K within four of its sampling errors") {
  MdStart start = shippedSystem();
  start.seed = 20261126;
  MESSAGE("seed ", start.seed);
  const auto engine = engineOf(start);
  if (!engine) return;
  CHECK(engine->step_ps() == 0.004);
  REQUIRE(engine->relax(200).empty());
  REQUIRE(engine->advance(5000).empty());
  constexpr int kSamples = 2000, kApart = 50;
  double sum = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    REQUIRE(engine->advance(kApart).empty());
    sum += engine->energies().temperature_K;
  }
  // 22 atoms and 12 rigid bonds: 54 degrees of freedom. The kinetic energy has a relative variance of 2/54; the
  // friction of 2/ps decorrelates it in about 1/4 ps, samples are 0.2 ps apart: at least half of them are independent.
  const double error_K = 300.0 * std::sqrt(2.0 / 54.0 / (0.25 * kSamples));
  const double mean = sum / kSamples;
  MESSAGE("mean temperature ", mean, " K, sampling error ", error_K, " K");
  CHECK(std::abs(mean - 300.0) < 4.0 * error_K);
}

TEST_CASE(
    "without a bath the shipped system conserves its energy: 19 ps at 1 fs drift by less than 0.02 kcal/mol, a "
    "thousandth of its heat") {
  MdStart start = shippedSystem();
  start.friction_per_ps = 0.0;
  const double heat = 54 * 0.5 * kBoltzmann_kcal_mol_K * 300.0;
  // The drift of the mean over `window_ps` from one such window to the next one `ps` later, in kcal/mol.
  const auto drift = [&](double step_ps, double ps, double window_ps) -> std::optional<double> {
    start.step_ps = step_ps;
    const auto engine = engineOf(start);
    if (!engine) return std::nullopt;
    const auto steps = [&](double of_ps) { return int(std::lround(of_ps / step_ps)); };
    REQUIRE(engine->relax(200).empty());
    REQUIRE(engine->advance(steps(1.0)).empty());
    const auto total = [&] {
      const int samples = int(std::lround(window_ps / 0.01));
      double out = 0.0;
      for (int k = 0; k < samples; ++k) {
        REQUIRE(engine->advance(steps(0.01)).empty());
        const MdEnergies e = engine->energies();
        out += (e.potential_kcal_mol + e.kinetic_kcal_mol) / samples;
      }
      return out;
    };
    const double before = total();
    REQUIRE(engine->advance(steps(ps - window_ps)).empty());
    return total() - before;
  };
  const auto brief = drift(0.001, 19.0, 1.0);
  if (!brief) return;
  MESSAGE("drift ", *brief, " kcal/mol in 19 ps at 1 fs, of ", heat, " kcal/mol of heat");
  CHECK(std::abs(*brief) < 0.02);
}

TEST_CASE(
    "the platform that is chosen at the start is the fastest by the steps per second that the engine measured of each, "
    "and makes at least a third of the steps of any other in a measurement of this test") {
  const MdStart start = shippedSystem();
  MdStart any = start;
  any.platform.clear();
  const auto chosen = engineOf(any);
  if (!chosen) return;
  const auto measured = chosen->measured();
  REQUIRE_FALSE(measured.empty());
  const auto fastest = std::max_element(measured.begin(), measured.end(),
                                        [](const auto& a, const auto& b) { return a.steps_per_s < b.steps_per_s; });
  CHECK(fastest->platform == chosen->platform());
  CHECK(fastest->steps_per_s == chosen->measured_steps_per_s());
  CHECK(chosen->measured_steps_per_s() > 0.0);
  // The best of three times 0.1 s.
  const auto rateOf = [](MdEngine& engine) {
    using Clock = std::chrono::steady_clock;
    double best = 0.0;
    for (int k = 0; k < 3; ++k) {
      const auto began = Clock::now();
      int steps = 0;
      double took_s = 0.0;
      for (; took_s < 0.1; steps += 10) {
        REQUIRE(engine.advance(10).empty());
        engine.positions_A();
        took_s = std::chrono::duration<double>(Clock::now() - began).count();
      }
      best = std::max(best, steps / took_s);
    }
    return best;
  };
  const double rate = rateOf(*chosen);
  for (const char* platform : {"Reference", "CPU", "OpenCL", "CUDA"}) {
    MdStart named = start;
    named.platform = platform;
    auto other = openMMEngine(named, "test.xml");
    const auto found =
        std::find_if(measured.begin(), measured.end(), [&](const auto& m) { return m.platform == platform; });
    CHECK(bool(other) == (found != measured.end()));
    if (!other) continue;  // not installed, or no such card
    CHECK((*other)->measured().empty());
    CHECK((*other)->measured_steps_per_s() == 0.0);
    const double others = rateOf(**other);
    MESSAGE(platform, ": ", found->steps_per_s, " steps per second measured at the start, ", others, " here; ", rate,
            " of the chosen one, ", chosen->platform());
    CHECK(rate > others / 3.0);
  }
}

TEST_CASE("the same seed gives the same atoms to the last bit, another seed others; a restart begins again") {
  MdStart start = shippedSystem();
  const auto ends = [&](std::uint32_t seed) -> std::optional<Vec3> {
    start.seed = seed;
    const auto engine = engineOf(start);
    if (!engine) return std::nullopt;
    REQUIRE(engine->advance(200).empty());
    return engine->positions_A()[3];
  };
  const auto first = ends(5);
  if (!first) return;
  CHECK(*ends(5) == *first);
  CHECK(glm::distance(*ends(6), *first) > 1e-3);
  const auto engine = engineOf(start);
  REQUIRE(engine->advance(100).empty());
  REQUIRE(engine->restart().empty());
  for (std::size_t i = 0; i < start.positions_A.size(); ++i)
    CHECK(glm::distance(engine->positions_A()[i], start.positions_A[i]) <
          0.01);  // the rigid bonds' lengths are restored
}

TEST_CASE("steps ten times too long blow the shipped system up: the run says so, and starts again from finite places") {
  MdStart start = shippedSystem();
  start.step_ps = 0.04;
  auto engine = engineOf(start);
  if (!engine) return;
  SimulationRun run(std::move(engine));
  SimulationCommand wanted;
  wanted.ps_per_s = 100.0;
  SimulationFrame frame;
  for (int k = 0; k < 50 && frame.blow_ups == 0; ++k) frame = run.advance(wanted, 0.02, 10000);
  CHECK(frame.blow_ups == 1);
  CHECK_FALSE(frame.dead);
  for (const Vec3& v : frame.positions_A) CHECK(finite(v));
}

TEST_CASE("a simulation on its own thread: pushed atoms follow a command, and closing it ends the thread") {
  MdStart start = shippedSystem();
  auto engine = engineOf(start);
  if (!engine) return;
  SimulationThread thread(std::move(engine));
  SimulationCommand wanted;
  wanted.relaxations = 1;
  thread.command(wanted);
  std::uint64_t serial = 0;
  const auto waitFor = [&](auto&& holds) {
    for (int k = 0; k < 3000; ++k) {
      const SimulationFrame& frame = thread.newest();
      serial = std::max(serial, frame.serial);
      if (holds(frame)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  };
  CHECK(waitFor([](const SimulationFrame& f) { return f.starts == 1 && f.time_ps > 0.01; }));
  wanted.running = false;
  thread.command(wanted);
  CHECK(waitFor([&](const SimulationFrame& f) { return f.ps_per_s == 0.0 && f.starts == 1; }));
}

TEST_CASE("what cannot be simulated is a problem with its remedy: no XML, another number of atoms, no such platform") {
  MdStart start = shippedSystem();
  if (!engineOf(start)) return;
  const auto problem = [&](const MdStart& s) {
    const auto made = openMMEngine(s, "x.xml");
    REQUIRE_FALSE(made);
    CHECK(made.problem().file == "x.xml");
    CHECK_FALSE(made.problem().remedy.empty());
    return made.problem().message;
  };
  MdStart fewer = start;
  fewer.positions_A.pop_back();
  CHECK(problem(fewer) == "OpenMM cannot simulate this system: the system has 22 particles, not 21");
  for (const char* text : {"", "no system", "<System", "<?xml version=\"1.0\" ?><Integrator type=\"x\"/>"}) {
    MdStart broken = start;
    broken.system = text;
    CHECK(problem(broken).starts_with("OpenMM cannot simulate this system: "));
  }
  MdStart elsewhere = start;
  elsewhere.platform = "Abacus";
  CHECK(problem(elsewhere).find("Abacus") != std::string::npos);
}

TEST_CASE("masses tell whether the atoms are the molecule's: the shipped ones fit, two exchanged atoms do not") {
  const Molecule molecule = libraryMolecule("alanine-dipeptide.pdb");
  // Of the shipped system: hydrogens of 4 u, whose neighbours are lighter by 2.992 u for each.
  std::vector<double> masses;
  for (const double m : {3.034, 4.0, 4.0, 4.0,   12.01, 16.0,   11.018, 4.0,   9.018, 4.0, 3.034,
                         4.0,   4.0, 4.0, 12.01, 16.0,  11.018, 4.0,    3.034, 4.0,   4.0, 4.0})
    masses.push_back(m);
  CHECK(massFault(molecule, masses).message.empty());
  std::swap(masses[4], masses[5]);
  CHECK(massFault(molecule, masses).message ==
        "atom 5 of the system has a mass of 16.00 u, but the molecule's is C of acetyl cap 1 (chain A)");
  std::swap(masses[4], masses[5]);
  std::swap(masses[7], masses[8]);
  CHECK(massFault(molecule, masses).message.starts_with("atom 8 of the system"));
  masses.pop_back();
  CHECK(massFault(molecule, masses).message == "the system has 21 atoms and the molecule 22");
}
