#include "app/ui/scene/contact_text.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include "engine/molecule/elements.h"

namespace moltact {
namespace {

// "carbon CA of Ala 3", "nitrogen N of Gly 4 (chain B)", "zinc 201", "argon atom 2"; without its owner: "carbon CA".
std::string atomText(const Molecule& molecule, std::size_t index, bool with_owner) {
  const Atom& atom = molecule.atoms[index];
  std::string name(atom.atomic_number ? element(atom.atomic_number).name : std::string_view());
  if (atom.residue == kNoResidue) return (name.empty() ? "" : name + ' ') + "atom " + std::to_string(index);
  std::string whole = molecule.describe(index);
  // An atom that is a residue of its own is described by its element already.
  const std::size_t of = whole.find(" of ");
  if (of == std::string::npos) return whole;
  std::string owner = whole.substr(of);
  if (molecule.chains.size() == 1) owner = owner.substr(0, owner.find(" (chain"));
  if (!name.empty()) name += ' ';
  name += whole.substr(0, of);
  return with_owner ? name + owner : name;
}

}  // namespace

std::string touchedText(const Molecule& molecule, const Contact& contact) {
  std::vector<std::size_t> atoms;
  for (const std::int32_t atom : contact.atoms)
    if (atom >= 0 && std::size_t(atom) < molecule.atoms.size()) atoms.push_back(std::size_t(atom));
  if (!contact.touching() || atoms.empty()) return {};
  const auto together = [&](std::size_t j, std::size_t k) {
    const std::uint32_t owner = molecule.atoms[atoms[j]].residue;
    return owner != kNoResidue && owner == molecule.atoms[atoms[k]].residue;
  };
  std::string out = atomText(molecule, atoms[0], true);
  if (atoms.size() == 1) return out;
  out += contact.feature == Feature::Point ? ", pit with " : ", crease with ";
  // Owners are named once: "its carbon C", "carbon C and oxygen O of Ala 3".
  for (std::size_t k = 1; k < atoms.size(); ++k) {
    if (k == 2) out += " and ";
    const bool its = together(0, k), said = its && k == 2 && together(0, 1);
    const bool owner_follows = k == 1 && atoms.size() == 3 && together(1, 2);
    out += (its && !said ? "its " : "") + atomText(molecule, atoms[k], !its && !owner_follows);
  }
  return out;
}

std::string contactText(const Molecule* molecule, const Contact& contact, double force_N, bool force_on) {
  if (!molecule) return "no molecule";
  if (contact.fault == Fault::StartedInside) return "You are inside the molecule: come out once to feel its surface";
  if (contact.fault == Fault::NotFinite) return "the device gives no sound position: no force";
  if (!contact.touching()) return "not touching";
  char force[32];
  std::snprintf(force, sizeof force, ", %.1f N", force_N);
  return "touching: " + touchedText(*molecule, contact) + (force_on ? force : ", force is off");
}

std::string unnamedContactText(const Contact& contact) {
  if (contact.fault == Fault::StartedInside) return "You are inside the molecule. Draw back until you are outside.";
  switch (contact.feature) {
    case Feature::Free:
      break;
    case Feature::Sphere:
      return "touching the round face of an atom";
    case Feature::Circle:
      return "touching a crease between two atoms";
    case Feature::Point:
      return "touching a pit between three atoms";
  }
  return "not touching";
}

std::string pushText(const Vec3& direction) {
  constexpr double kStraight = 0.26,
                   kAside = 0.38;  // sine of 15 degrees; of half the angle between two of eight directions
  const double sideways = std::hypot(direction.x, direction.y);
  if (sideways < kStraight) return direction.z >= 0.0 ? "pushed toward you" : "pushed away from you";
  const double x = direction.x / sideways, y = direction.y / sideways;
  const std::string up = y > kAside    ? "up"
                         : y < -kAside ? "down"
                                       : "",
                    right = x > kAside    ? "to the right"
                            : x < -kAside ? "to the left"
                                          : "";
  return "pushed " + up + (up.empty() || right.empty() ? "" : " and ") + right;
}

}  // namespace moltact
