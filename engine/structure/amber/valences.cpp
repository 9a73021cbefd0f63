#include "engine/structure/amber/valences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/structure/ligands.h"

namespace moltact {
namespace {

using Hybrid = AtomValence::Hybrid;

constexpr int kH = 1, kC = 6, kN = 7, kO = 8, kP = 15, kS = 16;
constexpr std::uint32_t kNoMate = 0xFFFFFFFFu;
// An atom with more neighbours is no atom of a ring or a double bond.
constexpr std::size_t kMaxNeighbours = 4;
// An alternating path longer than this is not searched, nor are more steps than this.
constexpr std::size_t kMaxPath = 40;
constexpr int kMaxPathSteps = 3000;

struct Neighbour {
  std::uint32_t atom = 0;
  BondOrder order = BondOrder::Unknown;
};

class ValenceFinder {
 public:
  ValenceFinder(const Molecule& m, std::span<const Bond> bonds, const std::vector<char>& wanted)
      : m_(m), wanted_(wanted), out_(m.atoms.size()), begin_(m.atoms.size() + 1, 0), metal_(m.atoms.size(), 0) {
    for (const Bond& b : bonds) {
      if (!coordinates(b)) continue;
      metal_[b.first] = metal_[b.second] = 1;
    }
    for (const Bond& b : bonds)
      if (!coordinates(b)) ++begin_[b.first + 1], ++begin_[b.second + 1];
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    links_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (const Bond& b : bonds) {
      if (coordinates(b)) continue;
      links_[next[b.first]++] = {b.second, b.order};
      links_[next[b.second]++] = {b.first, b.order};
    }
    planar_.assign(m.atoms.size(), 0);
    mate_.assign(m.atoms.size(), kNoMate);
    in_path_.assign(m.atoms.size(), 0);
  }

  std::vector<AtomValence> run() {
    findRings();
    each([&](std::uint32_t i) { hybridise(i); });
    matchDoubleBonds();
    each([&](std::uint32_t i) {
      if (mate_[i] != kNoMate) out_[i].multiple = true, out_[i].hybrid = Hybrid::Sp2;
    });
    each([&](std::uint32_t i) { acids(i); });
    each([&](std::uint32_t i) { conjugate(i); });
    each([&](std::uint32_t i) { hydrogens(i); });
    each([&](std::uint32_t i) { amidines(i); });
    each([&](std::uint32_t i) { out_[i].partner = mate_[i]; });
    return std::move(out_);
  }

 private:
  bool coordinates(const Bond& b) const {
    return b.order == BondOrder::Coordination || isMetal(m_.atoms[b.first].atomic_number) ||
           isMetal(m_.atoms[b.second].atomic_number);
  }
  template <class Visit>
  void each(Visit visit) {
    for (std::uint32_t i = 0; i < m_.atoms.size(); ++i)
      if (wanted_[i] && element(i) != kH) visit(i);
  }
  int element(std::uint32_t i) const { return m_.atoms[i].atomic_number; }
  std::span<const Neighbour> links(std::uint32_t i) const {
    return {links_.data() + begin_[i], begin_[i + 1] - begin_[i]};
  }
  std::size_t count(std::uint32_t i, int atomic_number) const {
    const auto near = links(i);
    return std::size_t(
        std::count_if(near.begin(), near.end(), [&](const Neighbour& n) { return element(n.atom) == atomic_number; }));
  }
  std::size_t heavy(std::uint32_t i) const { return links(i).size() - count(i, kH); }
  Vec3 place(std::uint32_t i) const { return m_.spheresAsRead()[i].centre_A; }
  double length_A(std::uint32_t i, std::uint32_t j) const { return glm::distance(place(i), place(j)); }
  // An oxygen, or another element, with one neighbour and no proton.
  bool ends(std::uint32_t i, int atomic_number) const {
    return element(i) == atomic_number && links(i).size() == 1 && !metal_[i];
  }
  std::size_t endOxygens(std::uint32_t i) const {
    const auto near = links(i);
    return std::size_t(std::count_if(near.begin(), near.end(),
                                     [&](const Neighbour& n) { return ends(n.atom, kO) && wanted_[n.atom]; }));
  }
  bool ordered(std::uint32_t i) const {
    const auto near = links(i);
    return !near.empty() &&
           std::none_of(near.begin(), near.end(), [](const Neighbour& n) { return n.order == BondOrder::Unknown; }) &&
           // Without other bonds the order of those with hydrogen says nothing.
           std::any_of(near.begin(), near.end(), [&](const Neighbour& n) { return element(n.atom) != kH; });
  }
  bool hasOrder(std::uint32_t i, BondOrder order) const {
    const auto near = links(i);
    return std::any_of(near.begin(), near.end(), [&](const Neighbour& n) { return n.order == order; });
  }

