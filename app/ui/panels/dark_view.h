// The view while the screen is dark: no molecule, only what is felt. Window's thread.
#pragma once

#include "app/ui/widgets/layout.h"

namespace moltact {

class Application;

/// In the view's place: where the task shows it a meter of the force and an arrow in the direction of its push, as a
/// force-feedback hand would feel both; and whether there is contact.
void drawDarkView(Application& app, const Rectangle& view);

/// The ground of the dark over the view, as strongly as it is still there (1 to 0).
void drawDarkVeil(const Rectangle& view, float strength);

/// In the dark: writes into a panel that it is hidden, and gives true. Otherwise does nothing and gives false.
bool drawnDark(Application& app);

}  // namespace moltact
