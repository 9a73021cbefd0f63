#include "app/ui/shell/glfw_keys.h"

#include <algorithm>
#include <iterator>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/ui/widgets/key_names.h"

namespace moltact {
namespace {

struct GlfwKey {
  int glfw;
  ImGuiKey key;
};

constexpr GlfwKey kGlfwKeys[] = {{GLFW_KEY_TAB, ImGuiKey_Tab},
                                 {GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
                                 {GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
                                 {GLFW_KEY_UP, ImGuiKey_UpArrow},
                                 {GLFW_KEY_DOWN, ImGuiKey_DownArrow},
                                 {GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
                                 {GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
                                 {GLFW_KEY_HOME, ImGuiKey_Home},
                                 {GLFW_KEY_END, ImGuiKey_End},
                                 {GLFW_KEY_INSERT, ImGuiKey_Insert},
                                 {GLFW_KEY_DELETE, ImGuiKey_Delete},
                                 {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
                                 {GLFW_KEY_SPACE, ImGuiKey_Space},
                                 {GLFW_KEY_ENTER, ImGuiKey_Enter},
                                 {GLFW_KEY_ESCAPE, ImGuiKey_Escape},
                                 {GLFW_KEY_LEFT_CONTROL, ImGuiKey_LeftCtrl},
                                 {GLFW_KEY_LEFT_SHIFT, ImGuiKey_LeftShift},
                                 {GLFW_KEY_LEFT_ALT, ImGuiKey_LeftAlt},
                                 {GLFW_KEY_LEFT_SUPER, ImGuiKey_LeftSuper},
                                 {GLFW_KEY_RIGHT_CONTROL, ImGuiKey_RightCtrl},
                                 {GLFW_KEY_RIGHT_SHIFT, ImGuiKey_RightShift},
                                 {GLFW_KEY_RIGHT_ALT, ImGuiKey_RightAlt},
                                 {GLFW_KEY_RIGHT_SUPER, ImGuiKey_RightSuper},
                                 {GLFW_KEY_MENU, ImGuiKey_Menu},
                                 {GLFW_KEY_APOSTROPHE, ImGuiKey_Apostrophe},
                                 {GLFW_KEY_COMMA, ImGuiKey_Comma},
                                 {GLFW_KEY_MINUS, ImGuiKey_Minus},
                                 {GLFW_KEY_PERIOD, ImGuiKey_Period},
                                 {GLFW_KEY_SLASH, ImGuiKey_Slash},
                                 {GLFW_KEY_SEMICOLON, ImGuiKey_Semicolon},
                                 {GLFW_KEY_EQUAL, ImGuiKey_Equal},
                                 {GLFW_KEY_LEFT_BRACKET, ImGuiKey_LeftBracket},
                                 {GLFW_KEY_BACKSLASH, ImGuiKey_Backslash},
                                 {GLFW_KEY_RIGHT_BRACKET, ImGuiKey_RightBracket},
                                 {GLFW_KEY_GRAVE_ACCENT, ImGuiKey_GraveAccent},
                                 {GLFW_KEY_CAPS_LOCK, ImGuiKey_CapsLock},
                                 {GLFW_KEY_SCROLL_LOCK, ImGuiKey_ScrollLock},
                                 {GLFW_KEY_NUM_LOCK, ImGuiKey_NumLock},
                                 {GLFW_KEY_PRINT_SCREEN, ImGuiKey_PrintScreen},
                                 {GLFW_KEY_PAUSE, ImGuiKey_Pause},
                                 {GLFW_KEY_KP_DECIMAL, ImGuiKey_KeypadDecimal},
                                 {GLFW_KEY_KP_DIVIDE, ImGuiKey_KeypadDivide},
                                 {GLFW_KEY_KP_MULTIPLY, ImGuiKey_KeypadMultiply},
                                 {GLFW_KEY_KP_SUBTRACT, ImGuiKey_KeypadSubtract},
                                 {GLFW_KEY_KP_ADD, ImGuiKey_KeypadAdd},
                                 {GLFW_KEY_KP_ENTER, ImGuiKey_KeypadEnter},
                                 {GLFW_KEY_KP_EQUAL, ImGuiKey_KeypadEqual}};

}  // namespace

ImGuiKey keyOfGlfw(int glfw_key) {
  const auto within = [&](int first, int last) { return glfw_key >= first && glfw_key <= last; };
  // GLFW numbers digits and letters by their ASCII codes.
  if (within(GLFW_KEY_0, GLFW_KEY_9) || within(GLFW_KEY_A, GLFW_KEY_Z)) return keyOf(char(glfw_key));
  if (within(GLFW_KEY_F1, GLFW_KEY_F12)) return ImGuiKey(int(ImGuiKey_F1) + glfw_key - GLFW_KEY_F1);
  if (within(GLFW_KEY_KP_0, GLFW_KEY_KP_9)) return ImGuiKey(int(ImGuiKey_Keypad0) + glfw_key - GLFW_KEY_KP_0);
  const auto known =
      std::find_if(std::begin(kGlfwKeys), std::end(kGlfwKeys), [&](const GlfwKey& k) { return k.glfw == glfw_key; });
  return known == std::end(kGlfwKeys) ? ImGuiKey(ImGuiKey_None) : known->key;
}

int glfwKeyOf(ImGuiKey key) {
  if (!isKey(key)) return GLFW_KEY_UNKNOWN;
  for (int code = GLFW_KEY_SPACE; code <= GLFW_KEY_LAST; ++code)
    if (keyOfGlfw(code) == key) return code;
  return GLFW_KEY_UNKNOWN;
}

}  // namespace moltact
