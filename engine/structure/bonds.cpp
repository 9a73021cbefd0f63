#include "engine/structure/bonds.h"

#include <algorithm>
#include <gemmi/elem.hpp>
#include <limits>
#include <set>
#include <utility>

#include "engine/haptics/sphere_grid.h"

namespace moltact {
namespace {

constexpr double kTolerance_A = 0.45, kMinApart_A = 0.4;
constexpr double kOnePlace_A = 0.9;        // no two heavy atoms are bonded so closely
constexpr double kMaxFormulaBond_A = 2.6;  // a longer one indicates a torn residue, or two with one name

constexpr std::uint8_t kHydrogenNumber = 1, kCarbonNumber = 6;

gemmi::El elementOf(const Atom& a) {
  return static_cast<gemmi::El>(std::min<int>(a.atomic_number, static_cast<int>(gemmi::El::Og)));
}

class BondFinder {
 public:
  explicit BondFinder(const Molecule& m) : m_(m), of_formula_(m.atoms.size(), 0) {}

  std::vector<Bond> run() {
    for (const Residue& r : m_.residues)
      if (r.kind == ResidueKind::AminoAcid || r.kind == ResidueKind::Nucleotide) addFormula(r);
    byDistance();
    std::sort(out_.begin(), out_.end(),
              [](const Bond& a, const Bond& b) { return std::pair(a.first, a.second) < std::pair(b.first, b.second); });
    return std::move(out_);
  }

 private:
  bool isLigandAtom(const Atom& a) const {
    return a.residue != kNoResidue && m_.residues[a.residue].kind == ResidueKind::Ligand;
  }
  double distance(std::uint32_t a, std::uint32_t b) const {
    return glm::distance(m_.spheresAsRead()[a].centre_A, m_.spheresAsRead()[b].centre_A);
  }
  void add(std::uint32_t a, std::uint32_t b, BondOrder order) {
    const auto [first, second] = std::minmax(a, b);
    out_.push_back({first, second, order});
  }

  // Of a repeated name the first atom is used; the bonds of the other are found by distance.
  void addFormula(const Residue& r) {
    const auto formula = formulaBonds(r.name);
    if (formula.empty()) return;
    named_.clear();
    for (std::uint32_t i = r.first_atom; i < r.first_atom + r.atom_count; ++i) {
      const std::string_view name = formulaName(r.name, m_.atoms[i].nameText());
      const bool known = std::any_of(formula.begin(), formula.end(),
                                     [&](const NamedBond& b) { return b.first == name || b.second == name; });
      const bool twice = std::any_of(named_.begin(), named_.end(), [&](const auto& n) { return n.first == name; });
      if (!known || twice) continue;
      named_.emplace_back(name, i);
      of_formula_[i] = 1;
    }
    const auto find = [&](std::string_view name) {
      const auto at = std::find_if(named_.begin(), named_.end(), [&](const auto& n) { return n.first == name; });
      return at == named_.end() ? kNoResidue : at->second;
    };
    for (const NamedBond& b : formula) {
      const std::uint32_t i = find(b.first), j = find(b.second);
      if (i != kNoResidue && j != kNoResidue && distance(i, j) < kMaxFormulaBond_A) add(i, j, b.order);
    }
  }

  // True if the atoms' names denote a bond between two residues with formulas.
  bool joins(std::uint32_t a, std::uint32_t b) const {
    constexpr std::string_view kJoins[][2] = {{"C", "N"}, {"O3'", "P"}, {"O3*", "P"}, {"SG", "SG"}, {"C", "NZ"}};
    const std::string_view x = m_.atoms[a].nameText(), y = m_.atoms[b].nameText();
    return std::any_of(std::begin(kJoins), std::end(kJoins),
                       [&](const auto& j) { return (x == j[0] && y == j[1]) || (x == j[1] && y == j[0]); });
  }

