// Helices and strands from the hydrogen bonds of the backbone, after Kabsch & Sander 1983, with the paper's names. The
// bond (donor, acceptor) leads from the N-H of one residue to the C=O of the other.
#include <algorithm>
#include <array>
#include <deque>
#include <utility>

#include "engine/haptics/sphere_grid.h"
#include "engine/structure/backbone.h"
#include "engine/structure/secondary_structure.h"

namespace moltact {
namespace {

constexpr double kBondEnergy_kcal = -0.5, kMinEnergy_kcal = -9.9, kTooNear_A = 0.5;
constexpr double kCoupling_kcal_A = 0.42 * 0.20 * 332.0;  // charges of N-H and C=O times the constant
constexpr double kMaxCaDistance_A = 9.0;
constexpr std::size_t kNone = ~std::size_t{0};

/// A residue with a complete backbone. `run` differs across a gap.
struct Peptide {
  std::uint32_t residue = 0;
  std::size_t run = 0;
  Vec3 n{0.0}, ca{0.0}, c{0.0}, o{0.0}, h{0.0};
  bool donates = false;
};

std::vector<Peptide> peptides(const Molecule& m) {
  std::vector<Peptide> out;
  std::size_t run = 0;
  const auto at = [&](std::uint32_t atom) { return m.spheresAsRead()[atom].centre_A; };
  for (const ProteinStretch& stretch : proteinBackbone(m)) {
    ++run;
    for (const AminoAcidAtoms& a : stretch) {
      if (!a.whole()) {
        ++run;
        continue;
      }
      Peptide p{a.residue, run, at(a.n), at(a.ca), at(a.c), at(a.o)};
      // The hydrogen lies opposite the C=O of the previous residue; proline has none.
      if (!out.empty() && out.back().run == run && m.residues[a.residue].name != "PRO") {
        const Vec3 along = out.back().c - out.back().o;
        const double length = glm::length(along);
        p.donates = length > 0.0;
        if (p.donates) p.h = p.n + along / length;
      }
      out.push_back(p);
    }
  }
  return out;
}

double bondEnergy_kcal(const Peptide& donor, const Peptide& acceptor) {
  const double on = glm::distance(acceptor.o, donor.n), ch = glm::distance(acceptor.c, donor.h);
  const double oh = glm::distance(acceptor.o, donor.h), cn = glm::distance(acceptor.c, donor.n);
  if (std::min({on, ch, oh, cn}) < kTooNear_A) return kMinEnergy_kcal;
  return std::max(kMinEnergy_kcal, kCoupling_kcal_A * (1 / on + 1 / ch - 1 / oh - 1 / cn));
}

class StructureFinder {
 public:
  explicit StructureFinder(const Molecule& m) : m_(m), p_(peptides(m)), bonds_(p_.size()), letter_(p_.size(), ' ') {}

  MoleculeStructure run() {
    findBonds();
    ladders();
    helices(4, 'H');
    helices(3, 'G');
    helices(5, 'I');
    return result();
  }

 private:
  struct Acceptors {
    std::array<std::size_t, 2> of{kNone, kNone};
    std::array<double, 2> energy_kcal{0.0, 0.0};
  };
  enum class Bridge { None, Parallel, Antiparallel };
  struct Ladder {
    Bridge type;
    std::deque<std::size_t> i, j;  // residues of the two strands, ascending
  };

  void findBonds() {
    std::vector<Sphere> centres;
    centres.reserve(p_.size());
    for (const Peptide& p : p_) centres.push_back({p.ca, 0.0});
    const SphereGrid grid(std::move(centres), SphereGrid::Duplicates::VisitEach);
    for (std::size_t d = 0; d < p_.size(); ++d) {
      if (!p_[d].donates) continue;
      Acceptors& best = bonds_[d];
      grid.visitCentresNear(p_[d].ca, kMaxCaDistance_A, [&](std::uint32_t a, const Sphere& sphere) {
        if (a == d || a + 1 == d || glm::distance(sphere.centre_A, p_[d].ca) > kMaxCaDistance_A) return;
        const double energy = bondEnergy_kcal(p_[d], p_[a]);
        if (energy < best.energy_kcal[0]) {
          best = {{a, best.of[0]}, {energy, best.energy_kcal[0]}};
        } else if (energy < best.energy_kcal[1]) {
          best.of[1] = a;
          best.energy_kcal[1] = energy;
        }
      });
    }
  }

  bool bond(std::size_t donor, std::size_t acceptor) const {
    const Acceptors& a = bonds_[donor];
    for (int k = 0; k < 2; ++k)
      if (a.of[k] == acceptor && a.energy_kcal[k] < kBondEnergy_kcal) return true;
    return false;
  }
  bool unbroken(std::size_t from, std::size_t to) const { return to < p_.size() && p_[from].run == p_[to].run; }

  Bridge bridge(std::size_t i, std::size_t j) const {
    if (i == 0 || j == 0 || !unbroken(i - 1, i + 1) || !unbroken(j - 1, j + 1)) return Bridge::None;
    if ((bond(i + 1, j) && bond(j, i - 1)) || (bond(j + 1, i) && bond(i, j - 1))) return Bridge::Parallel;
    if ((bond(i + 1, j - 1) && bond(j + 1, i - 1)) || (bond(j, i) && bond(i, j))) return Bridge::Antiparallel;
    return Bridge::None;
  }

