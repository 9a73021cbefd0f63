// The panels of the window: one file each, here or in panels/lesson, and one row in panels.cpp. Other files hold parts
// of panels. A panel draws the application's state with the controls of app/ui/widgets/controls.h and changes it by
// calls.
#pragma once

#include <span>
#include <string_view>

namespace moltact {

class Application;
struct OpenPages;

struct Panel {
  std::string_view name;
  void (*draw)(Application& app);  ///< draws nothing if the panel is closed or has no room
  bool OpenPages::*page;           ///< the flag that opens a page; null for a panel, and for FilePage, which FileDialog
                                   ///< opens
};

/// In the order in which they are drawn.
std::span<const Panel> allPanels();

}  // namespace moltact
