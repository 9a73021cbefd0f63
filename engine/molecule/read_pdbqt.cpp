// Reads PDBQT, the format of AutoDock: lines of a PDB file with the atom's partial charge in columns 71-76 and its
// AutoDock type from column 78 on. ROOT, BRANCH and TORSDOF, which say what turns, are ignored.
#include <algorithm>
#include <charconv>
#include <gemmi/elem.hpp>

#include "engine/language/catalogue.h"
#include "engine/molecule/element_of_name.h"
#include "engine/molecule/parsed_structure.h"

namespace moltact {
namespace {

constexpr const char* kPdbqtRemedy = N_(
    "PDBQT has x, y, z in columns 31-54, the charge in 71-76 and the type from 78 on; correct the line, or write the "
    "file anew (obabel, prepare_receptor)");

struct DockElement {
  std::string_view type, symbol;
};
// AutoDock's types that are not the symbol of their element. NA is nitrogen that accepts a hydrogen bond; sodium is Na. W is
// the water molecule of hydrated docking.
constexpr DockElement kDockElements[] = {
    {"A", "C"},  {"NA", "N"}, {"NS", "N"}, {"NX", "N"}, {"OA", "O"}, {"OS", "O"},  {"OX", "O"},
    {"SA", "S"}, {"HD", "H"}, {"HS", "H"}, {"HN", "H"}, {"W", "O"},  {"CL", "Cl"}, {"BR", "Br"},
};

/// The element of an AutoDock type; 0 if it is unknown.
int elementOfDockType(std::string_view type) {
  for (const DockElement& known : kDockElements)
    if (known.type == type) return gemmi::Element(std::string(known.symbol)).atomic_number();
  // CG0, CG1, ...: carbons at which a ring was opened.
  if (type.size() >= 2 && type.starts_with("CG")) return gemmi::Element("C").atomic_number();
  return type.empty() || type.size() > 2 ? 0 : gemmi::Element(std::string(type)).atomic_number();
}

/// G0, G1, ...: points that hold an opened ring together.
bool isGlue(std::string_view type) { return type.size() >= 2 && type[0] == 'G' && type[1] >= '0' && type[1] <= '9'; }

std::optional<Problem> pdbqtAtom(std::string_view line, const std::string& file, std::size_t number, ParsedAtom& atom) {
  const auto bad = [&](std::size_t column, std::string what) {
    return Problem{file, number, column, std::move(what), tr(kPdbqtRemedy)};
  };
  if (line.size() < 54) return bad(line.size() + 1, tr("the atom's line ends before its coordinates do"));
  if (line.size() < 78) return bad(line.size() + 1, tr("the atom's line ends before its charge and type do"));
  for (int k = 0; k < 3; ++k) {
    const std::size_t at = 30 + 8 * std::size_t(k);
    if (!parseNumber(line.substr(at, 8), atom.position_A[k]))
      return bad(at + 1, trf("{0} is not a number: {1}", std::string(1, "xyz"[k]), inQuotes(line.substr(at, 8))));
  }
  const std::string_view charge = trimmed(line.substr(66, 10));
  if (std::string fault = partialChargeFault(charge, atom.charge_e); !fault.empty()) return bad(71, std::move(fault));
  const std::string_view residue_number = trimmed(line.substr(22, 4));
  const auto [end, error] =
      std::from_chars(residue_number.data(), residue_number.data() + residue_number.size(), atom.number);
  if (!residue_number.empty() && (error != std::errc{} || end != residue_number.data() + residue_number.size()))
    return bad(23, trf("the residue number is not a number: {0}", inQuotes(residue_number)));
  if (!parseNumber(line.substr(54, 6), atom.occupancy)) atom.occupancy = 1.0;
  if (!parseNumber(line.substr(60, 6), atom.b_factor_A2)) atom.b_factor_A2 = 0.0;
  atom.name = trimmed(line.substr(12, 4));
  atom.alternate = line[16];
  atom.residue = trimmed(line.substr(17, 3));
  atom.chain = trimmed(line.substr(20, 2));
  atom.insertion = line[26];
  const std::string_view type = trimmed(line.substr(77));
  atom.element = type.substr(0, type.find(' '));
  atom.atomic_number = elementOfDockType(atom.element);
  atom.line = number;
  // Programs write ATOM for ligands too: what is neither amino acid nor nucleotide counts as one.
  atom.hetero = line[0] == 'H' || !isNucleotideName(atom.residue);
  return std::nullopt;
}

}  // namespace

Expected<Molecule> readPdbqt(TextSource& text, const ReadOptions& options) {
  if (!options.assembly.empty()) return noAssembly(text.file());
  MoleculeBuilder builder(text, options, true);
  ParsedHeader head;
  head.models = 0;
  bool in_model = false, any = false, any_charge = false;
  std::size_t glue = 0;
  for (std::string_view line; text.next(line);) {
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.starts_with("ATOM") || line.starts_with("HETATM")) {
      if (!std::exchange(in_model, true)) ++head.models;
      any = true;
      if (head.models != options.model) continue;
      ParsedAtom atom;
      if (auto problem = pdbqtAtom(line, text.file(), text.number(), atom)) return *problem;
      if (isGlue(atom.element)) {
        ++glue;
        continue;
      }
      any_charge = any_charge || atom.charge_e != 0.0;
      if (auto problem = builder.add(atom)) return *problem;
    } else if (line.starts_with("MODEL")) {
      ++head.models;
      in_model = true;
    } else if (line.starts_with("ENDMDL")) {
      in_model = false;
    }
  }
  if (!any) return Problem{text.file(), 0, 0, tr("there is no ATOM or HETATM line in it"), tr(kPdbqtRemedy)};
  if (options.model < 1 || options.model > head.models) return noSuchModel(text.file(), options.model, head.models);
  if (glue)
    head.warnings.push_back(
        trnf("{0} point of an opened ring left out.", "{0} points of opened rings left out.", glue, glue));
  if (!any_charge) head.warnings.push_back(allChargesZero());
  Expected<Molecule> out = builder.finish(std::move(head));
  if (out && !any_charge) out->charges_e = {};
  return out;
}

}  // namespace moltact
