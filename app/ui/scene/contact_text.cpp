#include "app/ui/scene/contact_text.h"

#include <cmath>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/molecule/elements.h"

namespace moltact {
// "carbon CA of Ala 3", "nitrogen N of Gly 4 (chain B)", "zinc 201", "argon atom 2"; without its owner: "carbon CA".
std::string atomText(const Molecule& molecule, std::size_t index, bool with_owner) {
  const Atom& atom = molecule.atoms[index];
  const std::string name(atom.atomic_number ? tr(element(atom.atomic_number).name) : std::string_view());
  if (atom.residue == kNoResidue) return name.empty() ? trf("atom {0}", index) : trf("{0} atom {1}", name, index);
  const AtomWords words = molecule.words(index);
  // The description of an atom that is a residue of its own already contains its element.
  if (words.residue.empty()) return molecule.describe(index);
  const std::string whole = name.empty() ? words.atom : name + ' ' + words.atom;
  if (!with_owner) return whole;
  if (molecule.chains.size() == 1 || words.chain.empty()) return trcf("an atom", "{0} of {1}", whole, words.residue);
  return trf("{0} of {1} (chain {2})", whole, words.residue, words.chain);
}

std::string touchedText(const Molecule& molecule, const Contact& contact, bool body) {
  std::vector<std::size_t> atoms;
  for (const std::int32_t atom : contact.atoms)
    if (atom >= 0 && std::size_t(atom) < molecule.atoms.size()) atoms.push_back(std::size_t(atom));
  if (!contact.touching() || atoms.empty()) return {};
  const auto together = [&](std::size_t j, std::size_t k) {
    const std::uint32_t owner = molecule.atoms[atoms[j]].residue;
    return owner != kNoResidue && owner == molecule.atoms[atoms[k]].residue;
  };
  const std::string first = atomText(molecule, atoms[0], true);
  if (atoms.size() == 1) return first;
  // Each owner is named only once: "its carbon C", "carbon C and oxygen O of Ala 3".
  std::string others;
  for (std::size_t k = 1; k < atoms.size(); ++k) {
    const bool its = together(0, k), said = its && k == 2 && together(0, 1);
    const bool owner_follows = k == 1 && atoms.size() == 3 && together(1, 2);
    std::string one = atomText(molecule, atoms[k], !its && !owner_follows);
    if (its && !said) one = trf("its {0}", one);
    others = k == 1 ? one : trf("{0} and {1}", others, one);
  }
  if (body) return atoms.size() == 2 ? trf("{0} and {1}", first, others) : trcf("a list", "{0}, {1}", first, others);
  return contact.feature == Feature::Point ? trf("{0}, pit with {1}", first, others)
                                           : trf("{0}, crease with {1}", first, others);
}

std::string contactText(const Molecule* molecule, const Contact& contact, double force_N, bool force_on, bool body) {
  if (!molecule) return tr("no molecule");
  if (contact.fault == Fault::StartedInside)
    return body ? tr("What you hold overlaps the molecule: draw it out once to feel it again")
                : tr("You are inside the molecule: come out once to feel its surface");
  if (contact.fault == Fault::NotFinite) return tr("the device gives no sound position: no force");
  if (!contact.touching()) return tr("not touching");
  return touchingText(touchedText(*molecule, contact, body), force_N, force_on);
}

std::string feltText(const Molecule* molecule, const ServoSample& now, double force_N, bool force_on) {
  if (!molecule || now.contact.touching() || !now.felt())
    return contactText(molecule, now.contact, force_N, force_on, now.holds_body);
  return trf("not touching, a force of {0}", quantityText(force_N, Dimension::Force, decimals(1)));
}

std::string touchingText(const std::string& touched, double force_N, bool force_on) {
  // The substrate of a scan.
  if (touched.empty())
    return force_on ? trf("touching, {0}", quantityText(force_N, Dimension::Force, decimals(1)))
                    : tr("touching, force is off");
  return force_on ? trf("touching: {0}, {1}", touched, quantityText(force_N, Dimension::Force, decimals(1)))
                  : trf("touching: {0}, force is off", touched);
}

std::string unnamedContactText(const Contact& contact, bool felt, bool body) {
  if (contact.fault == Fault::StartedInside)
    return body ? tr("What you hold overlaps the molecule. Draw it out until it is free.")
                : tr("You are inside the molecule. Draw back until you are outside.");
  if (contact.touching()) return tr("touching");
  return felt ? tr("a force is felt") : tr("not touching");
}

std::string pushText(const Vec3& direction) {
  constexpr double kStraight = 0.26,
                   kAside = 0.38;  // sine of 15 degrees; of half the angle between two of eight directions
  const double sideways = std::hypot(direction.x, direction.y);
  if (sideways < kStraight) return direction.z >= 0.0 ? tr("pushed toward you") : tr("pushed away from you");
  const double x = direction.x / sideways, y = direction.y / sideways;
  const int right = x > kAside ? 1 : x < -kAside ? -1 : 0, up = y > kAside ? 1 : y < -kAside ? -1 : 0;
  if (up > 0) {
    if (right > 0) return tr("pushed up and to the right");
    return right < 0 ? tr("pushed up and to the left") : tr("pushed up");
  }
  if (up < 0) {
    if (right > 0) return tr("pushed down and to the right");
    return right < 0 ? tr("pushed down and to the left") : tr("pushed down");
  }
  return right > 0 ? tr("pushed to the right") : tr("pushed to the left");
}

}  // namespace moltact
