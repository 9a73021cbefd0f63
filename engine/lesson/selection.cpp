#include "engine/lesson/selection.h"

#include <algorithm>

#include "engine/haptics/sphere_grid.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/selection_node.h"
#include "engine/molecule/elements.h"
#include "engine/molecule/molecule.h"
#include "engine/structure/bonds.h"

namespace moltact {
namespace {

using Node = SelectionNode;
using Mask = std::vector<char>;

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool inRanges(const std::vector<NumberRange>& ranges, long number, char insertion) {
  for (const NumberRange& r : ranges)
    if (number >= r.first && number <= r.last && (r.insertion == ' ' || r.insertion == insertion)) return true;
  return false;
}

// Whether a residue matches. `chains` marks the selected chains.
bool matches(const Node& node, const Residue& r, const Mask& chains) {
  if (node.kind == SelectionKind::Chain) return r.chain < chains.size() && chains[r.chain];
  if (node.kind == SelectionKind::Residue) return inRanges(node.numbers, r.number, r.insertion);
  if (node.kind == SelectionKind::Resname) return contains(node.names, r.name);
  return r.kind == ResidueKind::Ligand && (node.names.empty() || contains(node.names, r.name));
}

// Whether a single atom matches.
bool matches(const Node& node, const Molecule& m, std::size_t index) {
  const Atom& a = m.atoms[index];
  if (node.kind == SelectionKind::All) return true;
  if (node.kind == SelectionKind::Name) return contains(node.names, a.nameText());
  if (node.kind == SelectionKind::Element)
    return std::find(node.elements.begin(), node.elements.end(), a.atomic_number) != node.elements.end();
  return node.kind == SelectionKind::AtomIndex && inRanges(node.numbers, static_cast<long>(index), ' ');
}

Mask within(const Mask& near_what, double distance_A, const Molecule& m) {
  std::vector<Sphere> centres;
  for (std::size_t i = 0; i < m.atoms.size(); ++i)
    if (near_what[i]) centres.push_back({m.spheres[i].centre_A, 0.0});
  Mask out(m.atoms.size(), 0);
  if (centres.empty()) return out;
  const SphereGrid grid(std::move(centres));
  const double squared = distance_A * distance_A;
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    out[i] = near_what[i];
    if (out[i]) continue;
    const Vec3 p = m.spheres[i].centre_A;
    grid.visitNear(p, distance_A, [&](std::uint32_t, const Sphere& b) {
      const Vec3 d = b.centre_A - p;
      if (glm::dot(d, d) <= squared) out[i] = 1;
    });
  }
  return out;
}

Mask bondedTo(const Mask& what, const Molecule& m) {
  Mask out(m.atoms.size(), 0);
  for (const Bond& b : findBonds(m)) {
    if (what[b.first]) out[b.second] = 1;
    if (what[b.second]) out[b.first] = 1;
  }
  return out;
}

// Nodes that select whole chains or residues: names are compared once for each of these, not for each atom.
Mask ofResidues(const Node& node, const Molecule& m) {
  Mask chains(m.chains.size(), 0), residues(m.residues.size(), 0), out(m.atoms.size(), 0);
  for (std::size_t c = 0; c < chains.size(); ++c) chains[c] = contains(node.names, m.chains[c].name);
  for (std::size_t k = 0; k < residues.size(); ++k) residues[k] = matches(node, m.residues[k], chains);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (m.atoms[i].residue < residues.size()) out[i] = residues[m.atoms[i].residue];
  return out;
}

Mask evaluate(const Node& node, const Molecule& m) {
  switch (node.kind) {
    case SelectionKind::And:
    case SelectionKind::Or: {
      Mask left = evaluate(*node.left, m);
      const Mask right = evaluate(*node.right, m);
      for (std::size_t i = 0; i < left.size(); ++i)
        left[i] = node.kind == SelectionKind::And ? (left[i] && right[i]) : (left[i] || right[i]);
      return left;
    }
    case SelectionKind::Chain:
    case SelectionKind::Residue:
    case SelectionKind::Resname:
    case SelectionKind::Ligand:
      return ofResidues(node, m);
    case SelectionKind::Not: {
      Mask inner = evaluate(*node.left, m);
      for (char& c : inner) c = !c;
      return inner;
    }
    case SelectionKind::Within:
      return within(evaluate(*node.left, m), node.distance_A, m);
    case SelectionKind::BondedTo:
      return bondedTo(evaluate(*node.left, m), m);
    case SelectionKind::Class: {
      Mask out(m.atoms.size(), 0);
      node.atom_class->mark(m, out);
      return out;
    }
    case SelectionKind::All:
    case SelectionKind::Name:
    case SelectionKind::Element:
    case SelectionKind::AtomIndex:
      break;  // evaluated per atom below
  }
  Mask out(m.atoms.size(), 0);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = matches(node, m, i);
  return out;
}

}  // namespace

std::string rangeText(const NumberRange& r) {
  std::string out = std::to_string(r.first);
  if (r.last != r.first) out += "-" + std::to_string(r.last);
  return r.insertion == ' ' ? out : out + r.insertion;
}

std::vector<std::uint32_t> Selection::select(const Molecule& molecule) const {
  std::vector<std::uint32_t> out;
  if (!root_) return out;
  const Mask mask = evaluate(*root_, molecule);
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i]) out.push_back(static_cast<std::uint32_t>(i));
  return out;
}

std::string Selection::noun() const {
  if (!root_) return tr("the surface");
  const Node& n = *root_;
  const bool one_name = n.names.size() == 1, one_number = n.numbers.size() == 1;
  switch (n.kind) {
    case SelectionKind::All:
      return tr("the surface");
    case SelectionKind::Class:
      return tr(n.atom_class->noun);
    case SelectionKind::Ligand:
      return one_name ? trf("the ligand {0}", n.names[0]) : tr("the ligand");
    case SelectionKind::Chain:
      if (one_name) return trf("chain {0}", n.names[0]);
      break;
    case SelectionKind::Resname:
      if (one_name) return trf("a residue {0}", n.names[0]);
      break;
    case SelectionKind::Name:
      if (one_name) return trf("an atom {0}", n.names[0]);
      break;
    case SelectionKind::Residue:
      if (one_number)
        return n.numbers[0].first == n.numbers[0].last ? trf("residue {0}", rangeText(n.numbers[0]))
                                                       : trf("residues {0}", rangeText(n.numbers[0]));
      break;
    case SelectionKind::AtomIndex:
      if (one_number && n.numbers[0].first == n.numbers[0].last) return trf("atom {0}", rangeText(n.numbers[0]));
      break;
    case SelectionKind::Element:
      if (n.elements.size() == 1) {
        const std::string_view name = element(n.elements[0]).name;
        const bool vowel = std::string_view("aeiou").find(name.front()) != std::string_view::npos;
        return vowel ? trf("an {0} atom", tr(name)) : trf("a {0} atom", tr(name));
      }
      break;
    case SelectionKind::Within:
    case SelectionKind::BondedTo:
    case SelectionKind::Not:
    case SelectionKind::And:
    case SelectionKind::Or:
      break;
  }
  return tr("the place you look for");
}

}  // namespace moltact
