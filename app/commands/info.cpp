// moltact info MOLECULE|LESSON|PACK: prints its contents as text or JSON.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "app/commands/command.h"
#include "app/commands/lesson_info.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/print_json.h"
#include "engine/language/quantity_text.h"
#include "engine/molecule/summary.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

struct InfoArguments {
  MoleculeArgument molecule;
  bool json = false;
};

std::string listed(const std::map<std::string, std::size_t>& counts) {
  std::string out;
  for (const auto& [name, count] : counts) out += (out.empty() ? "" : ", ") + name + ' ' + std::to_string(count);
  return out.empty() ? "none" : out;
}

std::string named(const std::vector<std::string>& chains) {
  constexpr std::size_t kMax = 40;
  std::string out;
  for (std::size_t i = 0; i < std::min(kMax, chains.size()); ++i)
    out += (i ? " " : "") + (chains[i].empty() ? "(no name)" : chains[i]);
  return chains.size() > kMax ? out + " ..." : out;
}

double netCharge_e(const Molecule& molecule) {
  const double sum = std::accumulate(molecule.charges_e.begin(), molecule.charges_e.end(), 0.0);
  return std::round(1e4 * sum) / 1e4;  // files have four decimals
}

void printText(const Molecule& molecule, const MoleculeSummary& s) {
  const Vec3 size = s.high_A - s.low_A;
  out() << molecule.id << (molecule.title.empty() ? "" : ": " + molecule.title) << '\n';
  out() << "atoms     " << s.atoms << '\n';
  out() << "residues  " << s.residues << (s.waters ? " (" + std::to_string(s.waters) + " water)" : "") << '\n';
  out() << "chains    " << s.chains << (s.chains ? " (" + named(s.chain_names) + ")" : "") << '\n';
  out() << "elements  " << listed(s.elements) << '\n';
  out() << "ligands   " << listed(s.ligands) << '\n';
  out() << "size      " << quantityNumber(size.x, Dimension::Length, decimals(1)) << " x "
        << quantityNumber(size.y, Dimension::Length, decimals(1)) << " x "
        << quantityText(size.z, Dimension::Length, decimals(1)) << '\n';
  if (!molecule.charges_e.empty())
    out() << "charge    " << quantityNumber(netCharge_e(molecule), Dimension::None, decimals(3)) << " e\n";
  for (const std::string& warning : molecule.warnings) out() << "note      " << warning << '\n';
}

std::vector<double> list(Vec3 v) { return {v.x, v.y, v.z}; }

void printJson(const Molecule& molecule, const MoleculeSummary& s) {
  nlohmann::ordered_json json = {
      {"id", molecule.id},
      {"title", molecule.title},
      {"atoms", s.atoms},
      {"residues", s.residues},
      {"chains", s.chains},
      {"chain_names", s.chain_names},
      {"elements", s.elements},
      {"ligands", s.ligands},
      {"waters", s.waters},
      {"waters_left_out", s.waters_left_out},
      {"alternates_left_out", s.alternates_left_out},
      {"models", s.models},
      {"size_A", list(s.high_A - s.low_A)},
      {"low_A", list(s.low_A)},
      {"high_A", list(s.high_A)},
      {"warnings", molecule.warnings},
  };
  if (!molecule.charges_e.empty()) json["charge_e"] = netCharge_e(molecule);
  printDocument(json);
}

void run(const InfoArguments& arguments) {
  if (namesLesson(arguments.molecule.named.name)) return printLessonInfo(arguments.molecule.named.name, arguments.json);
  const Molecule molecule = arguments.molecule.load();
  const MoleculeSummary summary = summarise(molecule);
  arguments.json ? printJson(molecule, summary) : printText(molecule, summary);
}

}  // namespace

void addInfo(CLI::App& app) {
  auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command = app.add_subcommand(
      "info",
      "Describe a molecule (atoms, residues, chains, elements, ligands, size), a lesson (.md) or a pack (.moltact)");
  arguments->molecule.addTo(*command);
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace moltact
