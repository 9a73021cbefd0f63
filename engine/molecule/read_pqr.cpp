// Reads PQR in the form of PDB2PQR and APBS: lines of a PDB file with blanks between the words. The atom's charge and
// radius replace occupancy and B factor.
#include <charconv>
#include <cmath>
#include <gemmi/elem.hpp>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/molecule/element_of_name.h"
#include "engine/molecule/elements.h"
#include "engine/molecule/parsed_structure.h"

namespace moltact {
namespace {

constexpr const char* kPqrRemedy =
    N_("write: ATOM number name residue chain residue-number x y z charge radius, with blanks between them (pdb2pqr "
       "--whitespace); the chain may be left out");

bool isAtomRecord(std::string_view line) { return line.starts_with("ATOM") || line.starts_with("HETATM"); }

std::optional<Problem> addPqrAtom(MoleculeBuilder& builder, std::string_view line, const std::string& file,
                                  std::size_t number) {
  // A serial number of five digits may be adjacent to HETATM.
  const std::size_t record = line.starts_with("HETATM") ? 6 : 4;
  std::vector<LineWord> words = wordsOfLine(line.substr(record));
  // Open Babel writes the element after the radius.
  int element = 0;
  if (words.size() > 9 && words.back().text.size() <= 2) {
    element = gemmi::Element(std::string(words.back().text)).atomic_number();
    if (element) words.pop_back();
  }
  if (words.size() != 9 && words.size() != 10)
    return Problem{file, number, 0,
                   trf("an atom has 9 or 10 words after its record's name, this one {0}", words.size()),
                   tr(kPqrRemedy)};
  const std::size_t place = words.size() - 5;  // index of x
  const auto at = [&](std::size_t k) { return words[k].column + record; };
  ParsedAtom atom;
  const char* kNames[5] = {"x", "y", "z", N_("the charge"), N_("the radius")};
  double value[5];
  for (std::size_t k = 0; k < 5; ++k)
    if (!parseNumber(words[place + k].text, value[k]))
      return Problem{file, number, at(place + k),
                     trf("expected a number for {0}, found {1}", tr(kNames[k]), inQuotes(words[place + k].text)),
                     tr(kPqrRemedy)};
  if (value[4] < 0.0 || value[4] > kMaxCoordinate_A)
    return Problem{file, number, at(place + 4),
                   trf("the radius {0} is not from 0 to {1}", inQuotes(words[place + 4].text),
                       quantityText(kMaxCoordinate_A, Dimension::Length, plain())),
                   tr("correct or remove the line")};
  atom.position_A = {value[0], value[1], value[2]};
  if (std::string fault = partialChargeFault(words[place + 3].text, atom.charge_e); !fault.empty())
    return Problem{file, number, at(place + 3), std::move(fault), tr(kPqrRemedy)};
  atom.radius_A = value[4];
  atom.name = words[1].text;
  atom.residue = words[2].text;
  if (words.size() == 10) atom.chain = words[3].text;
  std::string_view residue_number = words[place - 1].text;
  if (residue_number.size() > 1 && std::isalpha(static_cast<unsigned char>(residue_number.back()))) {
    atom.insertion = residue_number.back();
    residue_number.remove_suffix(1);
  }
  const auto [end, error] =
      std::from_chars(residue_number.data(), residue_number.data() + residue_number.size(), atom.number);
  if (error != std::errc{} || end != residue_number.data() + residue_number.size())
    return Problem{file, number, at(place - 1),
                   trf("the residue number is not a number: {0}", inQuotes(words[place - 1].text)), tr(kPqrRemedy)};
  atom.atomic_number = element ? element : elementOfName(atom.name, atom.residue);
  atom.element = atom.name;
  atom.line = number;
  atom.hetero = record == 6;
  return builder.add(atom);
}

}  // namespace

Expected<Molecule> readPqr(TextSource& text, const ReadOptions& options) {
  if (!options.assembly.empty()) return noAssembly(text.file());
  MoleculeBuilder builder(text, options, true);
  ParsedHeader head;
  head.models = 0;
  bool in_model = false, any = false;
  for (std::string_view line; text.next(line);) {
    if (isAtomRecord(line)) {
      if (!std::exchange(in_model, true)) ++head.models;
      any = true;
      if (head.models == options.model)
        if (auto problem = addPqrAtom(builder, line, text.file(), text.number())) return *problem;
    } else if (line.starts_with("MODEL")) {
      ++head.models;
      in_model = true;
    } else if (line.starts_with("END")) {  // END, ENDMDL
      in_model = false;
    }
  }
  if (!any) return Problem{text.file(), 0, 0, tr("there is no ATOM or HETATM line in it"), tr(kPqrRemedy)};
  if (options.model < 1 || options.model > head.models) return noSuchModel(text.file(), options.model, head.models);
  return builder.finish(std::move(head));
}

}  // namespace moltact
