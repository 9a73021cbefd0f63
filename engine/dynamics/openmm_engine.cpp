#include "engine/dynamics/openmm_engine.h"

#include <cmath>
#include <gemmi/elem.hpp>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/platform/folders.h"
#include "engine/platform/read_file.h"
#include "engine/platform/shared_library.h"

namespace moltact {
namespace {

Expected<MakeMdEngine> loaded() {
  static const Expected<MakeMdEngine> maker = []() -> Expected<MakeMdEngine> {
    std::vector<std::string> names;
    for (const std::filesystem::path& file : moduleFiles("moltact_openmm")) names.push_back(file.string());
    const Expected<SharedLibrary> module = SharedLibrary::open(names);
    if (!module) return module.problem();
    if (void* made = module->symbol(kMakeMdEngine)) return reinterpret_cast<MakeMdEngine>(made);
    return Problem{{}, 0, 0, trf("it has no function {0}", kMakeMdEngine), {}};
  }();
  return maker;
}

}  // namespace

Expected<std::unique_ptr<MdEngine>> openMMEngine(const MdStart& start, const std::string& file) {
  const Expected<MakeMdEngine> make = loaded();
  if (!make)
    return Problem{file, 0, 0, trf("simulations need OpenMM, which cannot be loaded ({0})", make.problem().message),
                   tr("install the package moltact-openmm; a build from the sources needs libopenmm-dev and "
                      "libopenmm-plugins. In a browser and on Windows there are no simulations")};
  std::string why;
  std::unique_ptr<MdEngine> engine((*make)(start, why));
  if (!engine)
    return Problem{file, 0, 0, trf("OpenMM cannot simulate this system: {0}", why),
                   tr("make both files again with 'moltact simulate prepare'")};
  return engine;
}

Expected<std::unique_ptr<MdEngine>> simulationOf(const std::filesystem::path& system, const Molecule& molecule,
                                                 MdStart start) {
  constexpr std::size_t kLargestSystem = std::size_t(64) << 20;  // bytes
  const std::string name = system.filename().string();
  const std::size_t count = molecule.atoms.size();
  if (count > kMaxSimulated)
    return Problem{name, 0, 0, trf("the molecule has {0} atoms; at most {1} are simulated", count, kMaxSimulated),
                   tr("take a part of it")};
  Expected<std::string> text = readFile(system, kLargestSystem, tr("take a smaller molecule"));
  if (!text) return text.problem();
  start.system = *std::move(text);
  start.positions_A.clear();
  for (const Sphere& s : molecule.spheres) start.positions_A.push_back(s.centre_A);
  auto engine = openMMEngine(start, name);
  if (!engine) return engine;
  if (Problem fault = massFault(molecule, (*engine)->masses_u()); !fault.message.empty()) {
    fault.file = name;
    return fault;
  }
  return engine;
}

std::filesystem::path systemBeside(const std::filesystem::path& molecule_file) {
  std::filesystem::path out = molecule_file;
  return out.replace_extension(".xml");
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
  constexpr int kMostHydrogens = 4;
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
      for (int k = 0; k <= (given_u > 0.0 ? kMostHydrogens : 0) && !fits; ++k)
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