  // Mean angle between the bonds, in degrees.
  double angle(std::uint32_t i) const {
    const auto near = links(i);
    double sum = 0.0;
    int pairs = 0;
    for (std::size_t a = 0; a < near.size(); ++a)
      for (std::size_t b = a + 1; b < near.size(); ++b, ++pairs) {
        const Vec3 u = place(near[a].atom) - place(i), v = place(near[b].atom) - place(i);
        const double size = glm::length(u) * glm::length(v);
        sum += size > 0.0 ? std::acos(std::clamp(glm::dot(u, v) / size, -1.0, 1.0)) : 0.0;
      }
    return pairs ? sum / pairs * 180.0 / std::numbers::pi : 0.0;
  }

  double torsion(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    const Vec3 n = glm::cross(b - a, c - b), o = glm::cross(c - b, d - c);
    return std::abs(std::atan2(glm::dot(glm::cross(n, o), glm::normalize(c - b)), glm::dot(n, o))) * 180.0 /
           std::numbers::pi;
  }

  // Marks the atoms of planar rings of five and six atoms.
  void findRings() {
    std::array<std::uint32_t, 6> path;
    each([&](std::uint32_t i) { growRing(path, 0, i); });
  }
  bool inRing(std::uint32_t i) const {
    return wanted_[i] && (element(i) == kC || element(i) == kN || element(i) == kO || element(i) == kS) &&
           links(i).size() >= 2 && links(i).size() <= kMaxNeighbours;
  }
  void growRing(std::array<std::uint32_t, 6>& path, std::size_t size, std::uint32_t next) {
    if (!inRing(next) || (size && next < path[0])) return;
    if (std::find(path.begin(), path.begin() + std::ptrdiff_t(size), next) != path.begin() + std::ptrdiff_t(size))
      return;
    path[size++] = next;
    if (size >= 5) {
      const auto near = links(next);
      if (std::any_of(near.begin(), near.end(), [&](const Neighbour& n) { return n.atom == path[0]; }))
        judgeRing(path, size);
    }
    if (size == 6) return;
    for (const Neighbour& n : links(next)) growRing(path, size, n.atom);
  }
  void judgeRing(const std::array<std::uint32_t, 6>& ring, std::size_t size) {
    double sum = 0.0;
    for (std::size_t k = 0; k < size; ++k)
      sum += torsion(place(ring[k]), place(ring[(k + 1) % size]), place(ring[(k + 2) % size]),
                     place(ring[(k + 3) % size]));
    if (!(sum / double(size) < (size == 5 ? 7.5 : 12.0))) return;
    // A tetrahedral carbon is in no flat ring of double bonds, and a ring has at least four atoms that could have one.
    for (std::size_t k = 0; k < size; ++k)
      if (links(ring[k]).size() > 3) return;
    for (std::size_t k = 0; k < size; ++k) planar_[ring[k]] = 1;
  }

  void hybridise(std::uint32_t i) {
    AtomValence& v = out_[i];
    if (element(i) == kP || element(i) == kS) return;
    if (ordered(i)) {
      const auto near = links(i);
      const auto doubles =
          std::count_if(near.begin(), near.end(), [](const Neighbour& n) { return n.order == BondOrder::Double; });
      const bool triple = hasOrder(i, BondOrder::Triple);
      const bool nitro = element(i) == kN && doubles >= 2 && near.size() == 3;
      v.multiple = triple || doubles > 0;
      v.hybrid = triple || (doubles >= 2 && !nitro)            ? Hybrid::Sp
                 : doubles || hasOrder(i, BondOrder::Aromatic) ? Hybrid::Sp2
                                                               : Hybrid::Sp3;
      return;
    }
    const std::size_t n = links(i).size();
    if (n > 3 || (element(i) != kC && element(i) != kN)) return;
    const double mean = angle(i);
    if (n == 1) {
      const std::uint32_t other = links(i)[0].atom;
      const double apart = length_A(i, other);
      // Ethynyl and nitrile, whose inner atom is straight.
      if (links(other).size() == 2 && angle(other) > 155.0 && apart < 1.3)
        v.hybrid = Hybrid::Sp, v.multiple = true;
      else if (element(i) == kC && element(other) == kC && apart < 1.42)
        v.hybrid = Hybrid::Sp2;
    } else if (n == 2 && mean > 155.0 && element(i) == kC) {
      v.hybrid = Hybrid::Sp, v.multiple = true;
    } else if (planar_[i] || mean > 115.0) {
      v.hybrid = Hybrid::Sp2;
    }
  }

