// Keys by their names, as menus show them and scripts write them: "Ctrl+Shift+S", "F1", "Page Up". Window's thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

/// The key of a letter, in either case, or of a digit; ImGuiKey_None for another character.
ImGuiKey keyOf(char character);

/// Keys joined by "+", in capitals or not, with or without spaces ("pageup"); empty where one is not known.
/// A modifier gives its left key.
std::vector<ImGuiKey> keysNamed(std::string_view names);

/// The names as a person reads them on the keys: "Ctrl+Home" is "Strg+Pos1" in German.
std::string keysText(std::string_view names);
/// A label and the key that does the same: "Check  (Enter)".
std::string withKey(std::string_view label, std::string_view names);

/// Whether these keys were pressed in this frame: the last of them newly, the modifiers and no others held. "?" means
/// the character, wherever the keyboard has it. An empty text never is.
bool keysPressed(std::string_view names);

}  // namespace moltact
