#include "engine/structure/amber/amber.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace moltact {
namespace {

struct AmberResidue {
  std::string_view name;
  std::uint16_t first, count;  // in kAtoms
};

#include "engine/structure/amber/templates.inc"

constexpr auto kNames = [] {
  std::array<std::string_view, std::size(kResidues)> out;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = kResidues[k].name;
  return out;
}();

}  // namespace

std::span<const AmberAtom> amberTemplate(std::string_view name) {
  for (const AmberResidue& r : kResidues)
    if (r.name == name) return std::span(kAtoms).subspan(r.first, r.count);
  return {};
}

std::span<const std::string_view> amberTemplateNames() { return kNames; }

const AmberType* amberType(std::string_view name) {
  const auto found =
      std::find_if(std::begin(kTypes), std::end(kTypes), [&](const AmberType& t) { return t.name == name; });
  return found == std::end(kTypes) ? nullptr : &*found;
}

bool polarHydrogen(std::span<const AmberAtom> residue, const AmberAtom& atom) {
  return atom.parent >= 0 && residue[std::size_t(atom.parent)].name.front() != 'C';
}

}  // namespace moltact
