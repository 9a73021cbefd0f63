#include "engine/structure/lewis_structure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/structure/amber/valences.h"
#include "engine/structure/atom_charges.h"
#include "engine/structure/bonds.h"

namespace moltact {
namespace {

constexpr int kLewisCarbon = 6, kLewisNitrogen = 7, kLewisOxygen = 8, kLewisPhosphorus = 15, kLewisSulphur = 16;

class LewisFinder {
 public:
  LewisFinder(const Molecule& m, const std::vector<char>& wanted)
      : m_(m), wanted_(wanted), stated_(!m.listed_bonds.empty()), of_geometry_(m.atoms.size(), 0) {
    out_.bonds = findBonds(m);
    out_.formal_charges_e.assign(m.atoms.size(), 0);
    for (std::size_t i = 0; i < m.atoms.size(); ++i) {
      const std::uint32_t r = m.atoms[i].residue;
      of_geometry_[i] =
          wanted[i] && (stated_ || r == kNoResidue || formulaBonds(std::string_view(m.residues[r].name)).empty());
    }
    for (const Bond& b : out_.bonds) was_open_.push_back(open(b));
    near_.resize(m.atoms.size());
    for (std::size_t k = 0; k < out_.bonds.size(); ++k) {
      const Bond& b = out_.bonds[k];
      if (!wanted[b.first] && !wanted[b.second]) continue;
      near_[b.first].push_back(k);
      near_[b.second].push_back(k);
    }
  }

  LewisStructure run() {
    valences_ = atomValences(m_, out_.bonds, of_geometry_);
    setDoubleBonds();
    each([&](std::uint32_t i) { setOxygens(i); });
    for (Bond& b : out_.bonds)
      if (wanted_[b.first] && wanted_[b.second] && b.order == BondOrder::Unknown) b.order = BondOrder::Single;
    setCharges();
    return std::move(out_);
  }

 private:
  template <class Visit>
  void each(Visit visit) {
    for (std::uint32_t i = 0; i < m_.atoms.size(); ++i)
      if (wanted_[i]) visit(i);
  }
  int element(std::uint32_t i) const { return m_.atoms[i].atomic_number; }
  static std::uint32_t other(const Bond& b, std::uint32_t i) { return b.first == i ? b.second : b.first; }
  bool open(const Bond& b) const { return b.order == BondOrder::Unknown || b.order == BondOrder::Aromatic; }
  bool within(const Bond& b) const { return of_geometry_[b.first] && of_geometry_[b.second]; }

  void setDoubleBonds() {
    constexpr auto kSp = AtomValence::Hybrid::Sp;
    // Rings in which an atom has no partner stay aromatic, with all rings that are joined to them.
    std::vector<char> stays(m_.atoms.size(), 0);
    std::vector<std::uint32_t> next;
    each([&](std::uint32_t i) {
      if (element(i) == kLewisCarbon && valences_[i].partner == kNoResidue && !valences_[i].multiple &&
          aromaticBonds(i) >= 2)
        next.push_back(i), stays[i] = 1;
    });
    while (!next.empty()) {
      const std::uint32_t i = next.back();
      next.pop_back();
      for (const std::size_t k : near_[i]) {
        const std::uint32_t j = other(out_.bonds[k], i);
        if (out_.bonds[k].order == BondOrder::Aromatic && !stays[j]) stays[j] = 1, next.push_back(j);
      }
    }
    for (Bond& b : out_.bonds) {
      if (!within(b) || !open(b) || stays[b.first]) continue;
      const AtomValence &first = valences_[b.first], &second = valences_[b.second];
      const bool straight = first.hybrid == kSp && second.hybrid == kSp && first.multiple && second.multiple &&
                            first.partner == kNoResidue && second.partner == kNoResidue;
      // Between two triple bonds, as in a diyne, is a single one of 1.38 A.
      constexpr double kTriple_A = 1.29;
      if (first.partner == b.second && second.partner == b.first)
        b.order = BondOrder::Double;
      else if (straight && length_A(b) < kTriple_A)
        b.order = BondOrder::Triple;
      else if (b.order == BondOrder::Aromatic)
        b.order = BondOrder::Single;
    }
  }
  std::size_t aromaticBonds(std::uint32_t i) const {
    return std::size_t(std::count_if(near_[i].begin(), near_[i].end(),
                                     [&](std::size_t k) { return out_.bonds[k].order == BondOrder::Aromatic; }));
  }
  double length_A(const Bond& b) const {
    const auto& places = m_.spheresAsRead();
    return glm::distance(places[b.first].centre_A, places[b.second].centre_A);
  }

