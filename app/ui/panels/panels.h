// The panels of the window: a file each, here or in panels/lesson, and a row in panels.cpp; the other files are parts of them.
// A panel draws the application's state with the controls of app/ui/widgets/controls.h and calls it to change it.
#pragma once

#include <span>
#include <string_view>

namespace moltact {

class Application;
struct PanelState;

struct Panel {
  std::string_view name;
  void (*draw)(Application& app);  ///< draws nothing where it is closed or has no room
  bool PanelState::*page;          ///< of a page: its flag, which opens it; null for a panel, and for FilePage, which
                                   ///< FileDialog opens
};

/// In the order in which they are drawn.
std::span<const Panel> allPanels();

}  // namespace moltact
