#include "app/ui/scene/scanned_surface.h"

#include <utility>

namespace moltact {

void ScannedSurface::touch(std::shared_ptr<const HeightField> field, std::shared_ptr<const SphereGrid> like) {
  const TouchableModel& stage = felt_.stage();
  if (field == felt_.scanned || (field && (!stage || stage.body || !felt_.ownHand()))) return;
  felt_.letGo();
  felt_.scanned = std::move(field);
  felt_.scanned_like = felt_.scanned ? std::move(like) : nullptr;
  if (!stage || felt_.played) return;
  force_.startSoftly();
  felt_.servo.setInteraction(felt_.interactionAt(Contact{}, PoseA{}));
}

}  // namespace moltact