  // The oxygens of sulphur, phosphorus and nitro groups whose bonds have no stated order: those that carry no charge
  // have double bonds, of phosphorus and nitrogen one.
  void setOxygens(std::uint32_t i) {
    if (element(i) != kLewisSulphur && element(i) != kLewisPhosphorus && element(i) != kLewisNitrogen) return;
    std::vector<std::size_t> ends;
    double charge_e = 0.0;
    for (const std::size_t k : near_[i]) {
      const std::uint32_t o = other(out_.bonds[k], i);
      if (element(o) != kLewisOxygen || near_[o].size() != 1 || !within(out_.bonds[k])) continue;
      if (!was_open_[k]) return;
      if (!valences_[o].multiple) continue;
      ends.push_back(k);
      charge_e += double(valences_[o].formal_e);
    }
    if (ends.empty()) return;
    const std::size_t charged = std::min(ends.size(), std::size_t(std::lround(std::abs(charge_e))));
    const std::size_t doubles = element(i) == kLewisSulphur ? ends.size() - charged : 1;
    for (std::size_t k = 0; k < ends.size(); ++k)
      out_.bonds[ends[k]].order = k < doubles ? BondOrder::Double : BondOrder::Single;
  }

  bool hasDouble(std::uint32_t i) const {
    return std::any_of(near_[i].begin(), near_[i].end(),
                       [&](std::size_t k) { return out_.bonds[k].order == BondOrder::Double; });
  }

  // The charge that the stated orders of an atom's bonds give it: an ammonium's nitrogen.
  std::int8_t ofOrders(std::uint32_t i) const {
    int sum = 0;
    for (const std::size_t k : near_[i])
      sum += out_.bonds[k].order == BondOrder::Single   ? 1
             : out_.bonds[k].order == BondOrder::Double ? 2
             : out_.bonds[k].order == BondOrder::Triple ? 3
                                                        : 0;
    return element(i) == kLewisNitrogen && sum == 4 ? 1 : 0;
  }
  bool wasOpen(std::uint32_t i) const {
    return std::any_of(near_[i].begin(), near_[i].end(), [&](std::size_t k) { return bool(was_open_[k]); });
  }

  bool statesCharges(std::uint32_t i) const {
    if (m_.formal_charges_e.empty()) return false;
    if (stated_ || m_.atoms[i].residue == kNoResidue) return true;
    const Residue& r = m_.residues[m_.atoms[i].residue];
    const auto first = m_.formal_charges_e.begin() + std::ptrdiff_t(r.first_atom);
    return std::any_of(first, first + std::ptrdiff_t(r.atom_count), [](std::int8_t c) { return c != 0; });
  }

  void setCharges() {
    std::vector<float> shares = formalCharges_e(m_);
    for (std::size_t i = 0; i < shares.size(); ++i)
      if (of_geometry_[i]) shares[i] = valences_[i].formal_e;
    std::vector<char> done(m_.atoms.size(), 0);
    each([&](std::uint32_t i) {
      if (statesCharges(i)) {
        if (!m_.formal_charges_e.empty()) out_.formal_charges_e[i] = m_.formal_charges_e[i];
        shares[i] = 0.0f;
        return;
      }
      if (stated_ && !wasOpen(i)) {
        out_.formal_charges_e[i] = ofOrders(i);
        shares[i] = 0.0f;
        return;
      }
      const double whole = std::round(double(shares[i]));
      if (std::abs(double(shares[i]) - whole) > 1e-3) return;
      out_.formal_charges_e[i] = static_cast<std::int8_t>(whole);
      shares[i] = 0.0f;
    });
    // What is left is shared by the neighbours of one atom, as in a carboxylate, or by two atoms of a ring.
    each([&](std::uint32_t i) {
      std::vector<std::uint32_t> sharers;
      double sum_e = 0.0;
      for (const std::size_t k : near_[i])
        if (const std::uint32_t j = other(out_.bonds[k], i); wanted_[j] && shares[j] != 0.0f) {
          sharers.push_back(j);
          sum_e += double(shares[j]);
        }
      if (sharers.size() < 2) return;
      const int sign = sum_e < 0.0 ? -1 : 1;
      long left = std::lround(std::abs(sum_e));
      // A negative charge goes to an atom with single bonds, a positive one to an atom with a double bond.
      std::stable_sort(sharers.begin(), sharers.end(), [&](std::uint32_t a, std::uint32_t b) {
        return sign < 0 ? hasDouble(a) < hasDouble(b) : hasDouble(a) > hasDouble(b);
      });
      for (const std::uint32_t j : sharers) {
        shares[j] = 0.0f;
        if (left > 0) out_.formal_charges_e[j] = static_cast<std::int8_t>(sign), --left;
      }
    });
  }

  const Molecule& m_;
  const std::vector<char>& wanted_;
  const bool stated_;                           // the file lists its bonds
  std::vector<char> of_geometry_;               // atoms whose orders atomValences() finds
  std::vector<char> was_open_;                  // bonds whose order the file leaves open
  std::vector<std::vector<std::size_t>> near_;  // bonds of each atom
  std::vector<AtomValence> valences_;
  LewisStructure out_;
};

}  // namespace

LewisStructure lewisStructure(const Molecule& molecule, const std::vector<char>& wanted) {
  return LewisFinder(molecule, wanted).run();
}

}  // namespace moltact
