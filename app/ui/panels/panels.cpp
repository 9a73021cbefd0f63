#include "app/ui/panels/panels.h"

#include <array>

#include "app/ui/application/panel_state.h"

// One line per panel; the function draw<Name>(Application&) is in the panel's own file. A page names the member of
// PanelState that opens it. The dialog that FilePage draws opens it (app/ui/files/file_dialog.h).
#define MOLTACT_PANELS(PANEL, PAGE)  \
  PANEL(MenuBar)                     \
  PAGE(WelcomePage, welcome)         \
  PANEL(LessonPanel)                 \
  PANEL(ViewPanel)                   \
  PANEL(SidePanel)                   \
  PANEL(Splitters)                   \
  PANEL(PlaybackBar)                 \
  PANEL(TurnsStrip)                  \
  PANEL(StatusBar)                   \
  PANEL(ToolBar)                     \
  PANEL(LimitNotice)                 \
  PANEL(LessonProblems)              \
  PANEL(MessageStack)                \
  PAGE(TurnsPage, turns)             \
  PANEL(ClassPage)                   \
  PAGE(OpenPage, open)               \
  PANEL(NameQuestion)                \
  PANEL(FilePage)                    \
  PAGE(PreferencesPage, preferences) \
  PAGE(DevicePage, device)           \
  PAGE(ZoomPage, zoom)               \
  PAGE(LookPage, look)               \
  PAGE(ReadingPage, reading)         \
  PAGE(PicturePage, picture)         \
  PAGE(ControlsPage, controls)       \
  PAGE(AboutPage, about)

namespace moltact {

#define MOLTACT_DECLARE(Name, ...) void draw##Name(Application& app);
MOLTACT_PANELS(MOLTACT_DECLARE, MOLTACT_DECLARE)
#undef MOLTACT_DECLARE

std::span<const Panel> allPanels() {
#define MOLTACT_PANEL(Name) Panel{#Name, &draw##Name, nullptr},
#define MOLTACT_PAGE(Name, flag) Panel{#Name, &draw##Name, &OpenPages::flag},
  static constexpr std::array kPanels{MOLTACT_PANELS(MOLTACT_PANEL, MOLTACT_PAGE)};
#undef MOLTACT_PAGE
#undef MOLTACT_PANEL
  return kPanels;
}

}  // namespace moltact
