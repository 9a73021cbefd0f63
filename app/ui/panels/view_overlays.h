// What stands over the 3-D view: the state in words, the scale bar, the hint of controls. Window's thread.
#pragma once

#include "app/ui/layout.h"

namespace moltact {

class Application;

void drawViewOverlays(Application& app, const Rectangle& view);

}  // namespace moltact
