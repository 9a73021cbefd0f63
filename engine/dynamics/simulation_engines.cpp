#include "engine/dynamics/simulation_engines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gemmi/elem.hpp>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/dynamics/imd/imd_simulation.h"
#include "engine/dynamics/openmm_engine.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/platform/read_file.h"

namespace moltact {
namespace {

constexpr std::array kEngines{
    SimulationEngine{.name = "OpenMM", .ending = ".xml", .make = &openMMEngine},
    SimulationEngine{.name = "IMD",
                     .scheme = "imd",
                     .programs = "GROMACS, LAMMPS, NAMD, by the protocol IMD",
                     .atom_order = "GROMACS: of the IMD-group",
                     .connect = &ImdSimulation::connect},
};

const SimulationEngine* readerOf(const std::filesystem::path& system) {
  const std::string ending = system.extension().string();
  const auto at = std::find_if(kEngines.begin(), kEngines.end(),
                               [&](const SimulationEngine& e) { return e.make && e.ending == ending; });
  return at == kEngines.end() ? nullptr : &*at;
}

// "OpenMM (.xml)".
std::string fileEngines() {
  std::string out;
  for (const SimulationEngine& e : kEngines)
    if (e.make) out += (out.empty() ? "" : ", ") + std::string(e.name) + " (" + std::string(e.ending) + ")";
  return out;
}

// "imd://HOST:PORT".
std::string addressForms() {
  std::string out;
  for (const SimulationEngine& e : kEngines)
    if (e.connect) out += (out.empty() ? "" : ", ") + std::string(e.scheme) + "://HOST:PORT";
  return out;
}

}  // namespace

std::span<const SimulationEngine> simulationEngines() { return kEngines; }

std::optional<Expected<SimulationAddress>> simulationAddress(std::string_view text) {
  const std::size_t slashes = text.find("://");
  if (slashes == std::string_view::npos) return std::nullopt;
  const std::string_view scheme = text.substr(0, slashes);
  const auto engine = std::find_if(kEngines.begin(), kEngines.end(),
                                   [&](const SimulationEngine& e) { return e.connect && e.scheme == scheme; });
  const std::string remedy = trf("write {0} with a numeric host", addressForms());
  if (engine == kEngines.end())
    return Problem{{}, 0, 0, trf("no engine has addresses that begin with '{0}://'", scheme), remedy};
  auto address = parseTcpAddress(text.substr(slashes + 3));
  if (!address) return Problem{{}, 0, 0, address.problem().message, remedy};
  return SimulationAddress{&*engine, *std::move(address)};
}

Expected<MdStart> readStart(const std::filesystem::path& system, const Molecule& molecule, MdStart start) {
  constexpr std::size_t kLargestSystem = std::size_t(64) << 20;  // bytes
  const std::string name = system.filename().string();
  if (!readerOf(system))
    return Problem{name, 0, 0, tr("no engine reads systems of this ending"), trf("use a file of {0}", fileEngines())};
  const std::size_t count = molecule.atoms.size();
  if (count > kMaxSimulated)
    return Problem{name, 0, 0, trf("the molecule has {0} atoms; at most {1} are simulated", count, kMaxSimulated),
                   tr("take a part of it")};
  Expected<std::string> text = readFile(system, kLargestSystem, tr("take a smaller molecule"));
  if (!text) return text.problem();
  start.system = *std::move(text);
  start.positions_A.clear();
  for (const Sphere& s : molecule.spheres) start.positions_A.push_back(s.centre_A);
  return start;
}

Expected<std::unique_ptr<MdEngine>> simulationOf(const std::filesystem::path& system, const Molecule& molecule,
                                                 MdStart start) {
  const Expected<MdStart> whole = readStart(system, molecule, std::move(start));
  if (!whole) return whole.problem();
  const std::string name = system.filename().string();
  auto engine = readerOf(system)->make(*whole, name);
  if (!engine) return engine;
  if (Problem fault = massFault(molecule, (*engine)->masses_u()); !fault.message.empty()) {
    fault.file = name;
    return fault;
  }
  return engine;
}

std::filesystem::path systemBeside(const std::filesystem::path& molecule_file) {
  std::filesystem::path first;
  std::error_code error;
  for (const SimulationEngine& e : kEngines) {
    if (!e.make) continue;
    std::filesystem::path beside = molecule_file;
    beside.replace_extension(e.ending);
    if (std::filesystem::is_regular_file(beside, error)) return beside;
    if (first.empty()) first = std::move(beside);
  }
  return first;
}

std::vector<double> massesOf(const Molecule& molecule) {
  std::vector<double> out;
  for (const auto& atom : molecule.atoms)
    out.push_back(atom.atomic_number > 0 ? gemmi::Element(atom.atomic_number).weight() : 1.0);
  return out;
}

Problem massFault(const Molecule& molecule, std::span<const double> masses_u) {
  const std::string remedy = tr("use the molecule's file that 'moltact simulate prepare' wrote beside the system");
  const std::size_t count = molecule.atoms.size();
  if (count != masses_u.size())
    return {{}, 0, 0, trf("the system has {0} atoms and the molecule {1}", masses_u.size(), count), remedy};
  constexpr double kHydrogen_u = 1.008, kHeaviest_u = 4.5, kNear_u = 0.1;
  constexpr int kMaxHydrogens = 4;
  double hydrogen_u = 0.0;  // the mass of a hydrogen in this system
  for (std::size_t i = 0; i < count; ++i)
    if (molecule.atoms[i].atomic_number == 1 && masses_u[i] < kHeaviest_u)
      hydrogen_u = std::max(hydrogen_u, masses_u[i]);
  const double given_u = hydrogen_u > kHydrogen_u + kNear_u ? hydrogen_u - kHydrogen_u : 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const int number = molecule.atoms[i].atomic_number;
    if (number == 0) continue;
    bool fits = false;
    if (number == 1) {
      fits = masses_u[i] > kHydrogen_u - kNear_u && masses_u[i] < kHeaviest_u;
    } else {
      const double own = gemmi::Element(number).weight();
      for (int k = 0; k <= (given_u > 0.0 ? kMaxHydrogens : 0) && !fits; ++k)
        fits = std::abs(masses_u[i] - (own - k * given_u)) < kNear_u;
    }
    if (!fits)
      return {{},
              0,
              0,
              trf("atom {0} of the system has a mass of {1} u, but the molecule's is {2}", i + 1,
                  numberText(masses_u[i], decimals(2)), molecule.describe(i)),
              remedy};
  }
  return {};
}

}  // namespace moltact
