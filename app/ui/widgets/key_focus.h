// Where the keys lead: over the molecule, or from control to control of panels and pages. Tab takes them to the panels;
// Escape, a click and the way past the last control give them back to the molecule. Menus open by F10, Alt, or Alt with
// their letter. Window's thread.
#pragma once

#include <string>

namespace moltact {

class Application;

/// Once a frame, before the panels: follows Tab, F6, F10, Alt and Enter.
void leadByKeys(Application& app);

/// The keys belong to the molecule and the lesson: no text is being written, no page or menu is open, no panel has
/// them.
bool keysFree();
/// The keys lead from control to control.
bool keysLeadControls();

/// ImGui's last item can be led to; draws the ring where the keys are at it. Returns its id, 0 where it cannot (text,
/// greyed out).
unsigned keyStop();
/// The keys are at ImGui's last item.
bool keysAtItem();
/// How often the arrows right and left were pressed at the last item, right counted up; the arrows then lead nowhere
/// else.
int arrowsAtItem();
/// The name in the widget map of the control that the keys are at; empty where there is none.
std::string controlOfKeys();

}  // namespace moltact
