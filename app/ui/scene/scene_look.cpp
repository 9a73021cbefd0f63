#include "app/ui/scene/scene_look.h"

#include <algorithm>
#include <cstdint>

#include "engine/render/molecule_model.h"

namespace moltact {

std::shared_ptr<const Colouring> SceneLook::colouring(std::string_view scheme) const {
  const TouchableModel& stage = felt_.stage();
  // Atoms in the hand are among the untouchable ones. Neither exerts a force.
  const std::vector<std::uint32_t> apart = stage.spheres->untouchable();
  return schemeColouring(
      *stage.molecule, scheme,
      {.dielectric = felt_.touch().dielectric, .held = apart, .fluctuation_A = fluctuation_A, .later = true});
}

bool SceneLook::touchesUnseen(const Contact& contact) const {
  if (!atoms.hidden) return false;
  return std::any_of(contact.atoms.begin(), contact.atoms.end(), [&](std::int32_t a) {
    return a >= 0 && std::binary_search(atoms.hidden->begin(), atoms.hidden->end(), std::uint32_t(a));
  });
}

bool SceneLook::drawsNothing() const {
  return atoms.hidden && felt_.stage() && atoms.hidden->size() == felt_.stage().molecule->atoms.size();
}

}  // namespace moltact
