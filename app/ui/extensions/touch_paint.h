// Traces of the touch in the picture: painted atoms if the scene requests it, and the probe's path after the molecule
// was felt unseen. Contact alone paints, because a field acts on all atoms at once. Window's thread.
#pragma once

#include <memory>
#include <set>

#include "app/ui/application/extension.h"
#include "engine/render/annotations.h"
#include "engine/render/view_scene.h"

namespace moltact {

class LessonGuide;
class RevealPolicy;

class TouchPaint final : public Extension {
 public:
  TouchPaint(const RevealPolicy& policy, const HapticSession& scene, const LessonGuide& lesson)
      : scene_(scene), lesson_(lesson), policy_(policy) {}

  /// The touched atoms before the probe last left the surface, and since then; null: none.
  const AtomList& painted() const { return painted_; }
  const AtomList& fresh() const { return fresh_; }
  /// The probe's path during the last unseen phase; null until the molecule is visible again.
  const std::shared_ptr<const Annotations>& trail() const { return trail_; }

  void beforeTicks() override;
  void ticks(const FeltTicks& felt) override;
  void stepChanged() override;
  void sceneChanged() override;

 private:
  const HapticSession& scene_;
  const LessonGuide& lesson_;
  void extendPath(const PointA& place, bool anew);
  bool paints() const;

  const RevealPolicy& policy_;
  std::set<std::uint32_t> touched_, since_;
  AtomList painted_, fresh_;
  std::shared_ptr<const Annotations> trail_;
  std::vector<std::vector<PointA>> way_;  // in the dark; a new part starts where the hand was moved elsewhere
  std::size_t points_ = 0;
  double spacing_A_ = 0.0;
  std::shared_ptr<const Molecule> molecule_;
  std::size_t dark_task_ = 0;  // the index of the task that made the screen dark
  bool dark_ = false;
};

}  // namespace moltact
