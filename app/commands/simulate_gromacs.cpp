// moltact simulate gromacs MOLECULE: prepares a small run with GROMACS and starts it as a server for `moltact imd`.
#include "app/commands/simulate_gromacs.h"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/command.h"
#include "app/commands/number_range.h"
#include "app/commands/outputs.h"
#include "app/commands/value_types.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/catalogue.h"
#include "engine/platform/folders.h"
#include "engine/platform/read_file.h"
#include "engine/platform/run_program.h"
#include "engine/platform/temporary_folder.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct GromacsArguments {
  std::string molecule, out;
  int port = 8888;
  bool prepares_only = false;
};

// A vacuum, in which a reaction field without a limit is a plain cut-off at 12 A.
constexpr const char* kForces =
    "cutoff-scheme = Verlet\ncoulombtype = Reaction-Field\nepsilon-rf = 0\nrcoulomb = 1.2\nrvdw = 1.2\n";
constexpr const char* kMinimum = "integrator = steep\nnsteps = 500\nemtol = 100\n";
constexpr const char* kRun =
    "integrator = sd\ndt = 0.002\nnsteps = -1\ntc-grps = System\ntau-t = 0.5\nref-t = 300\ngen-vel = yes\n"
    "gen-temp = 300\nconstraints = h-bonds\ncomm-mode = Linear\nnstenergy = 0\nnstlog = 0\nIMD-group = System\n";

// One step of the preparation. After a failure it runs again, so that GROMACS's own message is seen.
void gromacsStep(std::vector<std::string> words) {
  words.insert(words.begin(), "gmx");
  const auto run = runProgram(words, true);
  if (!run) throw CommandError{run.problem().text()};
  if (run->status == 0) return;
  runProgram(words, false);
  throw CommandError{trf("gmx {0} ended with status {1}; its message is above", words[1], run->status)};
}

void simulateWithGromacs(const GromacsArguments& a) {
  const auto key = findMoleculeKey({a.molecule}, MoleculeFolders::ofThisComputer());
  if (!key) throw CommandError{key.problem().text()};
  if (key->file.extension() != ".pdb")
    throw CommandError{
        trf("{0} is not a PDB file, which GROMACS reads; unpack or convert it", key->file.filename().string())};
  const fs::path gro = a.out.empty() ? fs::path(key->file.stem().string() + "-gromacs.gro") : fs::path(a.out);
  if (gro.extension() != ".gro") throw CLI::ValidationError("--out", "its name ends in .gro");
  fs::path tpr = gro;
  tpr.replace_extension(".tpr");
  if (const auto run = runProgram({"gmx", "--version"}, true); !run || run->status != 0)
    throw CommandError{tr("this needs GROMACS, whose program gmx is not there; install the package gromacs")};
  auto scratch = TemporaryFolder::in(fs::temp_directory_path(), "moltact-gromacs-");
  if (!scratch) throw CommandError{scratch.problem().text()};
  const auto in = [&](const char* name) { return (scratch->path() / name).string(); };
  for (const auto& [name, text] : {std::pair("minimum.mdp", kMinimum), std::pair("run.mdp", kRun)})
    if (const auto problem = writeWhole(in(name), std::string(text) + kForces)) throw CommandError{problem->text()};
  showStatus(tr("GROMACS adds hydrogens and finds a minimum of the energy"));
  std::error_code error;
  gromacsStep({"pdb2gmx", "-f", fs::absolute(key->file, error).string(), "-ff", "amber99sb-ildn", "-water", "none",
               "-ignh", "-o", in("whole.gro"), "-p", in("topol.top"), "-i", in("posre.itp")});
  gromacsStep({"editconf", "-f", in("whole.gro"), "-d", "1.5", "-c", "-o", in("box.gro")});
  gromacsStep({"grompp", "-f", in("minimum.mdp"), "-c", in("box.gro"), "-p", in("topol.top"), "-po", in("out.mdp"),
               "-o", in("minimum.tpr"), "-maxwarn", "5"});
  gromacsStep({"mdrun", "-nt", "1", "-s", in("minimum.tpr"), "-deffnm", in("minimum")});
  gromacsStep({"grompp", "-f", in("run.mdp"), "-c", in("minimum.gro"), "-p", in("topol.top"), "-po", in("out.mdp"),
               "-imd", in("group.gro"), "-o", in("run.tpr"), "-maxwarn", "5"});
  showStatus({});
  checkOutputs({{"--out", gro}, {"--out", tpr}});
  for (const auto& [from, to] : {std::pair("group.gro", gro), std::pair("run.tpr", tpr)}) {
    const auto bytes = readFile(in(from), std::size_t(256) << 20, tr("take a smaller molecule"));
    if (!bytes) throw CommandError{bytes.problem().text()};
    if (const auto problem = writeWhole(to, *bytes)) throw CommandError{problem->text()};
  }
  const std::string port = std::to_string(a.port);
  out() << gro.string() << ", " << tpr.string() << '\n';
  if (a.prepares_only) return;
  out() << "Connect to it from another terminal: moltact imd " << port << ' ' << gro.string() << "\nCtrl-C ends it.\n";
  out().flush();
  const auto run =
      runProgram({"gmx", "mdrun", "-s", tpr.string(), "-deffnm", in("run"), "-imdport", port, "-imdwait", "-imdpull"});
  if (!run) throw CommandError{run.problem().text()};
  if (run->status != 0)
    throw CommandError{trf("gmx {0} ended with status {1}; its message is above", "mdrun", run->status)};
}

}  // namespace

void addSimulateGromacs(CLI::App& simulate) {
  auto given = std::make_shared<GromacsArguments>();
  CLI::App* command = simulate.add_subcommand(
      "gromacs", "Prepare a small run of GROMACS in a vacuum, and start it as a server for `moltact imd`");
  command->add_option("molecule", given->molecule, "A PDB file, or a molecule of the library (1ubq)")
      ->type_name(kMoleculeType)
      ->required();
  command
      ->add_option("--out", given->out,
                   "The structure for `moltact imd`; the run goes beside it as .tpr (default: NAME-gromacs.gro)")
      ->type_name(kFileType);
  command->add_option("--port", given->port, "The port on which GROMACS listens")
      ->check(numberFrom(1024, 65535))
      ->capture_default_str();
  command->add_flag("--prepare-only", given->prepares_only, "Write the files, and start nothing");
  command->callback([given] { simulateWithGromacs(*given); });
}

}  // namespace moltact
