#include "engine/structure/superposition.h"

#include <algorithm>
#include <cmath>
#include <gemmi/qcp.hpp>
#include <map>
#include <string_view>
#include <tuple>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::size_t kMinCommonAtoms = 3;

using ResidueName = std::tuple<std::string_view, int, char>;  // chain, number, insertion code

/// Maps each chain of this molecule to that of the other; by name if names are common.
std::map<std::string_view, std::string_view> chainNames(const Molecule& one, const Molecule& other) {
  std::map<std::string_view, std::string_view> out;
  std::vector<std::string_view> mine, theirs;
  const auto collect = [](const Molecule& m, std::vector<std::string_view>& names) {
    for (const Chain& c : m.chains)
      if (std::find(names.begin(), names.end(), std::string_view(c.name)) == names.end()) names.push_back(c.name);
  };
  collect(one, mine);
  collect(other, theirs);
  const bool common = std::any_of(mine.begin(), mine.end(), [&](std::string_view name) {
    return std::find(theirs.begin(), theirs.end(), name) != theirs.end();
  });
  for (std::size_t k = 0; k < mine.size(); ++k)
    if (common || mine.size() != theirs.size())
      out[mine[k]] = mine[k];
    else
      out[mine[k]] = theirs[k];
  return out;
}

bool leads(const Molecule& m, std::uint32_t index) {
  const Atom& a = m.atoms[index];
  if (a.residue >= m.residues.size()) return false;
  const std::string_view name = a.nameText();
  switch (m.residues[a.residue].kind) {
    case ResidueKind::AminoAcid:
      return name == "CA";
    case ResidueKind::Nucleotide:
      return name == "P" || name == "C1'" || name == "C1*";
    default:
      return false;
  }
}

/// True if the points are collinear or coincide: their fit is then ambiguous.
bool onALine(const std::vector<gemmi::Position>& places) {
  gemmi::Position middle(0, 0, 0);
  for (const gemmi::Position& p : places) middle += p;
  middle /= double(places.size());
  gemmi::Vec3 far(0, 0, 0);
  for (const gemmi::Position& p : places)
    if ((p - middle).length_sq() > far.length_sq()) far = p - middle;
  double aside = 0.0;
  for (const gemmi::Position& p : places) aside = std::max(aside, far.cross(p - middle).length_sq());
  constexpr double kSine = 1e-3;
  return aside <= kSine * kSine * far.length_sq() * far.length_sq();
}

// `other_A(j)`: the position of the atom j of the other.
template <class PositionOf>
Expected<Superposition> fitted(const Molecule& one, PositionOf&& other_A,
                               std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) {
  std::vector<gemmi::Position> here, there;
  const auto collect = [&](bool all) {
    for (const auto& [i, j] : pairs) {
      if (!all && !leads(one, i)) continue;
      const Vec3 &p = one.spheres[i].centre_A, &q = other_A(j);
      here.emplace_back(p.x, p.y, p.z);
      there.emplace_back(q.x, q.y, q.z);
    }
  };
  collect(false);
  if (here.size() < kMinCommonAtoms) {
    here.clear();
    there.clear();
    collect(true);
  }
  if (here.size() < kMinCommonAtoms)
    return Problem{
        {},
        0,
        0,
        trnf("only {0} atom is in both structures", "only {0} atoms are in both structures", here.size(), here.size()),
        tr("take two structures of one molecule, with the same chains and residue numbers")};
  if (onALine(here) || onALine(there))
    return Problem{{},
                   0,
                   0,
                   tr("the atoms that are in both structures lie on a line"),
                   tr("take two structures with more atoms in common")};
  const gemmi::SupResult fit = gemmi::superpose_positions(here.data(), there.data(), here.size(), nullptr);
  Superposition out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out.rotation[j][i] = fit.transform.mat[i][j];
    out.shift_A[i] = fit.transform.vec.at(i);
  }
  out.rmsd_A = fit.rmsd;
  out.fitted = here.size();
  return out;
}

}  // namespace

AtomPairs matchAtoms(const Molecule& one, const Molecule& other) {
  std::map<ResidueName, std::uint32_t> known;
  for (std::uint32_t r = 0; r < other.residues.size(); ++r) {
    const Residue& residue = other.residues[r];
    known.emplace(ResidueName{other.chains[residue.chain].name, residue.number, residue.insertion}, r);
  }
  const auto chains = chainNames(one, other);
  AtomPairs out;
  std::vector<char> taken(other.atoms.size(), 0);
  for (const Residue& residue : one.residues) {
    const auto found = known.find({chains.at(one.chains[residue.chain].name), residue.number, residue.insertion});
    if (found == known.end()) continue;
    const Residue& same = other.residues[found->second];
    for (std::uint32_t i = residue.first_atom; i < residue.first_atom + residue.atom_count; ++i)
      for (std::uint32_t j = same.first_atom; j < same.first_atom + same.atom_count; ++j) {
        if (taken[j] || one.atoms[i].name != other.atoms[j].name ||
            one.atoms[i].atomic_number != other.atoms[j].atomic_number)
          continue;
        taken[j] = 1;
        out.emplace_back(i, j);
        break;
      }
  }
  return out;
}

std::vector<std::uint32_t> leadingAtoms(const Molecule& molecule) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i)
    if (leads(molecule, i)) out.push_back(i);
  if (out.size() >= kMinCommonAtoms) return out;
  out.resize(molecule.atoms.size());
  for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = i;
  return out;
}

Expected<Superposition> superpose(const Molecule& one, const Molecule& other,
                                  std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) {
  return fitted(
      one, [&](std::uint32_t j) -> const Vec3& { return other.spheres[j].centre_A; }, pairs);
}

Expected<Superposition> superpose(const Molecule& one, std::span<const Vec3> other_A,
                                  std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) {
  return fitted(
      one, [&](std::uint32_t j) -> const Vec3& { return other_A[j]; }, pairs);
}

std::vector<Sphere> TwoStates::at(double share) const {
  share = std::clamp(share, 0.0, 1.0);
  std::vector<Sphere> out = first;
  for (std::size_t i = 0; i < out.size(); ++i) out[i].centre_A += (second[i].centre_A - first[i].centre_A) * share;
  return out;
}

Expected<TwoStates> twoStates(const Molecule& one, const Molecule& other, std::span<const std::uint32_t> on) {
  const AtomPairs pairs = matchAtoms(one, other);
  AtomPairs laid = pairs;
  if (!on.empty())
    std::erase_if(laid, [&](const auto& pair) { return !std::binary_search(on.begin(), on.end(), pair.first); });
  auto fit = superpose(one, other, laid);
  if (!fit) return fit.problem();
  TwoStates out;
  out.fit = *fit;
  out.matched = pairs.size();
  out.first = one.spheres.copy();
  out.second = out.first;
  std::vector<char> matched(one.atoms.size(), 0);
  std::vector<Vec3> displacement(one.residues.size(), Vec3(0.0));
  std::vector<double> count(one.residues.size(), 0.0);
  for (const auto& [i, j] : pairs) {
    out.second[i].centre_A = out.fit(other.spheres[j].centre_A);
    matched[i] = 1;
    const std::uint32_t r = one.atoms[i].residue;
    displacement[r] += out.second[i].centre_A - out.first[i].centre_A;
    ++count[r];
  }
  for (std::uint32_t i = 0; i < one.atoms.size(); ++i) {
    const std::uint32_t r = one.atoms[i].residue;
    if (!matched[i] && r < one.residues.size() && count[r] > 0.0) out.second[i].centre_A += displacement[r] / count[r];
  }
  return out;
}

}  // namespace moltact
