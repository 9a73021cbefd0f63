#include "engine/structure/hydrogen_bonds.h"

#include <algorithm>
#include <string_view>

#include "engine/haptics/sphere_grid.h"

namespace moltact {
namespace {

constexpr double kMaxLength_A = 3.5, kMinLength_A = 2.2;
constexpr std::uint8_t kHydrogen = 1, kNitrogen = 7, kOxygen = 8;

struct Role {
  bool gives = false, takes = false;
};

// Atoms of residues with a formula, by residue and name; "*" means every amino acid or every nucleotide.
struct RoleRow {
  std::string_view residues, atom;
  Role role;
};
constexpr Role kGives{true, false}, kTakes{false, true}, kBoth{true, true};
constexpr RoleRow kAminoRoles[] = {
    {"*", "N", kGives},     {"*", "O", kTakes},     {"*", "OXT", kTakes},   {"SER", "OG", kBoth},
    {"THR", "OG1", kBoth},  {"TYR", "OH", kBoth},   {"ASN", "ND2", kGives}, {"ASN", "OD1", kTakes},
    {"GLN", "NE2", kGives}, {"GLN", "OE1", kTakes}, {"LYS", "NZ", kGives},  {"ARG", "NE", kGives},
    {"ARG", "NH1", kGives}, {"ARG", "NH2", kGives}, {"HIS", "ND1", kBoth},  {"HIS", "NE2", kBoth},
    {"TRP", "NE1", kGives}, {"ASP", "OD1", kTakes}, {"ASP", "OD2", kTakes}, {"GLU", "OE1", kTakes},
    {"GLU", "OE2", kTakes},
};
constexpr RoleRow kNucleotideRoles[] = {
    {"*", "O2'", kBoth},
    {"*", "O3'", kTakes},
    {"*", "O4'", kTakes},
    {"*", "O5'", kTakes},
    {"*", "OP1", kTakes},
    {"*", "OP2", kTakes},
    {"*", "OP3", kTakes},
    {"A DA", "N6", kGives},
    {"A DA", "N1", kTakes},
    {"A DA G DG", "N3", kTakes},
    {"A DA G DG", "N7", kTakes},
    {"G DG", "N1", kGives},
    {"G DG", "N2", kGives},
    {"G DG", "O6", kTakes},
    {"C DC", "N4", kGives},
    {"C DC", "N3", kTakes},
    {"C DC U DU T DT", "O2", kTakes},
    {"U DU T DT", "N3", kGives},
    {"U DU T DT", "O4", kTakes},
};

bool holdsWord(std::string_view list, std::string_view word) {
  for (std::size_t at = list.find(word); at != std::string_view::npos; at = list.find(word, at + 1))
    if ((at == 0 || list[at - 1] == ' ') && (at + word.size() == list.size() || list[at + word.size()] == ' '))
      return true;
  return false;
}

template <std::size_t N>
const Role* roleIn(const RoleRow (&rows)[N], std::string_view residue, std::string_view atom) {
  for (const RoleRow& row : rows)
    if (row.atom == atom && (row.residues == "*" || holdsWord(row.residues, residue))) return &row.role;
  return nullptr;
}

/// The role by bonds: an explicit hydrogen is a donor's; without one, by the hydrogens that the element's valence
/// permits.
Role roleByBonds(const Molecule& m, const BondTable& bonds, std::uint32_t atom) {
  std::size_t heavy = 0;
  bool hydrogen = false;
  for (const std::uint32_t n : bonds.neighbours(atom)) {
    hydrogen = hydrogen || m.atoms[n].atomic_number == kHydrogen;
    heavy += m.atoms[n].atomic_number != kHydrogen;
  }
  const std::size_t limit = m.atoms[atom].atomic_number == kOxygen ? 1 : 2;
  return {hydrogen || heavy <= limit, m.atoms[atom].atomic_number == kOxygen || heavy <= limit};
}

Role roleOf(const Molecule& m, const BondTable& bonds, std::uint32_t index) {
  const Atom& atom = m.atoms[index];
  if (atom.residue == kNoResidue) return roleByBonds(m, bonds, index);
  const Residue& r = m.residues[atom.residue];
  if (formulaBonds(r.name).empty()) return roleByBonds(m, bonds, index);
  const std::string_view name = formulaName(r.name, atom.nameText());
  if (r.kind == ResidueKind::AminoAcid) {
    if (name == "N" && r.name == "PRO") return {};
    if (const Role* role = roleIn(kAminoRoles, r.name, name)) return *role;
  } else if (const Role* role = roleIn(kNucleotideRoles, r.name, name)) {
    return *role;
  }
  return {};
}

/// True if every angle at `at`, between `to` and an atom bonded to `at`, is at least 90 degrees.
bool open(const Molecule& m, const BondTable& bonds, std::uint32_t at, std::uint32_t to) {
  const Vec3 here = m.spheres[at].centre_A, direction = m.spheres[to].centre_A - here;
  for (const std::uint32_t n : bonds.neighbours(at))
    if (m.atoms[n].atomic_number != kHydrogen && glm::dot(m.spheres[n].centre_A - here, direction) > 0.0) return false;
  return true;
}

bool isPolar(const Atom& atom) { return atom.atomic_number == kNitrogen || atom.atomic_number == kOxygen; }

bool inOrder(const HydrogenBond& x, const HydrogenBond& y) {
  return std::pair(x.donor, x.acceptor) < std::pair(y.donor, y.acceptor);
}

}  // namespace

std::vector<HydrogenBond> findHydrogenBonds(const Molecule& m, const BondTable& bonds) {
  std::vector<std::uint32_t> polar;
  std::vector<Role> roles;
  std::vector<Sphere> places;
  for (std::uint32_t i = 0; i < m.atoms.size(); ++i) {
    if (!isPolar(m.atoms[i])) continue;
    const Role role = roleOf(m, bonds, i);
    if (!role.gives && !role.takes) continue;
    polar.push_back(i);
    roles.push_back(role);
    places.push_back({m.spheres[i].centre_A, 0.0});
  }
  const SphereGrid grid(std::move(places), SphereGrid::Duplicates::VisitEach);
  std::vector<HydrogenBond> out;
  for (std::uint32_t a = 0; a < polar.size(); ++a)
    grid.visitCentresNear(grid[a].centre_A, kMaxLength_A, [&](std::uint32_t b, const Sphere& sphere) {
      if (b <= a) return;
      const std::uint32_t i = polar[a], j = polar[b];
      const double length = glm::distance(grid[a].centre_A, sphere.centre_A);
      if (length > kMaxLength_A || length < kMinLength_A) return;
      if (m.atoms[i].residue == m.atoms[j].residue && m.atoms[i].residue != kNoResidue) return;
      const bool forth = roles[a].gives && roles[b].takes, back = roles[b].gives && roles[a].takes;
      if ((!forth && !back) || bonds.bonded(i, j) || !open(m, bonds, i, j) || !open(m, bonds, j, i)) return;
      if (forth)
        out.push_back({i, j, length});
      else
        out.push_back({j, i, length});
    });
  std::sort(out.begin(), out.end(), inOrder);
  return out;
}

HeldHydrogenBonds::HeldHydrogenBonds(const Molecule& m, const SphereGrid& spheres, const HeldBody& body)
    : grid_(std::vector<Sphere>()) {
  const BondTable bonds(m.atoms.size(), findBonds(m));
  std::vector<Sphere> places;
  for (std::uint32_t i = 0; i < m.atoms.size(); ++i) {
    if (!isPolar(m.atoms[i])) continue;
    const auto of_body = std::lower_bound(body.atoms.begin(), body.atoms.end(), i);
    const bool held = of_body != body.atoms.end() && *of_body == i;
    if (!held && !spheres.touchable(i)) continue;
    const Role role = roleOf(m, bonds, i);
    if (!role.gives && !role.takes) continue;
    // A body's atoms keep the places of the file relative to each other.
    const auto placeOf = [&](std::uint32_t a) {
      return held ? m.spheres[a].centre_A - body.middle.A : spheres[a].centre_A;
    };
    Polar polar{.atom = i, .gives = role.gives, .takes = role.takes, .place_A = placeOf(i), .neighbours = {}};
    for (const std::uint32_t n : bonds.neighbours(i))
      if (m.atoms[n].atomic_number != kHydrogen) polar.neighbours.push_back(placeOf(n));
    if (!held) places.push_back({polar.place_A, 0.0});
    (held ? body_ : scene_).push_back(std::move(polar));
  }
  grid_ = SphereGrid(std::move(places), SphereGrid::Duplicates::VisitEach);
}

std::vector<HydrogenBond> HeldHydrogenBonds::at(const PoseA& pose) const {
  std::vector<HydrogenBond> out;
  if (!finite(pose.place.A) || !rotates(pose.orientation)) return out;
  const auto obtuse = [](const std::vector<Vec3>& neighbours, const Vec3& here, const Vec3& to) {
    return std::none_of(neighbours.begin(), neighbours.end(),
                        [&](const Vec3& n) { return glm::dot(n - here, to - here) > 0.0; });
  };
  for (const Polar& b : body_) {
    const Vec3 place = pose.place.A + pose.orientation * b.place_A;
    grid_.visitCentresNear(place, kMaxLength_A, [&](std::uint32_t k, const Sphere& sphere) {
      const Polar& a = scene_[k];
      const double length = glm::distance(place, sphere.centre_A);
      const bool gives = b.gives && a.takes;
      if (length > kMaxLength_A || length < kMinLength_A || (!gives && !(a.gives && b.takes))) return;
      const Vec3 back = glm::conjugate(pose.orientation) * (sphere.centre_A - pose.place.A);
      if (!obtuse(a.neighbours, sphere.centre_A, place) || !obtuse(b.neighbours, b.place_A, back)) return;
      out.push_back(gives ? HydrogenBond{b.atom, a.atom, length} : HydrogenBond{a.atom, b.atom, length});
    });
  }
  std::sort(out.begin(), out.end(), inOrder);
  return out;
}

}  // namespace moltact
