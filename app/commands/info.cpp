// moltact info MOLECULE|LESSON|PACK|TRAJECTORY: prints its contents as text or JSON.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <vector>

#include "app/commands/command.h"
#include "app/commands/lesson_info.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/print_json.h"
#include "app/commands/trajectory_info.h"
#include "engine/language/quantity_text.h"
#include "engine/molecule/summary.h"
#include "engine/platform/terminal.h"
#include "engine/structure/amber/pair_atoms.h"
#include "engine/trajectory/trajectory_file.h"

namespace moltact {
namespace {

struct InfoArguments {
  MoleculeArgument molecule;
  bool charges = false, json = false;
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

// Which residues have a note of this kind: by the template, their numbers and chains ("69 A").
using Noted = std::map<std::string, std::vector<std::string>>;
Noted noted(const Molecule& m, const PairAtoms& assigned, PairAtoms::Note::Kind kind) {
  Noted out;
  for (const PairAtoms::Note& n : assigned.notes) {
    if (n.kind != kind) continue;
    if (n.residue == kNoResidue) {
      out["the molecule"];
      continue;
    }
    const Residue& r = m.residues[n.residue];
    const std::string chain(m.chains[r.chain].name);
    std::string name = n.template_name.empty() ? std::string(r.name) : n.template_name;
    if (kind == PairAtoms::Note::Kind::Ligand) name += " (" + std::to_string(n.charge_e) + " e by Gasteiger)";
    if (kind == PairAtoms::Note::Kind::InnerEnd) name += " as within a chain";
    if (n.stated) name += " (by the file)";
    if (kind == PairAtoms::Note::Kind::FractionalCharge)
      name += " (" + quantityNumber(n.residue_charge_e, Dimension::None, decimals(3)) + " e)";
    out[name].push_back(std::to_string(r.number) + (chain.empty() ? "" : " " + chain));
  }
  return out;
}

struct NotedKind {
  PairAtoms::Note::Kind kind;
  const char *label, *key;
};
constexpr NotedKind kNoted[] = {
    {PairAtoms::Note::Kind::Histidine, "histidine ", "histidines"},
    {PairAtoms::Note::Kind::SideChain, "sidechain ", "side_chains"},
    {PairAtoms::Note::Kind::Cysteine, "cysteine  ", "cysteines"},
    {PairAtoms::Note::Kind::Ion, "ions      ", "ions"},
    {PairAtoms::Note::Kind::Terminus, "ends      ", "ends"},
    {PairAtoms::Note::Kind::InnerEnd, "ends      ", "inner_ends"},
    {PairAtoms::Note::Kind::Ligand, "ligand    ", "ligands"},
    {PairAtoms::Note::Kind::NoTemplate, "uncharged ", "no_template"},
    {PairAtoms::Note::Kind::OtherAtoms, "unknown   ", "other_atoms"},
    {PairAtoms::Note::Kind::MissingAtoms, "missing   ", "missing_atoms"},
    {PairAtoms::Note::Kind::FractionalCharge, "not whole ", "fractional_charges"},
    {PairAtoms::Note::Kind::UnknownElement, "no type   ", "unknown_elements"},
    {PairAtoms::Note::Kind::SamePlace, "one place ", "same_places"},
};

void printAssigned(const Molecule& m) {
  const PairAtoms assigned = pairAtoms(m);
  const double net_e = std::round(1e3 * assigned.net_charge_e) / 1e3;
  out() << "net       " << quantityNumber(net_e, Dimension::None, decimals(net_e == std::round(net_e) ? 0 : 3))
        << " e by " << (m.charges_e.empty() ? "AMBER ff14SB, OL15 and OL3" : "the file") << "; "
        << assigned.placed_hydrogens << " polar hydrogens placed\n";
  const double from_whole_e = std::abs(assigned.net_charge_e - std::round(assigned.net_charge_e));
  if (!m.charges_e.empty() && from_whole_e > kFractionalCharge_e)
    out() << "note      the net charge is " << quantityNumber(from_whole_e, Dimension::None, decimals(3))
          << " e from a whole number: the file lacks atoms, or the charges of some; compute the charges of the whole "
             "molecule again (pdb2pqr, obabel --partialcharge)\n";
  const auto any = [&](PairAtoms::Note::Kind kind) {
    return std::any_of(assigned.notes.begin(), assigned.notes.end(), [&](const auto& n) { return n.kind == kind; });
  };
  if (any(PairAtoms::Note::Kind::UnknownElement))
    out()
        << "note      atoms of unknown elements have the size of their radius and carbon's depth, and no charge unless "
           "the file has charges; correct their elements or types in the file\n";
  if (any(PairAtoms::Note::Kind::SamePlace))
    out() << "note      two atoms lie in one place, which makes their forces wrong; remove one of them from the file\n";
  for (const NotedKind& kind : kNoted)
    for (const auto& [name, residues] : noted(m, assigned, kind.kind)) {
      constexpr std::size_t kMax = 12;
      out() << kind.label << name << ':';
      for (std::size_t k = 0; k < std::min(kMax, residues.size()); ++k) out() << (k ? ", " : " ") << residues[k];
      out() << (residues.size() > kMax ? " and " + std::to_string(residues.size() - kMax) + " more" : "") << '\n';
    }
}

nlohmann::ordered_json assignedJson(const Molecule& m) {
  const PairAtoms assigned = pairAtoms(m);
  nlohmann::ordered_json out = {{"net_charge_e", std::round(1e3 * assigned.net_charge_e) / 1e3},
                                {"placed_hydrogens", assigned.placed_hydrogens}};
  for (const NotedKind& kind : kNoted) out[kind.key] = noted(m, assigned, kind.kind);
  return out;
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

void printJson(const Molecule& molecule, const MoleculeSummary& s, bool charges) {
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
  if (charges) json["assigned"] = assignedJson(molecule);
  printDocument(json);
}

void run(const InfoArguments& arguments) {
  if (namesLesson(arguments.molecule.named.name)) return printLessonInfo(arguments.molecule.named.name, arguments.json);
  if (hasTrajectoryName(arguments.molecule.named.name))
    return printTrajectoryInfo(arguments.molecule.named.name, arguments.json);
  const Molecule molecule = arguments.molecule.load();
  const MoleculeSummary summary = summarise(molecule);
  if (arguments.json) return printJson(molecule, summary, arguments.charges);
  printText(molecule, summary);
  if (arguments.charges) printAssigned(molecule);
}

}  // namespace

void addInfo(CLI::App& app) {
  auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command = app.add_subcommand(
      "info",
      "Describe a molecule (atoms, residues, chains, elements, ligands, size), a lesson (.md), a pack (.moltact) or a "
      "trajectory (.dcd, .xtc, .trr, .nc: atoms, frames, times, cell)");
  arguments->molecule.addTo(*command);
  command->add_flag(
      "--charges", arguments->charges,
      "Print the net charge by force field and what it assumes: the protons of histidines and of charged side chains, "
      "cysteines, ends of chains, atoms without parameters");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace moltact
