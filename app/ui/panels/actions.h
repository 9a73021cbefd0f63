// The commands that a person can give the program: one row a command. Menus, tool bar, shortcuts and the sheet that
// lists them are all made from this table. Window's thread.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/ui/widgets/controls.h"

namespace moltact {

class Application;

/// None: in no menu, offered with a message alone.
enum class Menu { File, Edit, View, Lesson, Help, None };
inline constexpr int kMenus = 5;
/// "File", the English name of a menu; as it is shown; and the capital letter that opens it with Alt.
const char* menuName(Menu menu);
const char* menuLabel(Menu menu);
char menuLetter(Menu menu);

struct Action {
  std::string_view name;  ///< "open": in the widget map menu/file/open and tool/open
  Menu menu = Menu::File;
  bool parted = false;             ///< a line stands above it in its menu
  std::string_view label;          ///< in English, as the sentence; tr() where it is shown
  std::string_view shortcut = {};  ///< "Ctrl+O": as keysPressed() reads it; empty: none
  std::string_view also = {};      ///< a second shortcut, which menus do not show
  std::string_view sentence = {};  ///< what it does, where the label does not say it: for the tool tip
  Icon icon = Icon::None;
  int tool = 0;  ///< in the tool bar: 1 is kept longest where there is little room, 0 is not there
  void (*run)(Application&) = nullptr;
  bool (*enabled)(const Application&) = nullptr;  ///< null: always
  bool (*on)(const Application&) = nullptr;       ///< of a switch; null: it is none
  bool while_writing = false;                     ///< its shortcut works while a text field has the keyboard
};

/// In the order of the menus and of the tool bar.
std::span<const Action> allActions();
/// Null where there is none of this name.
const Action* findAction(std::string_view name);
bool enabled(const Action& action, const Application& app);
/// "Open … (Ctrl+O)", or the sentence with the shortcut.
std::string toolTip(const Action& action);

/// Once a frame, before the layout: leads the keys from control to control (widgets/key_focus.h), then runs the actions
/// whose shortcuts were pressed. Shortcuts rest while a page is open over the panels.
void runKeys(Application& app);

}  // namespace moltact