  // ---- Which atoms share the double bonds: a matching that gives every carbon of three neighbours one.

  bool satisfied(std::uint32_t i) const { return out_[i].multiple || mate_[i] != kNoMate; }
  bool needs(std::uint32_t i) const { return element(i) == kC && out_[i].hybrid == Hybrid::Sp2 && !satisfied(i); }
  // Whether the bond may be double. `third`: also for a nitrogen with three neighbours, which becomes positive.
  bool mayDouble(std::uint32_t i, const Neighbour& n, bool third) const {
    const std::uint32_t j = n.atom;
    if (!wanted_[j] || n.order == BondOrder::Single || n.order == BondOrder::Double || n.order == BondOrder::Triple ||
        out_[j].multiple)
      return false;
    const bool aromatic = n.order == BondOrder::Aromatic, ring = planar_[i] && planar_[j];
    const double apart = length_A(i, j);
    switch (element(j)) {
      case kC:
        return out_[j].hybrid == Hybrid::Sp2 && (aromatic || ring || apart < 1.47);
      case kN:
        return links(j).size() <= (third ? 3u : 2u) && (aromatic || ring || apart < 1.42);
      case kO:
        return ends(j, kO) && (aromatic || apart < (planar_[i] ? 1.30 : 1.36));
      case kS:
        return ends(j, kS) && (aromatic || apart < 1.72);
      default:
        return false;
    }
  }
  double cost(std::uint32_t i, std::uint32_t j) const {
    const double apart = length_A(i, j);
    switch (element(j)) {
      case kO:
        return apart - 10.0;
      case kC:
        return apart;
      case kN:
        return apart + (links(j).size() == 1 ? 0.3 : 0.1);
      default:
        return apart - 5.0;
    }
  }
  void join(std::uint32_t i, std::uint32_t j) { mate_[i] = j, mate_[j] = i; }

  void matchDoubleBonds() {
    std::vector<std::uint32_t> open;
    each([&](std::uint32_t i) {
      if (needs(i)) open.push_back(i);
    });
    // Carbonyl groups first.
    for (const std::uint32_t i : open) {
      std::uint32_t best = kNoMate;
      for (const Neighbour& n : links(i))
        if (element(n.atom) != kC && element(n.atom) != kN && mayDouble(i, n, false) && mate_[n.atom] == kNoMate &&
            (best == kNoMate || cost(i, n.atom) < cost(i, best)))
          best = n.atom;
      if (best != kNoMate) join(i, best);
    }
    // Then the carbon with the fewest choices, which is found among those beside the last.
    for (std::size_t options = 1; options <= kMaxNeighbours; ++options)
      for (std::size_t k = 0; k < open.size(); ++k) {
        std::uint32_t at = open[k];
        while (at != kNoMate && needs(at)) {
          std::uint32_t best = kNoMate;
          std::size_t choices = 0;
          for (const Neighbour& n : links(at))
            if (mayDouble(at, n, false) && mate_[n.atom] == kNoMate) {
              ++choices;
              if (best == kNoMate || cost(at, n.atom) < cost(at, best)) best = n.atom;
            }
          if (choices == 0 || choices > options) break;
          join(at, best);
          std::uint32_t beside = kNoMate;
          for (const std::uint32_t end : {at, best})
            for (const Neighbour& n : links(end))
              if (wanted_[n.atom] && needs(n.atom)) beside = n.atom;
          at = beside;
        }
      }
    for (const Search search : {Search::Carbon, Search::ThirdNeighbour})
      for (const std::uint32_t i : open)
        if (needs(i)) {
          path_steps_ = 0;
          augment(i, search, 0);
        }
    // Of the four nitrogens on a haem's iron two have a double bond.
    const auto onMetal = [&](std::uint32_t i) {
      return element(i) == kN && metal_[i] && !satisfied(i) && links(i).size() == 2;
    };
    each([&](std::uint32_t i) {
      if (!onMetal(i) || m_.atoms[i].residue == kNoResidue) return;
      const Residue& r = m_.residues[m_.atoms[i].residue];
      int free = 0;
      for (std::uint32_t j = r.first_atom; j < r.first_atom + r.atom_count; ++j) free += onMetal(j);
      path_steps_ = 0;
      if (free > 2) augment(i, Search::Metal, 0);
    });
    // A carbon left over: its oxygen at any distance, else it has no double bond.
    for (const std::uint32_t i : open) {
      if (!needs(i)) continue;
      for (const Neighbour& n : links(i))
        if (needs(i) && ends(n.atom, kO) && n.order != BondOrder::Single && wanted_[n.atom] && !planar_[i])
          join(i, n.atom);
      if (needs(i) && !planar_[i] && !ordered(i)) out_[i].hybrid = Hybrid::Sp3;
    }
  }

