#include "app/ui/contact_text.h"

#include <cstdio>
#include <vector>

namespace moltact {
namespace {

std::string join(const std::vector<std::string>& parts) {
  std::string out;
  for (std::size_t k = 0; k < parts.size(); ++k) out += (k == 0 ? "" : k + 1 == parts.size() ? " and " : ", ") + parts[k];
  return out;
}

// "O of Asp 52 (chain A)" as Molecule::describe says it, parted at the first " of ".
std::pair<std::string, std::string> split(const std::string& whole) {
  const std::size_t at = whole.find(" of ");
  if (at == std::string::npos) return {whole, {}};
  return {whole.substr(0, at), whole.substr(at + 4)};
}

}  // namespace

std::string atomsText(const Molecule& molecule, const std::array<std::int32_t, 3>& atoms) {
  std::vector<std::string> groups, names;
  std::string owner;
  const auto close = [&] {
    if (!names.empty()) groups.push_back(join(names) + (owner.empty() ? "" : " of " + owner));
    names.clear();
  };
  for (const std::int32_t atom : atoms) {
    if (atom < 0 || std::size_t(atom) >= molecule.atoms.size()) continue;
    auto [name, of] = split(molecule.describe(std::size_t(atom)));
    if (!names.empty() && of != owner) close();
    owner = of;
    names.push_back(name);
  }
  close();
  return join(groups);
}

std::string contactText(const Molecule* molecule, const Contact& contact, double force_N) {
  if (!molecule) return "no molecule";
  if (contact.fault == Fault::StartedInside) return "You are inside the molecule: come out once to feel its surface";
  if (contact.fault == Fault::NotFinite) return "the device gives no sound position: no force";
  if (!contact.touching()) return "not touching";
  const std::string atoms = atomsText(*molecule, contact.atoms);
  const char* what = contact.feature == Feature::Sphere ? "" : contact.feature == Feature::Circle ? "crease between " : "pit between ";
  char force[32];
  std::snprintf(force, sizeof force, ", %.1f N", force_N);
  return "touching: " + std::string(what) + atoms + force;
}

}  // namespace moltact
