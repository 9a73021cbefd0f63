#include "app/ui/scene/atom_pull.h"

#include <algorithm>
#include <utility>

namespace moltact {

void AtomPull::hold(std::vector<std::uint32_t> atoms, std::vector<double> masses) {
  const TouchableModel& stage = felt_.stage();
  const bool can = stage && !stage.body && felt_.ownHand();
  if (!can || std::any_of(atoms.begin(), atoms.end(),
                          [&](std::uint32_t atom) { return atom >= stage.spheres->spheres().size(); }))
    atoms.clear();
  if (atoms == felt_.pulled) return;
  felt_.pulled_masses = std::move(masses);
  felt_.pulled = std::move(atoms);
  felt_.controls.drag(!felt_.pulled.empty());
  if (can) felt_.servo.setInteraction(felt_.interactionAt(Contact{}, PoseA{}));
}

}  // namespace moltact