  // Pairs of residues whose hydrogen bonds may form a bridge, ascending.
  std::vector<std::pair<std::size_t, std::size_t>> pairs() const {
    std::vector<std::pair<std::size_t, std::size_t>> out;
    const auto add = [&](std::size_t a, std::size_t b) {
      const auto [i, j] = std::minmax(a, b);
      if (j < p_.size() && j - i >= 3) out.emplace_back(i, j);
    };
    for (std::size_t d = 0; d < p_.size(); ++d)
      for (int k = 0; k < 2; ++k) {
        const std::size_t a = bonds_[d].of[k];
        if (a == kNone || bonds_[d].energy_kcal[k] >= kBondEnergy_kcal) continue;
        add(d, a);
        add(d, a + 1);
        if (d == 0) continue;
        add(d - 1, a);
        add(d - 1, a + 1);
      }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  void ladders() {
    std::vector<Ladder> ladders;
    std::size_t open = 0;  // earlier ladders end too early to be extended
    for (const auto& [i, j] : pairs()) {
      const Bridge type = bridge(i, j);
      if (type == Bridge::None) continue;
      while (open < ladders.size() && ladders[open].i.back() + 1 < i) ++open;
      bool continued = false;
      for (std::size_t k = open; k < ladders.size() && !continued; ++k) {
        Ladder& l = ladders[k];
        if (l.type != type || l.i.back() + 1 != i) continue;
        if (type == Bridge::Parallel && l.j.back() + 1 == j) {
          l.j.push_back(j);
          continued = true;
        } else if (type == Bridge::Antiparallel && l.j.front() == j + 1) {
          l.j.push_front(j);
          continued = true;
        }
        if (continued) l.i.push_back(i);
      }
      if (!continued) ladders.push_back({type, {i}, {j}});
    }
    joinByBulges(ladders);
    for (const Ladder& l : ladders) {
      const char letter = l.i.size() > 1 ? 'E' : 'B';
      for (const auto* strand : {&l.i, &l.j})
        for (std::size_t k = strand->front(); k <= strand->back(); ++k)
          if (letter_[k] != 'E') letter_[k] = letter;
    }
  }

  // A bulge: up to four additional residues on one strand and one on the other.
  void joinByBulges(std::vector<Ladder>& ladders) const {
    std::sort(ladders.begin(), ladders.end(),
              [](const Ladder& a, const Ladder& b) { return a.i.front() < b.i.front(); });
    const auto step = [](std::size_t from, std::size_t to) { return to > from ? to - from : kNone; };
    for (std::size_t a = 0; a < ladders.size(); ++a)
      for (std::size_t b = a + 1; b < ladders.size();) {
        Ladder& l = ladders[a];
        Ladder& other = ladders[b];
        const std::size_t on_i = step(l.i.back(), other.i.front());
        if (other.i.front() > l.i.back() && on_i >= 6) break;  // also true of all that follow
        const bool parallel = l.type == Bridge::Parallel;
        const std::size_t on_j = parallel ? step(l.j.back(), other.j.front()) : step(other.j.back(), l.j.front());
        const bool joins = other.type == l.type && on_i < 6 && ((on_j < 6 && on_i < 3) || on_j < 3) &&
                           unbroken(l.i.front(), other.i.back()) &&
                           unbroken(std::min(l.j.front(), other.j.front()), std::max(l.j.back(), other.j.back()));
        if (!joins) {
          ++b;
          continue;
        }
        l.i.insert(l.i.end(), other.i.begin(), other.i.end());
        l.j.insert(parallel ? l.j.end() : l.j.begin(), other.j.begin(), other.j.end());
        ladders.erase(ladders.begin() + std::ptrdiff_t(b));
      }
  }

  // Two consecutive turns of `step` form a helix; alpha helices first, the others where nothing else is assigned.
  void helices(std::size_t step, char letter) {
    const auto turn = [&](std::size_t i) { return unbroken(i, i + step) && bond(i + step, i); };
    bool before = false;
    for (std::size_t i = 0; i < p_.size(); ++i) {
      const bool here = turn(i);
      if (here && before) {
        bool free = true;
        for (std::size_t k = i; k < i + step; ++k) free = free && (letter_[k] == ' ' || letter_[k] == letter);
        if (letter == 'H' || free)
          for (std::size_t k = i; k < i + step; ++k) letter_[k] = letter;
      }
      before = here;
    }
  }

  MoleculeStructure result() const {
    MoleculeStructure out;
    out.of_residue.resize(m_.residues.size(), SecondaryStructure::Coil);
    for (std::size_t k = 0; k < p_.size(); ++k) {
      const char letter = letter_[k];
      if (letter == ' ' || letter == 'B') continue;
      const SecondaryStructure kind = letter == 'E' ? SecondaryStructure::Strand : SecondaryStructure::Helix;
      const HelixKind helix = letter == 'G' ? HelixKind::ThreeTen : letter == 'I' ? HelixKind::Pi : HelixKind::Alpha;
      out.of_residue[p_[k].residue] = kind;
      if (k > 0 && letter_[k - 1] == letter && unbroken(k - 1, k))
        out.elements.back().last_residue = p_[k].residue;
      else
        out.elements.push_back({kind, helix, p_[k].residue, p_[k].residue});
    }
    return out;
  }

  const Molecule& m_;
  const std::vector<Peptide> p_;
  std::vector<Acceptors> bonds_;  // per residue as donor
  std::vector<char> letter_;      // H, G, I, E, B as in the paper; blank: none
};

}  // namespace

MoleculeStructure structureByHydrogenBonds(const Molecule& molecule) { return StructureFinder(molecule).run(); }

}  // namespace moltact
