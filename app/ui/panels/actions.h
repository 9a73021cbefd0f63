// The user's commands, one row per command. Menus, tool bar, shortcuts and the list of shortcuts are generated from
// this table. Window's thread.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/ui/widgets/controls.h"

namespace moltact {

class Application;

/// None: in no menu; offered only by a message.
enum class Menu { File, Edit, View, Lesson, Help, None };
inline constexpr int kMenus = 5;
/// "File": the English name of a menu; its label on the screen; and the capital letter that opens it with Alt.
const char* menuName(Menu menu);
const char* menuLabel(Menu menu);
char menuLetter(Menu menu);

struct Action {
  std::string_view name;  ///< "open": recorded in the widget map as menu/file/open and tool/open
  Menu menu = Menu::File;
  bool parted = false;             ///< a separator precedes it in its menu
  std::string_view label;          ///< the English label; tr() translates it on the screen
  std::string_view shortcut = {};  ///< "Ctrl+O", in the format of keysPressed(); empty: none
  std::string_view also = {};      ///< a second shortcut, which menus do not show
  std::string_view sentence = {};  ///< the tool tip: what it does, if the label does not say so
  Icon icon = Icon::None;
  int tool = 0;  ///< priority in the tool bar: 1 stays longest when room is short; 0: not in the tool bar
  void (*run)(Application&) = nullptr;
  bool (*enabled)(const Application&) = nullptr;  ///< null: always enabled
  bool (*on)(const Application&) = nullptr;       ///< the state of a switch; null: not a switch
  bool while_writing = false;                     ///< the shortcut also works while a text field has the focus
};

/// In the order of the menus and of the tool bar.
std::span<const Action> allActions();
/// Null if there is no action of this name.
const Action* findAction(std::string_view name);
bool enabled(const Action& action, const Application& app);
/// "Open … (Ctrl+O)", or the action's sentence with the shortcut.
std::string toolTip(const Action& action);

/// Called once per frame, before the layout. Moves the focus between controls (widgets/key_focus.h), then runs the
/// actions whose shortcuts were pressed. Shortcuts are inactive while a page is open over the panels.
void runKeys(Application& app);

}  // namespace moltact
