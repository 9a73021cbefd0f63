#include "app/ui/panels/lesson/lesson_keys.h"

#include "app/ui/widgets/imgui_versions.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/key_names.h"

namespace moltact {
namespace {

bool pageOpen() { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel); }

}  // namespace

bool lessonKeysFree() {
  const ImGuiIO& io = ImGui::GetIO();
  return !io.WantTextInput && !io.KeyCtrl && !io.KeyAlt && !pageOpen();
}

bool lessonKeyPressed(char key) {
  if (!lessonKeysFree()) return false;
  // Where Tab has led the keys to a control, Enter presses that one.
  if (key == '\n') return !keysLeadControls() && (takeKey(ImGuiKey_Enter) || takeKey(ImGuiKey_KeypadEnter));
  return takeKey(keyOf(key));
}

void scrollByKeys() {
  constexpr float kPage = 0.7f;  // of the window's height
  if (!ImGui::GetIO().KeyCtrl || pageOpen()) return;
  const float pages = (ImGui::IsKeyPressed(ImGuiKey_PageDown, true) ? 1.0f : 0.0f) -
                      (ImGui::IsKeyPressed(ImGuiKey_PageUp, true) ? 1.0f : 0.0f);
  if (pages != 0.0f) ImGui::SetScrollY(ImGui::GetScrollY() + pages * kPage * ImGui::GetWindowHeight());
}

}  // namespace moltact
