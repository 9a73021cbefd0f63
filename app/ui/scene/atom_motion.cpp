#include "app/ui/scene/atom_motion.h"

#include <utility>

namespace moltact {

void AtomMotion::begin(TouchableModel model) {
  model_ = resting_ = std::move(model);
  seen_.reset();
  drawn_.reset();
  stop();
  seen_motion_ = 0;
}

void AtomMotion::stop() { motion_.reset(); }

bool AtomMotion::move(const std::vector<Sphere>& to, int ticks) {
  auto next = motion_ ? SphereMotion::after(*motion_, to, ticks)
                      : SphereMotion::make(model_.spheres->spheres(), to, ticks, resting_.spheres->untouchable());
  if (!next) return false;
  std::shared_ptr<const SphereMotion> motion = *std::move(next);
  if (!servo_.setMotion(motion)) return false;
  motion_ = std::move(motion);
  return true;
}

void AtomMotion::place(SharedArray<Sphere> at) {
  seen_ = std::make_shared<const Molecule>(model_.molecule->movedTo(at));
  drawn_.reset();
  model_ = movedModel(resting_, std::move(at));
  stop();
  seen_motion_ = 0;
}

bool AtomMotion::show(const SharedArray<Sphere>& at) {
  if (!model_.molecule || at.size() != model_.spheres->size()) return false;
  if (frames_since_drawn_ < (last_frame_s_ > kQuickFrame_s ? 2 : 1)) return false;
  drawn_ = std::make_shared<const Molecule>(model_.molecule->movedTo(at));
  frames_since_drawn_ = 0;
  return true;
}

void AtomMotion::follow(double dt_s) {
  if (since_seen_s_ == 0.0) frame_after_s_ = dt_s;
  since_seen_s_ += dt_s;
  last_frame_s_ = dt_s;
  ++frames_since_drawn_;
  const ServoSample& now = servo_.newest();
  const std::shared_ptr<const SphereMotion> motion = servo_.motionOf(now);
  if (!motion || (now.motion == seen_motion_ && now.fraction == seen_fraction_) || tooSoon()) return;
  seen_motion_ = now.motion;
  seen_fraction_ = now.fraction;
  since_seen_s_ = 0.0;
  const SharedArray<Sphere> places = motion->at(now.fraction);
  seen_ = std::make_shared<const Molecule>(model_.molecule->movedTo(places));
  if (frames_since_drawn_ > kShown_frames) drawn_.reset();
  model_ = movedModel(model_, *motion, places);
}

}  // namespace moltact
