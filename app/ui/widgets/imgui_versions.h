// The only place for differences between the versions of Dear ImGui in Debian 12 (1.86) and Debian 13 (1.90.1). All
// other code uses what both versions share. Keys are ImGuiKey everywhere. Window's thread. Units: pixel, wheel notch.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <cstdint>

#if IMGUI_VERSION_NUM < 18700
// In old versions the application numbers the keys, and ImGuiKey lists only the few that ImGui needs. These numbers
// continue that list, so that IsKeyDown and IsKeyPressed accept them as in later versions.
enum MoltactImGuiKey : int {
  ImGuiKey_None = -1,
  ImGuiKey_NamedKey_BEGIN = ImGuiKey_Tab,
  ImGuiKey_KeypadEnter = ImGuiKey_KeyPadEnter,
  ImGuiKey_LeftCtrl = ImGuiKey_COUNT,
  ImGuiKey_LeftShift,
  ImGuiKey_LeftAlt,
  ImGuiKey_LeftSuper,
  ImGuiKey_RightCtrl,
  ImGuiKey_RightShift,
  ImGuiKey_RightAlt,
  ImGuiKey_RightSuper,
  ImGuiKey_Menu,
  ImGuiKey_0,
  ImGuiKey_1,
  ImGuiKey_2,
  ImGuiKey_3,
  ImGuiKey_4,
  ImGuiKey_5,
  ImGuiKey_6,
  ImGuiKey_7,
  ImGuiKey_8,
  ImGuiKey_9,
  ImGuiKey_B,
  ImGuiKey_D,
  ImGuiKey_E,
  ImGuiKey_F,
  ImGuiKey_G,
  ImGuiKey_H,
  ImGuiKey_I,
  ImGuiKey_J,
  ImGuiKey_K,
  ImGuiKey_L,
  ImGuiKey_M,
  ImGuiKey_N,
  ImGuiKey_O,
  ImGuiKey_P,
  ImGuiKey_Q,
  ImGuiKey_R,
  ImGuiKey_S,
  ImGuiKey_T,
  ImGuiKey_U,
  ImGuiKey_W,
  ImGuiKey_F1,
  ImGuiKey_F2,
  ImGuiKey_F3,
  ImGuiKey_F4,
  ImGuiKey_F5,
  ImGuiKey_F6,
  ImGuiKey_F7,
  ImGuiKey_F8,
  ImGuiKey_F9,
  ImGuiKey_F10,
  ImGuiKey_F11,
  ImGuiKey_F12,
  ImGuiKey_Apostrophe,
  ImGuiKey_Comma,
  ImGuiKey_Minus,
  ImGuiKey_Period,
  ImGuiKey_Slash,
  ImGuiKey_Semicolon,
  ImGuiKey_Equal,
  ImGuiKey_LeftBracket,
  ImGuiKey_Backslash,
  ImGuiKey_RightBracket,
  ImGuiKey_GraveAccent,
  ImGuiKey_CapsLock,
  ImGuiKey_ScrollLock,
  ImGuiKey_NumLock,
  ImGuiKey_PrintScreen,
  ImGuiKey_Pause,
  ImGuiKey_Keypad0,
  ImGuiKey_Keypad1,
  ImGuiKey_Keypad2,
  ImGuiKey_Keypad3,
  ImGuiKey_Keypad4,
  ImGuiKey_Keypad5,
  ImGuiKey_Keypad6,
  ImGuiKey_Keypad7,
  ImGuiKey_Keypad8,
  ImGuiKey_Keypad9,
  ImGuiKey_KeypadDecimal,
  ImGuiKey_KeypadDivide,
  ImGuiKey_KeypadMultiply,
  ImGuiKey_KeypadSubtract,
  ImGuiKey_KeypadAdd,
  ImGuiKey_KeypadEqual,
  ImGuiKey_GamepadStart  // the first value after the keyboard's keys
};
#endif

namespace moltact {

/// The keyboard's keys, indexed from 0.
constexpr std::size_t kKeyCount = std::size_t(int(ImGuiKey_GamepadStart) - int(ImGuiKey_NamedKey_BEGIN));
constexpr ImGuiKey keyAt(std::size_t index) { return ImGuiKey(int(ImGuiKey_NamedKey_BEGIN) + int(index)); }
constexpr std::size_t indexOf(ImGuiKey key) { return std::size_t(int(key) - int(ImGuiKey_NamedKey_BEGIN)); }
constexpr bool isKey(ImGuiKey key) {
  return int(key) >= int(ImGuiKey_NamedKey_BEGIN) && int(key) < int(ImGuiKey_GamepadStart);
}
constexpr bool isModifier(ImGuiKey key) {
  return int(key) >= int(ImGuiKey_LeftCtrl) && int(key) <= int(ImGuiKey_RightSuper);
}

// Pass the user's input to ImGui for the next frame. Only InputQueue calls these functions.
/// Called once per context. Afterwards all input takes effect in the next frame, and Tab follows key_focus.h instead of
/// ImGui.
void prepareInput(ImGuiIO& io);
/// Called before every frame.
void keepTab();
void feedPointer(ImGuiIO& io, float x, float y);
/// The pointer has left the window.
void feedPointerLeft(ImGuiIO& io);
void feedButton(ImGuiIO& io, int button, bool down);
void feedWheel(ImGuiIO& io, float x, float y);
void feedKey(ImGuiIO& io, ImGuiKey key, bool down);
struct Modifiers {
  bool ctrl = false, shift = false, alt = false, super = false;
};
void feedModifiers(ImGuiIO& io, const Modifiers& held);

/// Returns whether the key was pressed in this frame and consumes it: later callers in the same frame get false.
bool takeKey(ImGuiKey key);

/// Activates the item in the next frame, as if it had been pressed.
void activateItem(ImGuiID id);
/// Called between frames: whether the next frame will activate an item.
bool itemAwaitsActivation();
/// Lets Enter press the focused item. Later versions do this themselves.
void pressByEnter(ImGuiID id);
/// Whether the focused item is highlighted. A mouse motion ends the highlight.
bool keysPlaceShown();
void showKeysPlace(bool on);
/// The mouse hovers nothing until it moves.
void ignoreRestingMouse();
/// ImGui's last item as keyboard navigation sees it. `usable` is false for an item that is disabled or excluded from
/// navigation.
struct ItemForKeys {
  bool usable = false;
  bool field = false;  ///< it is a text field
};
ItemForKeys lastItemForKeys();

/// An invisible button that items drawn later may overlap. The overlapping item gets the mouse.
void buttonUnderOthers(const char* id, ImVec2 size, ImGuiButtonFlags flags);

/// Converts an OpenGL texture; 0: none.
inline ImTextureID textureOf(unsigned gl_name) { return ImTextureID(std::intptr_t(gl_name)); }
inline unsigned nameOf(ImTextureID texture) { return unsigned(std::intptr_t(texture)); }

}  // namespace moltact
