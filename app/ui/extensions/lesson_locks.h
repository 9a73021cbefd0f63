// Keeps what the lesson's author has locked as the lesson sets it, whatever menu, shortcut or panel would change it:
// once a frame, when all of them have done their work. Window's thread.
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
