// Explains why a selection is empty, and finds its names that the molecule does not have.
#include <algorithm>
#include <functional>
#include <set>

#include "engine/core/text.h"
#include "engine/language/catalogue.h"
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

/// The first part, in reading order, that selects nothing; nullptr if every part selects something.
const Node* firstEmpty(const Node& node, const Molecule& m) {
  for (const Node* child : {node.left.get(), node.right.get()})
    if (child && node.kind != SelectionKind::Not)
      if (const Node* empty = firstEmpty(*child, m)) return empty;
  return isLeaf(node) && selectsNothing(node, m) ? &node : nullptr;
}

/// The node with only its k-th name, number or element.
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
  constexpr std::size_t kMax = 12;
  if (names.empty()) return trc("an empty list", "none");
  std::string out;
  std::size_t n = 0;
  for (const std::string& name : names) {
    if (n == kMax) return out + ", …";
    out += (n++ ? ", " : "") + name;
  }
  return out;
}

std::string nameOther() { return tr("name atoms that it has"); }

/// The remedy for a name that the molecule does not have.
std::string remedyFor(const std::string& name, const std::set<std::string>& there) {
  for (const std::string& known : there)
    if (lower(known) == lower(name)) return trf("did you mean '{0}'? Names are written as in the file", known);
  const std::vector<std::string_view> known(there.begin(), there.end());
  // Names of one or two letters are all similar to each other.
  const std::string_view near = name.size() > 2 ? nearest(name, known) : std::string_view();
  return near.empty() ? nameOther() : didYouMean(near);
}

/// The molecule's name after "in" or "of".
std::string placeOf(const Molecule& molecule) {
  return molecule.id.empty() ? trc("after in or of", "the molecule") : molecule.id;
}

/// Describes an empty leaf: its first name and the existing alternatives.
Problem faultOf(const Node& leaf, const Molecule& molecule) {
  const std::string place = placeOf(molecule);
  const std::string name = leaf.names.empty() ? std::string() : leaf.names.front();
  std::set<std::string> there;
  const auto at = [&](std::string message, std::string remedy) {
    return Problem{{}, 0, leaf.columns.empty() ? leaf.column : leaf.columns[0], std::move(message), std::move(remedy)};
  };
  const auto named = [&](const char* sentence) {
    return at(trf(sentence, name, place, listed(there)), remedyFor(name, there));
  };
  const auto plain = [&](std::string message) { return at(std::move(message), nameOther()); };
  switch (leaf.kind) {
    case SelectionKind::Chain:
      for (const Chain& c : molecule.chains) there.insert(c.name.string());
      return named(N_("chain '{0}' is not in {1} (chains: {2})"));
    case SelectionKind::Ligand:
      for (const Residue& r : molecule.residues)
        if (r.kind == ResidueKind::Ligand) there.insert(r.name.string());
      return name.empty() ? plain(trf("a ligand is not in {0}", place))
                          : named(N_("ligand '{0}' is not in {1} (ligands: {2})"));
    case SelectionKind::Resname:
      for (const Residue& r : molecule.residues) there.insert(r.name.string());
      return named(N_("residue name '{0}' is not in {1} (names: {2})"));
    case SelectionKind::Name:
      for (const Atom& a : molecule.atoms) there.emplace(a.name.data(), std::find(a.name.begin(), a.name.end(), '\0'));
      return named(N_("atom name '{0}' is not in {1} (names: {2})"));
    case SelectionKind::Element:
      for (const Atom& a : molecule.atoms) there.emplace(element(a.atomic_number).symbol);
      return plain(
          trf("element '{0}' is not in {1} (elements: {2})", element(leaf.elements[0]).symbol, place, listed(there)));
    case SelectionKind::AtomIndex:
      return plain(trf("atom {0} is not in {1} ({2} atoms, counted from 0)", rangeText(leaf.numbers[0]), place,
                       molecule.atoms.size()));
    case SelectionKind::Residue: {
      const std::string number = rangeText(leaf.numbers[0]);
      if (molecule.residues.empty()) return plain(trf("residue {0} is not in {1} (it has no residues)", number, place));
      const auto [low, high] =
          std::minmax_element(molecule.residues.begin(), molecule.residues.end(),
                              [](const Residue& a, const Residue& b) { return a.number < b.number; });
      return plain(trf("residue {0} is not in {1} (residues: {2} to {3})", number, place, low->number, high->number));
    }
    case SelectionKind::Class:
      return plain(trf(leaf.atom_class->missing, place));
    case SelectionKind::All:
    case SelectionKind::Within:
    case SelectionKind::BondedTo:
    case SelectionKind::Not:
    case SelectionKind::And:
    case SelectionKind::Or:
      break;
  }
  return plain(trf("no atom of {0} is selected", place));
}

}  // namespace

Problem Selection::whyEmpty(const Molecule& molecule) const {
  if (const Node* empty = root_ ? firstEmpty(*root_, molecule) : nullptr) return faultOf(*empty, molecule);
  return {{}, 0, 1, trf("no atom of {0} is '{1}'", placeOf(molecule), text_), nameOther()};
}

std::vector<Problem> Selection::unmatchedNames(const Molecule& molecule) const {
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
