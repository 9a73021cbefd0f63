// Reads GRO, the coordinate format of GROMACS: positions in nanometres, frame by frame.
#include <charconv>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/molecule/element_of_name.h"
#include "engine/molecule/parsed_structure.h"

namespace moltact {
namespace {

constexpr double kAngstromANanometre = 10.0;
constexpr std::size_t kPlaces = 20;  // the column of x
constexpr const char* kGroRemedy = N_(
    "an atom is residue number (5 columns), residue, atom, atom number (5 each), then x, y, z in nm, each as wide as "
    "the points lie apart");

bool groInteger(std::string_view field, long& value) {
  field = trimmed(field);
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return error == std::errc{} && end == field.data() + field.size();
}

/// Residue numbers have five digits and continue with 0 after 99999.
struct GroNumbers {
  long last = 0, beyond = 0;
  int operator()(long written) {
    if (written == 0 && last == 99'999 && beyond < 1'000'000'000) beyond += 100'000;
    last = written;
    return static_cast<int>(written + beyond);
  }
};

std::optional<Problem> addGroAtom(MoleculeBuilder& builder, GroNumbers& numbers, std::string_view line,
                                  const std::string& file, std::size_t number) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  const auto bad = [&](std::size_t column, std::string what) {
    return Problem{file, number, column, std::move(what), tr(kGroRemedy)};
  };
  if (line.size() < kPlaces) return bad(line.size() + 1, tr("the atom's line ends before its coordinates do"));
  long residue_number = 0;
  if (!groInteger(line.substr(0, 5), residue_number))
    return bad(1, trf("the residue number is not a number: {0}", inQuotes(line.substr(0, 5))));
  const std::size_t first = line.find('.', kPlaces);
  const std::size_t second = first == std::string_view::npos ? first : line.find('.', first + 1);
  if (second == std::string_view::npos) return bad(kPlaces + 1, tr("the atom's line ends before its coordinates do"));
  const std::size_t width = second - first;
  ParsedAtom atom;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t at = kPlaces + k * width;
    const std::string_view field = at < line.size() ? line.substr(at, width) : std::string_view();
    if (!parseNumber(field, atom.position_A[int(k)]))
      return bad(at + 1, trf("{0} is not a number: {1}", std::string(1, "xyz"[k]), inQuotes(field)));
    atom.position_A[int(k)] *= kAngstromANanometre;
  }
  atom.residue = trimmed(line.substr(5, 5));
  atom.name = trimmed(line.substr(10, 5));
  if (isVirtualSite(atom.name, atom.residue)) {
    builder.skip();
    return std::nullopt;
  }
  atom.element = atom.name;
  atom.atomic_number = elementOfName(atom.name, atom.residue);
  atom.number = numbers(residue_number);
  atom.line = number;
  // The format does not mark ligands: everything that is neither amino acid nor nucleotide, by name or atoms, counts as
  // one.
  atom.hetero = !isNucleotideName(atom.residue);
  return builder.add(atom);
}

}  // namespace

Expected<Molecule> readGro(TextSource& text, const ReadOptions& options) {
  const std::string& file = text.file();
  if (!options.assembly.empty()) return noAssembly(file);
  MoleculeBuilder builder(text, options);
  ParsedHeader head;
  head.models = 0;
  GroNumbers numbers;
  for (std::string_view line; text.next(line);) {
    const std::string title(trimmed(line));
    if (!text.next(line)) {
      if (title.empty() || text.problem()) break;  // blank lines at the end
      return Problem{file, text.number(), 0, tr("the file ends after a title"), tr(kGroRemedy)};
    }
    long atoms = 0;
    if (title.empty() && trimmed(line).empty()) continue;
    if (!groInteger(line, atoms) || atoms < 0)
      return Problem{file, text.number(), 1, trf("the number of atoms is not a number: {0}", inQuotes(trimmed(line))),
                     tr("the second line of a frame is how many atoms it has")};
    ++head.models;
    if (head.models == options.model) head.title = title;
    const std::size_t begins = text.number();
    for (long k = 0; k < atoms; ++k) {
      if (!text.next(line)) {
        if (text.problem()) return *text.problem();
        return Problem{
            file, text.number(), 0,
            trf("the frame from line {0} on is to have {1} atoms, and the file ends after {2}", begins, atoms, k),
            tr("copy or download it again")};
      }
      if (head.models == options.model)
        if (auto problem = addGroAtom(builder, numbers, line, file, text.number())) return *problem;
    }
    text.next(line);  // the box vectors
  }
  if (head.models == 0) return Problem{file, 0, 0, tr("the file holds no atoms"), tr(kGroRemedy)};
  if (options.model < 1 || options.model > head.models) return noSuchModel(file, options.model, head.models);
  return builder.finish(std::move(head));
}

}  // namespace moltact
