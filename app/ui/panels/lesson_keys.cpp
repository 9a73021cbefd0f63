#include "app/ui/panels/lesson_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "app/ui/widgets/key_focus.h"

namespace moltact {
namespace {

bool pageOpen() { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel); }

bool taken(int key) {
  if (!ImGui::IsKeyPressed(key, false)) return false;
  // As if it had been held for a while: no longer pressed in this frame.
  ImGui::GetIO().KeysDownDuration[key] = 1e-6f;
  return true;
}

}  // namespace

bool lessonKeysFree() {
  const ImGuiIO& io = ImGui::GetIO();
  return !io.WantTextInput && !io.KeyCtrl && !io.KeyAlt && !pageOpen();
}

bool lessonKeyPressed(char key) {
  if (!lessonKeysFree()) return false;
  // Where Tab has led the keys to a control, Enter presses that one.
  if (key == '\n') return !keysLeadControls() && (taken(GLFW_KEY_ENTER) || taken(GLFW_KEY_KP_ENTER));
  // GLFW names digits and letters by their ASCII codes.
  return taken(key);
}

void scrollByKeys() {
  constexpr float kPage = 0.7f;  // of the window's height
  if (!ImGui::GetIO().KeyCtrl || pageOpen()) return;
  const float pages = (ImGui::IsKeyPressed(GLFW_KEY_PAGE_DOWN, true) ? 1.0f : 0.0f) -
                      (ImGui::IsKeyPressed(GLFW_KEY_PAGE_UP, true) ? 1.0f : 0.0f);
  if (pages != 0.0f) ImGui::SetScrollY(ImGui::GetScrollY() + pages * kPage * ImGui::GetWindowHeight());
}

}  // namespace moltact