  // What a path may end at: any free atom, also a nitrogen with three neighbours, or a free nitrogen on a metal.
  enum class Search : std::uint8_t { Carbon, ThirdNeighbour, Metal };
  // Frees a partner for `i` along a path of double and possible double bonds.
  bool augment(std::uint32_t i, Search search, std::size_t depth) {
    if (depth > kMaxPath) return false;
    in_path_[i] = 1;
    bool found = false;
    for (const Neighbour& n : links(i)) {
      if (found || ++path_steps_ > kMaxPathSteps) break;
      const std::uint32_t j = n.atom;
      if (in_path_[j] || !mayDouble(i, n, search == Search::ThirdNeighbour)) continue;
      const std::uint32_t other = mate_[j];
      if (other == kNoMate) {
        found = search != Search::Metal || (element(j) == kN && metal_[j]);
      } else if (!in_path_[other]) {
        in_path_[j] = 1;
        found = element(other) == kN && search != Search::Metal ? (mate_[other] = kNoMate, true)
                                                                : augment(other, search, depth + 1);
        in_path_[j] = 0;
      }
      if (found) join(i, j);
    }
    in_path_[i] = 0;
    return found;
  }

  // ---- Groups, hydrogens, charges.

  // The oxygens of acids share the charge.
  void acids(std::uint32_t i) {
    const std::size_t ends_here = endOxygens(i), n = links(i).size();
    if (element(i) == kS) {
      out_[i].sulfone = ends_here >= 2;
      out_[i].multiple = ends_here > 0;
    }
    if (element(i) == kP) out_[i].multiple = ends_here > 0;
    double charge_e = 0.0;
    if (element(i) == kC && out_[i].hybrid == Hybrid::Sp2 && ends_here >= 2) charge_e = ends_here == 2 ? -1.0 : -2.0;
    if (element(i) == kS) charge_e = ends_here == 4 ? -2.0 : ends_here == 3 || (ends_here == 2 && n == 3) ? -1.0 : 0.0;
    if (element(i) == kP && ends_here) charge_e = ends_here == 4 ? -2.0 : 1.0 - double(ends_here);
    if (element(i) == kN && ends_here >= 2) {
      charge_e = ends_here == 3 ? -2.0 : -1.0;
      out_[i].formal_e = 1.0f, out_[i].multiple = true, out_[i].hybrid = Hybrid::Sp2;
    }
    const bool group = charge_e != 0.0 || (element(i) == kS && ends_here >= 1) || (element(i) == kP && ends_here >= 1);
    if (!group) return;
    for (const Neighbour& near : links(i))
      if (ends(near.atom, kO) && wanted_[near.atom]) {
        AtomValence& o = out_[near.atom];
        o.formal_e = float(charge_e / double(ends_here));
        o.hybrid = Hybrid::Sp2, o.multiple = true;
      }
  }

  // The lone pair of a nitrogen or an oxygen beside a double bond is conjugated (amides, esters, anilines, phenols).
  void conjugate(std::uint32_t i) {
    if ((element(i) != kN && element(i) != kO) || out_[i].multiple) return;
    const auto near = links(i);
    // The carbon of another residue's template is that of a peptide bond, or a sugar's.
    const bool beside = std::any_of(near.begin(), near.end(), [&](const Neighbour& n) {
      if (element(n.atom) != kC) return false;
      return wanted_[n.atom] ? out_[n.atom].multiple || planar_[n.atom] : element(i) == kN;
    });
    out_[i].conjugated = beside && element(i) == kN;
    out_[i].hybrid = beside ? Hybrid::Sp2 : Hybrid::Sp3;
  }

  enum class Present : std::uint8_t { None, Polar, All };
  // The hydrogens that the file has in the atom's residue.
  Present present(std::uint32_t i) {
    const std::uint32_t of = m_.atoms[i].residue;
    if (of == kNoResidue) return Present::All;
    if (of == last_residue_) return last_present_;
    const Residue& r = m_.residues[of];
    last_residue_ = of, last_present_ = Present::None;
    for (std::uint32_t h = r.first_atom; h < r.first_atom + r.atom_count; ++h) {
      if (element(h) != kH) continue;
      if (last_present_ == Present::None) last_present_ = Present::Polar;
      if (count(h, kC)) last_present_ = Present::All;
    }
    return last_present_;
  }

