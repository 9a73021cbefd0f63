#include "app/ui/extensions/scene_change.h"

#include <algorithm>
#include <cmath>

#include "app/ui/files/settings.h"
#include "app/ui/scene/view_picture.h"

namespace moltact {

Camera between(const Camera& a, const Camera& b, double t) {
  Camera c = b;
  c.target.A = glm::mix(a.target.A, b.target.A, t);
  c.orientation = glm::normalize(glm::slerp(a.orientation, b.orientation, t));
  c.distance_A = a.distance_A * std::pow(b.distance_A / a.distance_A, t);
  return c;
}

void SceneChange::sceneChanged() {
  glide_s_ = kGlide_s;
  fade_s_ = kFade_s;
  if (settings_.reduced_motion || !molecule_) return;
  if (scene_.stage().molecule != molecule_) {
    picture_.keepForFade();
    fade_s_ = 0.0;
  } else {
    glide(seen_);
  }
}

void SceneChange::glide(const Camera& seen) {
  if (settings_.reduced_motion || seen == scene_.camera) return;
  from_ = seen;
  to_ = scene_.camera;
  scene_.camera = from_;
  glide_s_ = 0.0;
}

void SceneChange::beforeTicks() {
  fade_s_ = std::min(kFade_s, fade_s_ + time_.dt_s);
  if (!gliding()) return;
  // A camera motion by the user ends the glide.
  if (scene_.controls.cameraMoved()) {
    glide_s_ = kGlide_s;
    return;
  }
  glide_s_ = std::min(kGlide_s, glide_s_ + time_.dt_s);
  const double t = glide_s_ / kGlide_s;
  scene_.camera = gliding() ? between(from_, to_, t * t * (3.0 - 2.0 * t)) : to_;
}

void SceneChange::afterPanels() {
  seen_ = scene_.camera;
  molecule_ = scene_.stage().molecule;
}

}  // namespace moltact
