// Where the keys lead: over the molecule, or from control to control of panels and pages. Tab takes them to the panels;
// Escape, a click and the way past the last control give them back to the molecule. Menus open by F10, Alt, or Alt with
// their letter. Window's thread.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace moltact {

/// Where the keys are, from frame to frame.
struct KeyFocus {
  bool keys_in_panels = false;  ///< Tab has led the keys from the molecule to the panels
  bool popup_open = false;      ///< in the last frame a page, menu or list was
  bool alt_alone = false;       ///< Alt is down and nothing else has been pressed since
  int menu_wanted = -1;         ///< the menu that the keys open in this frame; negative: none
  int menu_open = -1;           ///< the menu of the bar that is open; negative: none
  bool at_submenu = false;      ///< in it the keys are at a line that opens another menu
};

/// Once a frame, before the panels: follows Tab, F6, F10, Alt and Enter. `menu_letters`: which with Alt opens each menu
/// of the bar, in capitals.
void leadByKeys(KeyFocus& panels, std::string_view menu_letters);

/// The keys belong to the molecule and the lesson: no text is being written, no page or menu is open, no panel has
/// them.
bool keysFree();
/// The keys lead from control to control.
bool keysLeadControls();

/// ImGui's last item can be led to; draws the ring where the keys are at it. Returns its id, 0 where it cannot (text,
/// greyed out).
unsigned keyStop();
/// ImGui's InputTextMultiline, which leaves no item behind that Tab could lead to: never in 1.86, in 1.90 where it is out
/// of sight.
bool inputLines(const char* label, std::string& text, ImVec2 size, ImGuiInputTextFlags flags = 0);
/// The same with its lines broken at the field's width while they are written, which ImGui before 1.92 cannot. The text
/// then holds line ends that unbrokenLines takes out again.
bool inputWrapped(const char* label, std::string& text, ImVec2 size, ImGuiInputTextFlags flags = 0);
std::string unbrokenLines(std::string_view text);
/// After a field that held `before`: Escape ends the writing and takes nothing back, as ImGui's own does.
void keepOnEscape(std::string& text, const std::string& before);
/// After the field of that label: what is typed from now on is written there. The one way to do this by itself;
/// ImGui's own SetKeyboardFocusHere finds no field in a window other than the one that the keys were in (1.90).
void writeInLastField(const char* label);
/// The keys are at ImGui's last item.
bool keysAtItem();
/// How often the arrows right and left were pressed at the last item, right counted up; the arrows then lead nowhere
/// else.
int arrowsAtItem();
/// The name in the widget map of the control that the keys are at; empty where there is none.
std::string controlOfKeys();

}  // namespace moltact
