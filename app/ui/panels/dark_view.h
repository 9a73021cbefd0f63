// The view while the screen is dark: the molecule is hidden and can only be felt. Window's thread.
#pragma once

#include "app/ui/widgets/layout.h"

namespace moltact {

class Application;

/// Draws the dark view in place of the view: whether there is contact and, if the task shows them, a meter of the force
/// and an arrow of its direction. The arrow shows what a hand at a force-feedback device would feel.
void drawDarkView(Application& app, const Rectangle& view);

/// Colours of the dark view, the same in every theme (ImU32).
struct DarkColours {
  unsigned bright = 0, quiet = 0;
};
/// Draws the energy between atoms at the right of the dark view, where the task displays the force (energy_gauge.cpp).
void drawDarkEnergy(Application& app, const Rectangle& view, const DarkColours& colours);

/// Draws the dark background over the view; `strength` fades it out from 1 to 0.
void drawDarkVeil(const Rectangle& view, float strength);

/// In the dark: writes into the panel that it is hidden, and returns true. Otherwise returns false.
bool drawnDark(Application& app);

}  // namespace moltact
