// Resets locked settings to the lesson's values, whatever menu, shortcut or panel has changed them. Runs once per frame
// after all of these. Window's thread.
#pragma once

#include "app/ui/application/extension.h"

namespace moltact {

class LessonGuide;
struct PanelState;

class LessonLocks : public Extension {
 public:
  LessonLocks(HapticSession& scene, const LessonGuide& lesson, PanelState& panels)
      : scene_(scene), lesson_(lesson), panels_(panels) {}

  void afterPanels() override;

 private:
  HapticSession& scene_;
  const LessonGuide& lesson_;
  PanelState& panels_;
};

}  // namespace moltact
