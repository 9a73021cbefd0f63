// Keeps what the lesson's author has locked as the lesson sets it, whatever menu, shortcut or panel would change it:
// once a frame, when all of them have done their work. Window's thread.
#pragma once

#include "app/ui/application/extension.h"

namespace moltact {

class LessonLocks : public Extension {
 public:
  void afterPanels(Application& app) override;
};

}  // namespace moltact