  void hydrogens(std::uint32_t i) {
    AtomValence& v = out_[i];
    const Present there = present(i);
    const int n = int(links(i).size()), own = int(count(i, kH)), others = n - own;
    const auto add = [&](int wanted) { v.hydrogens = std::uint8_t(std::clamp(wanted, 0, 4)); };
    switch (element(i)) {
      case kC:
        if (there != Present::All)
          add((v.hybrid == Hybrid::Sp3 ? 4 : v.hybrid == Hybrid::Sp2 ? 3 : 2) - n - (metal_[i] ? 1 : 0));
        return;
      case kN: {
        if (v.formal_e != 0.0f) return;  // nitro
        const int bonds = n + (v.hybrid == Hybrid::Sp && v.multiple ? 2 : v.multiple ? 1 : 0);
        if (bonds >= 4) {
          v.formal_e = 1.0f;
        } else if (bonds == 2 && metal_[i]) {
          v.formal_e = -1.0f;
        } else if (there == Present::None) {
          const auto near = links(i);
          const bool amine =
              !v.multiple && !metal_[i] && others > 0 && std::all_of(near.begin(), near.end(), [&](const Neighbour& o) {
                return element(o.atom) == kC && wanted_[o.atom] && out_[o.atom].hybrid == Hybrid::Sp3;
              });
          add(3 - bonds + amine);
          if (amine) v.formal_e = 1.0f;
        } else if (bonds < 3) {
          v.formal_e = float(bonds - 3);
        }
        return;
      }
      case kO:
        if (v.multiple || n >= 2) {
          if (n >= 3) v.formal_e = 1.0f;
          return;
        }
        if (n == 1 && element(links(i)[0].atom) == kN && links(links(i)[0].atom).size() >= 3 &&
            (out_[links(i)[0].atom].multiple || links(links(i)[0].atom).size() == 4)) {
          v.formal_e = -1.0f;  // an N-oxide
          return;
        }
        if (there == Present::None && !metal_[i])
          add(2 - n);
        else if (there != Present::None || n == 1)
          v.formal_e = float(n - 2);
        return;
      case kS:
        if (v.multiple || n >= 2) return;
        if (there == Present::None && !metal_[i])
          add(2 - n);
        else
          v.formal_e = float(n - 2);
        return;
      default:
        return;
    }
  }

  // An amidine or guanidine takes a proton, and its nitrogens share the charge.
  void amidines(std::uint32_t i) {
    if (element(i) != kC || planar_[i] || mate_[i] == kNoMate || element(mate_[i]) != kN) return;
    const std::uint32_t imine = mate_[i];
    std::vector<std::uint32_t> nitrogens;
    for (const Neighbour& n : links(i)) {
      if (element(n.atom) != kN || !wanted_[n.atom]) continue;
      if (planar_[n.atom] || metal_[n.atom]) return;
      // An imine of an oxime or a hydrazone, or beside a carbonyl group or a sulphonyl group, has no basic pair.
      for (const Neighbour& far : links(n.atom))
        if (far.atom != i && element(far.atom) != kH &&
            (element(far.atom) != kC || (wanted_[far.atom] && endOxygens(far.atom))))
          return;
      nitrogens.push_back(n.atom);
    }
    if (nitrogens.size() < 2) return;
    if (present(i) == Present::None) {
      if (out_[imine].formal_e != 0.0f) return;
      ++out_[imine].hydrogens;
    } else if (out_[imine].formal_e <= 0.0f) {
      return;
    }
    for (const std::uint32_t n : nitrogens) {
      out_[n].formal_e = 1.0f / float(nitrogens.size());
      out_[n].conjugated = true, out_[n].hybrid = Hybrid::Sp2;
    }
  }

  const Molecule& m_;
  const std::vector<char>& wanted_;
  std::vector<AtomValence> out_;
  std::vector<std::uint32_t> begin_;
  std::vector<Neighbour> links_;
  std::vector<char> metal_, planar_, in_path_;
  std::vector<std::uint32_t> mate_;  // the other end of a double bond
  int path_steps_ = 0;
  std::uint32_t last_residue_ = kNoResidue;
  Present last_present_ = Present::None;
};

}  // namespace

std::vector<AtomValence> atomValences(const Molecule& molecule, std::span<const Bond> bonds,
                                      const std::vector<char>& wanted) {
  return ValenceFinder(molecule, bonds, wanted).run();
}

}  // namespace moltact
