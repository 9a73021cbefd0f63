// Why a selection selects nothing, and which of its names a molecule does not have.
#include <algorithm>
#include <functional>
#include <set>

#include "engine/core/text.h"
#include "engine/lesson/selection.h"
#include "engine/lesson/selection_node.h"
#include "engine/lesson/suggestion.h"
#include "engine/molecule/elements.h"
#include "engine/molecule/molecule.h"

namespace moltact {
namespace {

using Node = SelectionNode;

bool selectsNothing(const Node& node, const Molecule& m) {
  return Selection({}, std::make_shared<const Node>(node)).select(m).empty();
}

bool isLeaf(const Node& node) { return node.left == nullptr; }

/// The first part, in reading order, that selects nothing; nullptr where each selects something.
const Node* firstEmpty(const Node& node, const Molecule& m) {
  for (const Node* child : {node.left.get(), node.right.get()})
    if (child && node.kind != SelectionKind::Not)
      if (const Node* empty = firstEmpty(*child, m)) return empty;
  return isLeaf(node) && selectsNothing(node, m) ? &node : nullptr;
}

/// The node with its k-th name, number or element alone.
Node only(const Node& node, std::size_t k) {
  Node one = node;
  const auto keep = [k](auto& items) {
    if (!items.empty()) items = {items[k]};
  };
  keep(one.names);
  keep(one.numbers);
  keep(one.elements);
  keep(one.columns);
  return one;
}

std::string listed(const std::set<std::string>& names) {
  constexpr std::size_t kMost = 12;
  if (names.empty()) return "none";
  std::string out;
  std::size_t n = 0;
  for (const std::string& name : names) {
    if (n == kMost) return out + ", …";
    out += (n++ ? ", " : "") + name;
  }
  return out;
}

/// What could stand in the place of a name that the molecule does not have.
std::string remedyFor(const std::string& name, const std::set<std::string>& there) {
  for (const std::string& known : there)
    if (lower(known) == lower(name)) return "did you mean '" + known + "'? Names are written as in the file";
  const std::vector<std::string_view> known(there.begin(), there.end());
  // Of names of one or two letters, any is near to any other.
  const std::string near = name.size() > 2 ? suggest(name, known, "") : std::string();
  return near.starts_with("did you mean") ? near : "name atoms that it has";
}

/// What is told of a leaf that selects nothing: its first name and what there is instead.
Problem faultOf(const Node& leaf, const Molecule& molecule) {
  const std::string place = molecule.id.empty() ? "the molecule" : molecule.id, not_in = " is not in " + place;
  const std::string name = leaf.names.empty() ? std::string() : leaf.names.front();
  std::set<std::string> there;
  const auto named = [&](const char* what, const char* list) {
    return Problem{{},
                   0,
                   leaf.columns.empty() ? leaf.column : leaf.columns[0],
                   std::string(what) + " '" + name + "'" + not_in + " (" + list + ": " + listed(there) + ")",
                   remedyFor(name, there)};
  };
  const auto plain = [&](const std::string& text) {
    return Problem{{}, 0, leaf.columns.empty() ? leaf.column : leaf.columns[0], text, "name atoms that it has"};
  };
  switch (leaf.kind) {
    case SelectionKind::Chain:
      for (const Chain& c : molecule.chains) there.insert(c.name.string());
      return named("chain", "chains");
    case SelectionKind::Ligand:
      for (const Residue& r : molecule.residues)
        if (r.kind == ResidueKind::Ligand) there.insert(r.name.string());
      return name.empty() ? plain("a ligand" + not_in) : named("ligand", "ligands");
    case SelectionKind::Resname:
      for (const Residue& r : molecule.residues) there.insert(r.name.string());
      return named("residue name", "names");
    case SelectionKind::Name:
      for (const Atom& a : molecule.atoms) there.emplace(a.name.data(), std::find(a.name.begin(), a.name.end(), '\0'));
      return named("atom name", "names");
    case SelectionKind::Element:
      for (const Atom& a : molecule.atoms) there.emplace(element(a.atomic_number).symbol);
      return plain("element '" + std::string(element(leaf.elements[0]).symbol) + "'" + not_in +
                   " (elements: " + listed(there) + ")");
    case SelectionKind::AtomIndex:
      return plain("atom " + rangeText(leaf.numbers[0]) + not_in + " (" + std::to_string(molecule.atoms.size()) +
                   " atoms, counted from 0)");
    case SelectionKind::Residue: {
      const std::string text = "residue " + rangeText(leaf.numbers[0]) + not_in;
      if (molecule.residues.empty()) return plain(text + " (it has no residues)");
      const auto [low, high] =
          std::minmax_element(molecule.residues.begin(), molecule.residues.end(),
                              [](const Residue& a, const Residue& b) { return a.number < b.number; });
      return plain(text + " (residues: " + std::to_string(low->number) + " to " + std::to_string(high->number) + ")");
    }
    case SelectionKind::Protein:
      return plain("protein" + not_in);
    case SelectionKind::Nucleic:
      return plain("nucleic acid" + not_in);
    case SelectionKind::Water:
      return plain("water" + not_in);
    case SelectionKind::Ion:
      return plain("an ion" + not_in);
    default:
      return plain("no atom of " + place + " is selected");
  }
}

}  // namespace

Problem Selection::whyEmpty(const Molecule& molecule) const {
  if (const Node* empty = root_ ? firstEmpty(*root_, molecule) : nullptr) return faultOf(*empty, molecule);
  const std::string place = molecule.id.empty() ? "the molecule" : molecule.id;
  return {{}, 0, 1, "no atom of " + place + " is '" + text_ + "'", "name atoms that it has"};
}

std::vector<Problem> Selection::idleNames(const Molecule& molecule) const {
  std::vector<Problem> out;
  const std::function<void(const Node&)> visit = [&](const Node& node) {
    for (const Node* child : {node.left.get(), node.right.get()})
      if (child) visit(*child);
    for (std::size_t k = 0; isLeaf(node) && node.columns.size() > 1 && k < node.columns.size(); ++k)
      if (const Node one = only(node, k); selectsNothing(one, molecule)) out.push_back(faultOf(one, molecule));
  };
  if (root_) visit(*root_);
  return out;
}

}  // namespace moltact
