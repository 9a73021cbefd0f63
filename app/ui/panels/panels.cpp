#include "app/ui/panels/panels.h"

#include <array>

// One line a panel: its function is draw<Name>(Application&), in its own file.
#define MOLTACT_PANELS(X) \
  X(MenuBar)              \
  X(WelcomePage)          \
  X(LessonPanel)          \
  X(ViewPanel)            \
  X(TouchPanel)           \
  X(MethodsPanel)         \
  X(Splitters)            \
  X(PlaybackBar)          \
  X(TurnsStrip)           \
  X(StatusBar)            \
  X(ToolBar)              \
  X(LimitNotice)          \
  X(LessonProblems)       \
  X(MessageStack)         \
  X(TurnsPage)            \
  X(OpenPage)             \
  X(FilePage)             \
  X(PreferencesPage)      \
  X(DevicePage)           \
  X(ControlsPage)         \
  X(AboutPage)

namespace moltact {

#define MOLTACT_DECLARE(Name) void draw##Name(Application& app);
MOLTACT_PANELS(MOLTACT_DECLARE)
#undef MOLTACT_DECLARE

std::span<const Panel> allPanels() {
#define MOLTACT_ROW(Name) Panel{#Name, &draw##Name},
  static constexpr std::array kPanels{MOLTACT_PANELS(MOLTACT_ROW)};
#undef MOLTACT_ROW
  return kPanels;
}

}  // namespace moltact
