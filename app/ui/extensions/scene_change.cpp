#include "app/ui/extensions/scene_change.h"

#include <algorithm>
#include <cmath>

#include "app/ui/application/application.h"
#include "app/ui/scene/view_picture.h"

namespace moltact {

Camera between(const Camera& a, const Camera& b, double t) {
  Camera c = b;
  c.target.A = glm::mix(a.target.A, b.target.A, t);
  c.orientation = glm::normalize(glm::slerp(a.orientation, b.orientation, t));
  c.distance_A = a.distance_A * std::pow(b.distance_A / a.distance_A, t);
  return c;
}

void SceneChange::sceneChanged(Application& app) {
  glide_s_ = kGlide_s;
  fade_s_ = kFade_s;
  if (app.settings.reduced_motion || !molecule_) return;
  if (app.scene.stage().molecule != molecule_) {
    app.picture().keepForFade();
    fade_s_ = 0.0;
  } else {
    glide(app, seen_);
  }
}

void SceneChange::glide(Application& app, const Camera& seen) {
  if (app.settings.reduced_motion || seen == app.scene.camera) return;
  from_ = seen;
  to_ = app.scene.camera;
  app.scene.camera = from_;
  glide_s_ = 0.0;
}

void SceneChange::beforeTicks(Application& app) {
  fade_s_ = std::min(kFade_s, fade_s_ + app.dt_s());
  if (!gliding()) return;
  // Who takes the camera has it.
  if (app.scene.controls.cameraMoved()) {
    glide_s_ = kGlide_s;
    return;
  }
  glide_s_ = std::min(kGlide_s, glide_s_ + app.dt_s());
  const double t = glide_s_ / kGlide_s;
  app.scene.camera = gliding() ? between(from_, to_, t * t * (3.0 - 2.0 * t)) : to_;
}

void SceneChange::afterPanels(Application& app) {
  seen_ = app.scene.camera;
  molecule_ = app.scene.stage().molecule;
}

}  // namespace moltact
