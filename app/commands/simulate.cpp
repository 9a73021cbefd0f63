// moltact simulate prepare MOLECULE: makes the system of a molecule with OpenMM's Python layer.
// moltact simulate run MOLECULE: simulates it without a window, and measures.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/number_range.h"
#include "app/commands/outputs.h"
#include "app/commands/simulate_gromacs.h"
#include "app/commands/value_types.h"
#include "engine/dynamics/simulation_engines.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/platform/folders.h"
#include "engine/platform/interrupt.h"
#include "engine/platform/read_file.h"
#include "engine/platform/run_program.h"
#include "engine/platform/temporary_folder.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct PrepareArguments {
  std::string molecule, out, solvent = "none";
};

// The first Python that has OpenMM. Debian's modules belong to its own Python, which need not be the first in the path.
std::string pythonWithOpenMM() {
  for (const char* python : {"/usr/bin/python3", "python3"})
    if (const auto run = runProgram({python, "-c", "import openmm"}, true); run && run->status == 0) return python;
  throw CommandError{
      tr("preparing a molecule needs the Python module openmm, which no python3 here has; install the package "
         "python3-simtk (Debian 12) or python3-openmm (Debian 13)")};
}

void prepare(const PrepareArguments& a) {
  const auto key = findMoleculeKey({a.molecule}, MoleculeFolders::ofThisComputer());
  if (!key) throw CommandError{key.problem().text()};
  const std::string ending = key->file.extension().string();
  if (ending != ".pdb" && ending != ".cif")
    throw CommandError{
        trf("{0} is not a PDB or mmCIF file, which OpenMM reads; unpack or convert it", key->file.filename().string())};
  // "protein.pdb" gives "protein-simulated.xml" beside it, or in the working folder for a molecule of the library.
  fs::path xml = a.out.empty() ? fs::path(key->file.stem().string() + "-simulated.xml") : fs::path(a.out);
  if (xml.extension() != ".xml") throw CLI::ValidationError("--out", "its name ends in .xml");
  fs::path pdb = xml;
  pdb.replace_extension(".pdb");
  const std::string python = pythonWithOpenMM();
  auto scratch = TemporaryFolder::in(fs::temp_directory_path(), "moltact-simulate-");
  if (!scratch) throw CommandError{scratch.problem().text()};
  const fs::path made_xml = scratch->path() / "system.xml", made_pdb = scratch->path() / "atoms.pdb";
  showStatus(tr("OpenMM adds hydrogens and finds a minimum of the energy"));
  std::error_code error;
  const auto run =
      runProgram({python, (assetsFolder() / "simulate" / "prepare.py").string(),
                  fs::absolute(key->file, error).string(), made_xml.string(), made_pdb.string(), a.solvent});
  showStatus({});
  if (!run) throw CommandError{run.problem().text()};
  const auto answer = nlohmann::json::parse(run->output, nullptr, false);
  if (answer.is_object() && answer.contains("fault") && answer["fault"].is_string())
    throw CommandError{
        trf("{0} cannot be prepared: {1}", key->file.filename().string(), answer["fault"].get<std::string>())};
  if (run->status != 0 || !answer.is_object() || !answer.contains("atoms"))
    throw CommandError{trf("OpenMM's Python ended with status {0}", run->status)};
  const auto bytesOf = [](const fs::path& file) {
    auto bytes = readFile(file, std::size_t(256) << 20, tr("take a smaller molecule"));
    if (!bytes) throw CommandError{bytes.problem().text()};
    return *std::move(bytes);
  };
  const std::string system = bytesOf(made_xml);
  const std::string atoms = "TITLE     " + key->file.stem().string().substr(0, 60) +
                            "\nREMARK   1 HYDROGENS AND MINIMUM OF THE ENERGY: MOLTACT SIMULATE PREPARE\n" +
                            bytesOf(made_pdb);
  checkOutputs({{"--out", xml}, {"--out", pdb}});
  for (const auto& [file, bytes] : {std::pair(xml, system), std::pair(pdb, atoms)})
    if (const auto problem = writeWhole(file, bytes)) throw CommandError{problem->text()};
  out() << xml.string() << ", " << pdb.string() << ": " << answer["atoms"].get<int>() << " atoms, "
        << std::lround(answer.value("energy_kcal_mol", 0.0))
        << " kcal/mol\nIn a scene: molecule: " << pdb.filename().string()
        << " and simulation: " << xml.filename().string() << '\n';
}

struct RunArguments {
  std::string molecule, platform;
  double ps = 10.0, kelvin = MdStart().temperature_K;
  std::uint32_t seed = 1;
  bool no_bath = false;
  double step_fs = 0.0;
};

// The slope of the straight line of least squares through values at equal distances, per distance.
double slopeOf(const std::vector<double>& values) {
  const double n = double(values.size()), middle = 0.5 * (n - 1.0);
  double sum = 0.0, squares = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    sum += (double(k) - middle) * values[k];
    squares += (double(k) - middle) * (double(k) - middle);
  }
  return squares > 0.0 ? sum / squares : 0.0;
}

