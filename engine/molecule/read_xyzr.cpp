// Reads .xyzr, the format of surface programs: one sphere per line, x y z r in angstroms; blank lines and # comments
// are allowed. Text after the fourth number of a line (an atom's name, a flag) is ignored with one warning.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/molecule/parsed_structure.h"

namespace moltact {
namespace {

constexpr const char* kFormatRemedy = N_("write four numbers a line, x y z r in angstroms, with blanks between them");

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// Reads one number at `at`; on success `at` is advanced to the following blank or the end.
bool takeNumber(const char*& at, const char* end, double& value) {
  const char* begin = at + (end - at > 1 && *at == '+' && at[1] != '-' ? 1 : 0);
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || (stop != end && !isBlank(*stop) && *stop != '#')) return false;
  at = stop;
  return true;
}

}  // namespace

Expected<Molecule> readXyzr(TextSource& text, const ReadOptions& options) {
  constexpr std::size_t kBytesASphere = 32;
  const std::string& file = text.file();
  constexpr const char* kColumn[4] = {"x", "y", "z", "r"};
  if (options.model != 1) return noSuchModel(file, options.model, 1);
  if (!options.assembly.empty()) return noAssembly(file);
  std::vector<Sphere> spheres;
  spheres.reserve(std::min(kMaxMoleculeAtoms, text.expectedBytes() / kBytesASphere));
  std::size_t first_extra = 0;
  for (std::string_view line; text.next(line);) {
    const std::size_t line_number = text.number();
    const char *at = line.data(), *const stop = at + line.size(), *const start = at;
    double value[4];
    int count = 0;
    while (count < 5) {
      while (at < stop && isBlank(*at)) ++at;
      if (at == stop || *at == '#') break;
      if (count == 4) {
        if (!first_extra) first_extra = line_number;
        break;
      }
      const std::size_t column = static_cast<std::size_t>(at - start) + 1;
      const char* word_end = at;
      while (word_end < stop && !isBlank(*word_end)) ++word_end;
      const std::string_view word(at, static_cast<std::size_t>(word_end - at));
      if (!takeNumber(at, stop, value[count]))
        return Problem{file, line_number, column,
                       trf("expected a number for {0}, found {1}", kColumn[count], inQuotes(word)), tr(kFormatRemedy)};
      if (!std::isfinite(value[count]) || std::abs(value[count]) > kMaxCoordinate_A)
        return Problem{file, line_number, column,
                       trf("{0} is {1}, which is not a finite number up to {2}", kColumn[count], inQuotes(word),
                           quantityText(kMaxCoordinate_A, Dimension::Length, plain())),
                       tr("correct or remove the line")};
      if (count == 3 && value[3] < 0)
        return Problem{file, line_number, column, trf("the radius is negative: {0}", inQuotes(word)),
                       tr("give a radius of 0 or more")};
      ++count;
    }
    if (count > 0 && count < 4)
      return Problem{file, line_number, static_cast<std::size_t>(at - start) + 1,
                     trf("expected 4 numbers, found {0}", count), tr(kFormatRemedy)};
    if (count == 4) {
      if (spheres.size() >= kMaxMoleculeAtoms) return tooManyAtoms(file, line_number);
      spheres.push_back({{value[0], value[1], value[2]}, value[3]});
    }
  }
  if (spheres.empty()) return Problem{file, 0, 0, tr("the file holds no atoms"), tr(kFormatRemedy)};
  Molecule out;
  out.atoms = std::vector<Atom>(spheres.size());
  out.spheres = std::move(spheres);
  if (first_extra)
    out.warnings = {trf("What follows the fourth number of a line was passed over (first on line {0}).", first_extra)};
  return out;
}

}  // namespace moltact
