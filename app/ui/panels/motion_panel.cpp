// The tab Motion beside the view, on request: what moves the atoms, with a section for each mover.
#include "app/ui/panels/motion_sections.h"

namespace moltact {

void drawMotionTab(Application& app) {
#define MOLTACT_DRAW(Mover) \
  if (draw##Mover##Section(app)) return;
  MOLTACT_ATOM_MOVERS(MOLTACT_DRAW)
#undef MOLTACT_DRAW
}

}  // namespace moltact