  void byDistance() {
    std::vector<Sphere> spheres;
    spheres.reserve(m_.atoms.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < m_.atoms.size(); ++i) {
      const double radius = gemmi::covalent_radius(elementOf(m_.atoms[i]));
      largest = std::max(largest, radius);
      spheres.push_back({m_.spheresAsRead()[i].centre_A, radius});
    }
    const SphereGrid grid(std::move(spheres), SphereGrid::Duplicates::VisitEach);
    std::vector<std::uint32_t> nearest;  // the partner of each hydrogen; allocated if there is one
    std::vector<double> how_near;
    for (std::uint32_t i = 0; i < m_.atoms.size(); ++i) {
      const Atom& a = m_.atoms[i];
      const Vec3 here_A = grid[i].centre_A;
      const double radius = grid[i].radius_A;
      grid.visitCentresNear(here_A, radius + largest + kTolerance_A, [&](std::uint32_t j, const Sphere& sphere) {
        if (j <= i) return;
        const double apart = glm::distance(sphere.centre_A, here_A);
        if (apart > radius + sphere.radius_A + kTolerance_A) return;
        const Atom& b = m_.atoms[j];
        const bool same_residue = a.residue == b.residue;
        if (apart < kOnePlace_A && !same_residue && isLigandAtom(a) && isLigandAtom(b) &&
            a.atomic_number != kHydrogenNumber && b.atomic_number != kHydrogenNumber)
          alternatives_.insert(std::minmax(a.residue, b.residue));
        if (apart < kMinApart_A) return;
        if (of_formula_[i] && of_formula_[j] && (same_residue || !joins(i, j))) return;
        const std::uint32_t hydrogen = a.atomic_number == kHydrogenNumber ? i : j;
        if (m_.atoms[hydrogen].atomic_number == kHydrogenNumber) {
          if (!same_residue) return;
          const std::uint32_t other = hydrogen == i ? j : i;
          if (nearest.empty()) {
            nearest.assign(m_.atoms.size(), kNoResidue);
            how_near.assign(m_.atoms.size(), std::numeric_limits<double>::infinity());
          }
          for (const auto& [h, to] : {std::pair(hydrogen, other), std::pair(other, hydrogen)})
            if (m_.atoms[h].atomic_number == kHydrogenNumber && apart < how_near[h])
              how_near[h] = apart, nearest[h] = to;
          return;
        }
        const bool metal = gemmi::is_metal(elementOf(a)) || gemmi::is_metal(elementOf(b));
        const bool carbon = a.atomic_number == kCarbonNumber || b.atomic_number == kCarbonNumber;
        if (metal && !same_residue && (carbon || (gemmi::is_metal(elementOf(a)) && gemmi::is_metal(elementOf(b)))))
          return;
        add(i, j, metal ? BondOrder::Coordination : BondOrder::Unknown);
      });
    }
    if (!alternatives_.empty())
      std::erase_if(out_, [&](const Bond& b) {
        return alternatives_.contains(std::minmax(m_.atoms[b.first].residue, m_.atoms[b.second].residue));
      });
    for (std::uint32_t h = 0; h < nearest.size(); ++h)
      // Two hydrogens that are each other's nearest form a molecule; the bond is listed once.
      if (nearest[h] != kNoResidue &&
          !(m_.atoms[nearest[h]].atomic_number == kHydrogenNumber && nearest[h] < h && nearest[nearest[h]] == h))
        add(h, nearest[h], BondOrder::Single);
  }

  const Molecule& m_;
  std::vector<char> of_formula_;
  std::vector<std::pair<std::string_view, std::uint32_t>> named_;   // atoms of one residue
  std::set<std::pair<std::uint32_t, std::uint32_t>> alternatives_;  // residues that are in one place, the lower first
  std::vector<Bond> out_;
};

}  // namespace

std::vector<Bond> findBonds(const Molecule& molecule) {
  return molecule.listed_bonds.empty() ? BondFinder(molecule).run() : molecule.listed_bonds.copy();
}

BondTable::BondTable(std::size_t atoms, std::span<const Bond> bonds) : begin_(atoms + 1, 0) {
  for (const Bond& b : bonds) ++begin_[b.first + 1], ++begin_[b.second + 1];
  for (std::size_t i = 0; i < atoms; ++i) begin_[i + 1] += begin_[i];
  list_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (const Bond& b : bonds) {
    list_[next[b.first]++] = b.second;
    list_[next[b.second]++] = b.first;
  }
}

bool BondTable::bonded(std::size_t a, std::size_t b) const {
  const auto of_a = neighbours(a);
  return std::find(of_a.begin(), of_a.end(), static_cast<std::uint32_t>(b)) != of_a.end();
}

}  // namespace moltact
