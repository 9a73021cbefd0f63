#include "app/ui/widgets/imgui_versions.h"

#include <imgui_internal.h>

#include <cfloat>

namespace moltact {

#if IMGUI_VERSION_NUM < 18700

void prepareInput(ImGuiIO& io) {
  for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
  io.KeyMap[ImGuiKey_Tab] = -1;
}

void keepTab() {}

void feedPointer(ImGuiIO& io, float x, float y) { io.MousePos = {x, y}; }

void feedButton(ImGuiIO& io, int button, bool down) { io.MouseDown[button] = down; }

void feedWheel(ImGuiIO& io, float x, float y) {
  io.MouseWheelH += x;
  io.MouseWheel += y;
}

void feedKey(ImGuiIO& io, ImGuiKey key, bool down) { io.KeysDown[key] = down; }

void feedModifiers(ImGuiIO& io, const Modifiers& held) {
  io.KeyCtrl = held.ctrl;
  io.KeyShift = held.shift;
  io.KeyAlt = held.alt;
  io.KeySuper = held.super;
}

#else

void prepareInput(ImGuiIO& io) { io.ConfigInputTrickleEventQueue = false; }

// ImGui itself ignores a key that has an owner, while IsKeyPressed still reports it. The ownership lasts until the next
// frame.
void keepTab() { ImGui::SetKeyOwner(ImGuiKey_Tab, ImHashStr("moltact/tab")); }

void feedPointer(ImGuiIO& io, float x, float y) { io.AddMousePosEvent(x, y); }

void feedButton(ImGuiIO& io, int button, bool down) { io.AddMouseButtonEvent(button, down); }

void feedWheel(ImGuiIO& io, float x, float y) { io.AddMouseWheelEvent(x, y); }

void feedKey(ImGuiIO& io, ImGuiKey key, bool down) { io.AddKeyEvent(key, down); }

void feedModifiers(ImGuiIO& io, const Modifiers& held) {
  io.AddKeyEvent(ImGuiMod_Ctrl, held.ctrl);
  io.AddKeyEvent(ImGuiMod_Shift, held.shift);
  io.AddKeyEvent(ImGuiMod_Alt, held.alt);
  io.AddKeyEvent(ImGuiMod_Super, held.super);
}

#endif

void feedPointerLeft(ImGuiIO& io) { feedPointer(io, -FLT_MAX, -FLT_MAX); }

bool takeKey(ImGuiKey key) {
  if (!ImGui::IsKeyPressed(key, false)) return false;
  // Marks the key as already held for a while.
  constexpr float kHeld_s = 1e-6f;
#if IMGUI_VERSION_NUM < 18700
  ImGui::GetIO().KeysDownDuration[key] = kHeld_s;
#else
  ImGui::GetKeyData(key)->DownDuration = kHeld_s;
#endif
  return true;
}

void activateItem(ImGuiID id) {
#if IMGUI_VERSION_NUM < 18980
  ImGui::ActivateItem(id);
#else
  ImGui::ActivateItemByID(id);
#endif
}

bool itemAwaitsActivation() { return GImGui->NavNextActivateId != 0; }

void pressByEnter([[maybe_unused]] ImGuiID id) {
#if IMGUI_VERSION_NUM < 18940
  activateItem(id);
#endif
}

bool keysPlaceShown() {
#if IMGUI_VERSION_NUM < 19140
  return !GImGui->NavDisableHighlight;
#else
  return GImGui->NavCursorVisible;
#endif
}

void showKeysPlace(bool on) {
#if IMGUI_VERSION_NUM < 19140
  GImGui->NavDisableHighlight = !on;
#else
  ImGui::SetNavCursorVisible(on);
#endif
}

void ignoreRestingMouse() {
#if IMGUI_VERSION_NUM < 19140
  GImGui->NavDisableMouseHover = true;
#else
  GImGui->NavHighlightItemUnderNav = true;
#endif
}

ItemForKeys lastItemForKeys() {
#if IMGUI_VERSION_NUM < 19140
  const ImGuiItemFlags flags = GImGui->LastItemData.InFlags;
#else
  const ImGuiItemFlags flags = GImGui->LastItemData.ItemFlags;
#endif
  return {!(flags & (ImGuiItemFlags_Disabled | ImGuiItemFlags_NoNav)), bool(flags & ImGuiItemFlags_Inputable)};
}

// With SetNextItemAllowOverlap (1.89.7), hovering is known one frame late, so a press would act at the previous place.
// From 1.89 on, the first item under a click owns the mouse button.
void buttonUnderOthers(const char* id, ImVec2 size, ImGuiButtonFlags flags) {
#if IMGUI_VERSION_NUM >= 18940
  flags |= ImGuiButtonFlags_NoSetKeyOwner;
#endif
  ImGui::InvisibleButton(id, size, flags);
  ImGui::SetItemAllowOverlap();
}

}  // namespace moltact
