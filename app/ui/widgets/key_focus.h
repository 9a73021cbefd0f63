// Keyboard focus: over the molecule, or on a control of panels and pages. Tab moves the focus to the panels. Escape, a
// click, and Tab after the last control return it to the molecule. F10, Alt, or Alt with a letter opens menus. Window's
// thread.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace moltact {

/// The focus, kept from frame to frame.
struct KeyFocus {
  bool keys_in_panels = false;  ///< Tab has moved the focus from the molecule to the panels
  bool popup_open = false;      ///< a page, menu or list was open in the last frame
  bool alt_alone = false;       ///< Alt is down and no other key has been pressed since
  int menu_wanted = -1;         ///< index of the menu that the keys open in this frame; negative: none
  int menu_open = -1;           ///< index of the open menu of the menu bar; negative: none
  bool at_submenu = false;      ///< in that menu, the focus is on a line that opens a submenu
};

/// Called once per frame, before the panels. Handles Tab, F6, F10, Alt and Enter. `menu_letters`: the capital letter
/// that opens each menu together with Alt.
void leadByKeys(KeyFocus& panels, std::string_view menu_letters);

/// Keys act on the molecule and the lesson: no text field, page, menu or panel has the focus.
bool keysFree();
/// Whether keys move the focus between controls.
bool keysLeadControls();

/// Makes ImGui's last item a stop of Tab and draws the focus ring if it has the focus. Returns its id, or 0 if it
/// cannot have the focus (text, disabled).
unsigned keyStop();
/// ImGui's InputTextMultiline as a stop of Tab. ImGui leaves no item behind that Tab could reach: never in 1.86, in
/// 1.90 if it is out of sight.
bool inputLines(const char* label, std::string& text, ImVec2 size, ImGuiInputTextFlags flags = 0);
/// The same, with lines wrapped at the field's width during input, which ImGui before 1.92 cannot do. `text` then
/// contains line ends, which unbrokenLines() removes.
bool inputWrapped(const char* label, std::string& text, ImVec2 size, ImGuiInputTextFlags flags = 0);
std::string unbrokenLines(std::string_view text);
/// Called after a field whose text was `before`. Escape ends the input and keeps the text; ImGui itself would restore
/// `before`.
void keepOnEscape(std::string& text, const std::string& before);
/// Called after the field with this label. Gives it the focus, so that it receives what is typed next. Use this instead
/// of SetKeyboardFocusHere, which in ImGui 1.90 finds no field in a window without the focus.
void writeInLastField(const char* label);
/// Whether ImGui's last item has the focus.
bool keysAtItem();
/// The number of presses of the arrow keys at the last item, right minus left. The arrows then do not move the focus.
int arrowsAtItem();
/// The name in the widget map of the control with the focus; empty if there is none.
std::string controlOfKeys();

}  // namespace moltact
