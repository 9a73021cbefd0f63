// The panel beside the view and its tabs. A tab is one file in this folder, which defines draw<Name>Tab(Application&),
// and one row of the table below. Title, menu item and shortcut are made from the row. SideTabs
// (app/ui/application/side_tabs.h) stores which tabs are open. Window's thread.
#pragma once

#include <span>
#include <string_view>

namespace moltact {

class Application;

// The tabs besides that of touch: name of the function, key, title, item of the menu View, its shortcut. A lesson's scene
// opens a tab by its key, if the key is also among the words of the scenes' key `panels` (engine/lesson/keys.cpp).
#define MOLTACT_SIDE_TABS(TAB)                                          \
  TAB(Methods, "methods", N_("Methods"), N_("Methods panel"), "Ctrl+M") \
  TAB(Motion, "motion", N_("Motion"), N_("Motion panel"), "Ctrl+Shift+M")

struct SideTab {
  const char* key;                 ///< also the panel's name in the widget map
  std::string_view title;          ///< in English
  void (*draw)(Application& app);  ///< draws what is below the tabs
};

/// All tabs, that of touch first.
std::span<const SideTab> sideTabs();

}  // namespace moltact