void simulate(const RunArguments& a) {
  const auto key = findMoleculeKey({a.molecule}, MoleculeFolders::ofThisComputer());
  if (!key) throw CommandError{key.problem().text()};
  const auto molecule = readMolecule(*key);
  if (!molecule) throw CommandError{molecule.problem().text()};
  MdStart start;
  start.platform = a.platform;
  start.temperature_K = a.kelvin;
  start.seed = a.seed;
  start.step_ps = 1e-3 * a.step_fs;
  if (a.no_bath) start.friction_per_ps = 0.0;
  const auto engine = simulationOf(systemBeside(key->file), *molecule, start);
  if (!engine) throw CommandError{engine.problem().text()};
  MdEngine& md = **engine;
  const InterruptWatch interrupt;
  constexpr int kRows = 10, kParts = 10;  // the energy is read kParts times between two rows
  const int steps = int(std::ceil(a.ps / kRows / kParts / md.step_ps()));
  out() << md.atomCount() << " atoms, " << std::string(md.platform()) << ", steps of " << 1000.0 * md.step_ps()
        << " fs\n";
  {
    char line[96];
    std::snprintf(line, sizeof line, "at the start %.9g kcal/mol potential", md.energies().potential_kcal_mol);
    out() << line << '\n';
  }
  std::vector<double> total_kcal_mol;
  double kinetic_kcal_mol = 0.0;
  const auto began = std::chrono::steady_clock::now();
  for (int part = 1; part <= kRows * kParts && !interrupt.seen(); ++part) {
    if (const std::string why = md.advance(steps); !why.empty())
      throw CommandError{trf("the simulation became unstable ({0})", why)};
    const MdEnergies e = md.energies();
    total_kcal_mol.push_back(e.potential_kcal_mol + e.kinetic_kcal_mol);
    kinetic_kcal_mol += e.kinetic_kcal_mol;
    if (part % kParts) continue;
    char line[128];
    std::snprintf(line, sizeof line, "%9.2f ps %12.2f kcal/mol potential %10.2f kinetic %8.1f K",
                  part * steps * md.step_ps(), e.potential_kcal_mol, e.kinetic_kcal_mol, e.temperature_K);
    out() << line << '\n';
  }
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const double made = double(total_kcal_mol.size()) * steps;
  out() << std::lround(made / std::max(took_s, 1e-9)) << " steps per second\n";
  if (!a.no_bath || total_kcal_mol.size() < 2) return;
  const double drift = slopeOf(total_kcal_mol) / (steps * md.step_ps()) * 1000.0;
  char line[160];
  std::snprintf(line, sizeof line, "drift of the total energy: %.2g kcal/mol per ns, %.2g of the mean kinetic energy",
                drift, drift / std::max(kinetic_kcal_mol / double(total_kcal_mol.size()), 1e-9));
  out() << line << '\n';
}

}  // namespace

void addSimulate(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("simulate", "Prepare a molecule for a simulation that the hand pushes, or run one");
  command->require_subcommand(1);

  auto preparing = std::make_shared<PrepareArguments>();
  CLI::App* prepares = command->add_subcommand(
      "prepare",
      "Make the system of a protein or nucleic acid (needs OpenMM's Python layer): adds hydrogens, drops water");
  prepares->add_option("molecule", preparing->molecule, "A PDB or mmCIF file, or a molecule of the library (1ubq)")
      ->type_name(kMoleculeType)
      ->required();
  prepares
      ->add_option("--out", preparing->out,
                   "The file of the system; the molecule goes beside it as .pdb (default: NAME-simulated.xml)")
      ->type_name(kFileType);
  prepares
      ->add_option("--solvent", preparing->solvent,
                   "none: amber14 in a vacuum with friction; obc: amber99sb-ildn with implicit water, for up to about "
                   "100 atoms")
      ->check(CLI::IsMember({"none", "obc"}))
      ->capture_default_str();
  prepares->callback([preparing] { prepare(*preparing); });

  auto running = std::make_shared<RunArguments>();
  CLI::App* runs =
      command->add_subcommand("run", "Simulate a prepared molecule without a window, and print its energies");
  runs->add_option("molecule", running->molecule, "A molecule beside whose file the .xml of the same name lies")
      ->type_name(kMoleculeType)
      ->required();
  runs->add_option("--ps", running->ps, "Simulated time in picoseconds")
      ->check(numberFrom(0.1, 1e5))
      ->capture_default_str();
  runs->add_option("--kelvin", running->kelvin, "Temperature of the heat bath")
      ->check(numberFrom(1.0, 1000.0))
      ->capture_default_str();
  runs->add_option("--seed", running->seed, "Seed of the heat bath")->capture_default_str();
  runs->add_flag("--no-bath", running->no_bath, "No heat bath: the energy is conserved, and its drift is printed");
  runs->add_option("--fs", running->step_fs, "Time step in femtoseconds (default: the longest stable one)")
      ->check(numberFrom(0.1, 5.0));
  runs->add_option("--platform", running->platform, "OpenMM's platform: Reference, CPU, OpenCL (default: the fastest)");
  runs->callback([running] { simulate(*running); });

  addSimulateGromacs(*command);
}

}  // namespace moltact
