#include "app/ui/shell/page_keys.h"

#include <utility>

#include "app/ui/widgets/key_names.h"

namespace moltact {
namespace {

constexpr std::pair<std::string_view, ImGuiKey> kPageKeys[] = {{"Tab", ImGuiKey_Tab},
                                                               {"ArrowLeft", ImGuiKey_LeftArrow},
                                                               {"ArrowRight", ImGuiKey_RightArrow},
                                                               {"ArrowUp", ImGuiKey_UpArrow},
                                                               {"ArrowDown", ImGuiKey_DownArrow},
                                                               {"PageUp", ImGuiKey_PageUp},
                                                               {"PageDown", ImGuiKey_PageDown},
                                                               {"Home", ImGuiKey_Home},
                                                               {"End", ImGuiKey_End},
                                                               {"Insert", ImGuiKey_Insert},
                                                               {"Delete", ImGuiKey_Delete},
                                                               {"Backspace", ImGuiKey_Backspace},
                                                               {"Space", ImGuiKey_Space},
                                                               {"Enter", ImGuiKey_Enter},
                                                               {"Escape", ImGuiKey_Escape},
                                                               {"ControlLeft", ImGuiKey_LeftCtrl},
                                                               {"ShiftLeft", ImGuiKey_LeftShift},
                                                               {"AltLeft", ImGuiKey_LeftAlt},
                                                               {"MetaLeft", ImGuiKey_LeftSuper},
                                                               {"ControlRight", ImGuiKey_RightCtrl},
                                                               {"ShiftRight", ImGuiKey_RightShift},
                                                               {"AltRight", ImGuiKey_RightAlt},
                                                               {"MetaRight", ImGuiKey_RightSuper},
                                                               {"ContextMenu", ImGuiKey_Menu},
                                                               {"Quote", ImGuiKey_Apostrophe},
                                                               {"Comma", ImGuiKey_Comma},
                                                               {"Minus", ImGuiKey_Minus},
                                                               {"Period", ImGuiKey_Period},
                                                               {"Slash", ImGuiKey_Slash},
                                                               {"Semicolon", ImGuiKey_Semicolon},
                                                               {"Equal", ImGuiKey_Equal},
                                                               {"BracketLeft", ImGuiKey_LeftBracket},
                                                               {"Backslash", ImGuiKey_Backslash},
                                                               {"BracketRight", ImGuiKey_RightBracket},
                                                               {"Backquote", ImGuiKey_GraveAccent},
                                                               {"NumpadDecimal", ImGuiKey_KeypadDecimal},
                                                               {"NumpadDivide", ImGuiKey_KeypadDivide},
                                                               {"NumpadMultiply", ImGuiKey_KeypadMultiply},
                                                               {"NumpadSubtract", ImGuiKey_KeypadSubtract},
                                                               {"NumpadAdd", ImGuiKey_KeypadAdd},
                                                               {"NumpadEnter", ImGuiKey_KeypadEnter},
                                                               {"NumpadEqual", ImGuiKey_KeypadEqual}};

ImGuiKey after(ImGuiKey first, int steps) { return ImGuiKey(int(first) + steps); }

bool isDigit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

ImGuiKey keyOfPage(std::string_view code) {
  for (const auto& [name, key] : kPageKeys)
    if (code == name) return key;
  const char last = code.empty() ? '\0' : code.back();
  if (code.size() == 4 && code.starts_with("Key")) return keyOf(last);
  if (code.size() == 6 && code.starts_with("Digit")) return keyOf(last);
  if (code.size() == 7 && code.starts_with("Numpad") && isDigit(last)) return after(ImGuiKey_Keypad0, last - '0');
  if (code.size() == 2 && code[0] == 'F' && last >= '1' && last <= '9') return after(ImGuiKey_F1, last - '1');
  if (code.size() == 3 && code.starts_with("F1") && last >= '0' && last <= '2') return after(ImGuiKey_F10, last - '0');
  return ImGuiKey_None;
}

}  // namespace moltact
