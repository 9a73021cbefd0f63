#include "app/ui/scene/played_body.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "engine/lesson/scene_atoms.h"

namespace moltact {

PlayedBody::Held PlayedBody::now() const {
  const TouchableModel& stage = scene_.stage();
  return {scene_.molecule(), stage.spheres->untouchable(),
          stage.body ? stage.body->atoms : std::vector<std::uint32_t>(), scene_.look.atoms.hidden};
}

void PlayedBody::restage(const Held& wanted) {
  const Camera seen = scene_.camera;
  scene_.show(withUntouchable(scene_.atoms().resting(), wanted.untouchable, wanted.held), wanted.molecule,
              [](Camera&, const Molecule&) {});
  scene_.camera = seen;
  scene_.look.atoms.hidden = wanted.hidden;
}

void PlayedBody::hold(const std::vector<std::uint32_t>& untouchable, const std::vector<std::uint32_t>& held) {
  if (!scene_.stage()) return;
  const Held is = now();
  if (is.untouchable == untouchable && is.held == held) return;
  if (!before_ || is != played_) before_ = is;
  // A held body is drawn only in the hand; a body held before is drawn at its place again.
  std::vector<std::uint32_t> hidden;
  if (const AtomList& was = before_->hidden)
    std::set_difference(was->begin(), was->end(), before_->held.begin(), before_->held.end(),
                        std::back_inserter(hidden));
  hidden = atomsOfEither(hidden, held);
  played_ = {is.molecule, untouchable, held,
             hidden.empty() ? nullptr : std::make_shared<const std::vector<std::uint32_t>>(std::move(hidden))};
  restage(played_);
}

void PlayedBody::release() {
  if (!before_) return;
  const Held before = *std::exchange(before_, std::nullopt);
  if (scene_.stage() && now() == played_) restage(before);
}

}  // namespace moltact
