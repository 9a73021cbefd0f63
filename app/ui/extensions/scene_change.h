// From one scene to the next without a jump: over the same molecule the camera glides, to another one the old picture
// fades away over the new. At once where the person prefers it so. Window's thread. Unit: second.
#pragma once

#include <memory>

#include "app/ui/application/extension.h"
#include "engine/render/camera.h"

namespace moltact {

struct Molecule;

/// The camera a share `t` (0 to 1) of the way from `a` to `b`: the target moves straight, the turn takes the shorter
/// way, the distance changes by equal factors.
Camera between(const Camera& a, const Camera& b, double t);

class SceneChange : public Extension {
 public:
  static constexpr double kGlide_s = 0.6, kFade_s = 0.35;

  void sceneChanged(Application& app) override;
  void viewReset(Application& app, const Camera& seen) override { glide(app, seen); }
  void beforeTicks(Application& app) override;
  void afterPanels(Application& app) override;
  bool live() const override { return glide_s_ < kGlide_s || fade_s_ < kFade_s; }

  /// From the view that is seen to the scene's camera, which has been set. At once where the person prefers it so.
  void glide(Application& app, const Camera& seen);
  /// Where the camera is going; `now` where it rests.
  Camera bound(const Camera& now) const { return gliding() ? to_ : now; }

  /// How strongly the picture of the scene before still shows over the new one (1 to 0).
  double oldPicture() const { return 1.0 - fade_s_ / kFade_s; }
  bool gliding() const { return glide_s_ < kGlide_s; }

 private:
  Camera seen_, from_, to_;
  std::shared_ptr<const Molecule> molecule_;  // of the frame before
  double glide_s_ = kGlide_s, fade_s_ = kFade_s;
};

}  // namespace moltact
