#include "app/ui/panels/lesson/lesson_keys.h"

#include <utility>

#include "app/ui/application/application.h"
#include "app/ui/widgets/imgui_versions.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/theme.h"

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
  // If Tab has given a control the focus, Enter presses that control.
  if (key == '\n') return !keysLeadControls() && (takeKey(ImGuiKey_Enter) || takeKey(ImGuiKey_KeypadEnter));
  return takeKey(keyOf(key));
}

void noteSeen(Application& app, const KeyPart& part) {
  const float top = ImGui::GetWindowPos().y;
  app.panels.lesson_memory.seen.note(part.name, {part.low, part.high}, {top, top + ImGui::GetWindowHeight()},
                                     ImGui::GetFrameCount(), app.now_s());
}

bool wasSeen(const Application& app, std::string_view name) { return app.panels.lesson_memory.seen.ever(name); }

bool lessonKeyActs(Application& app, char key, const KeyPart& part) {
  noteSeen(app, part);
  PanelState& panels = app.panels;
  if (!lessonKeyPressed(key)) return false;
  if (panels.lesson_memory.done_s >= 0.0 && app.now_s() - panels.lesson_memory.done_s < kAfterDone_s) return false;
  if (part.read && panels.lesson_memory.seen.now(part.name, app.now_s())) return true;
  const float top = ImGui::GetWindowPos().y, high = ImGui::GetWindowHeight(), margin = look().px(12);
  const bool whole = part.with >= 0.0f && part.high - part.with <= high - 2 * margin;
  const float from = whole ? part.with : part.low;
  if (from < top || part.high > top + high) panels.lesson_memory.scroll = from - top - margin;
  return false;
}

bool lessonKeyOnItem(Application& app, char key, std::string name) {
  return lessonKeyActs(app, key, {std::move(name), ImGui::GetItemRectMin().y, ImGui::GetItemRectMax().y});
}

void noteDone(Application& app) {
  for (const SessionEvent& e : app.lesson.session()->events()) {
    const AnswerJudged* answer = std::get_if<AnswerJudged>(&e);
    if (std::holds_alternative<TaskFinished>(e) || (answer && answer->completes))
      app.panels.lesson_memory.done_s = app.now_s();
  }
}

void scrollByKeys() {
  constexpr float kPage = 0.7f;  // share of the window's height
  if (!ImGui::GetIO().KeyCtrl || pageOpen()) return;
  const float pages = (ImGui::IsKeyPressed(ImGuiKey_PageDown, true) ? 1.0f : 0.0f) -
                      (ImGui::IsKeyPressed(ImGuiKey_PageUp, true) ? 1.0f : 0.0f);
  if (pages != 0.0f) ImGui::SetScrollY(ImGui::GetScrollY() + pages * kPage * ImGui::GetWindowHeight());
}

}  // namespace moltact
