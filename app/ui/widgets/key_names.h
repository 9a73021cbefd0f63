// Names of keys as menus show them and scripts write them: "Ctrl+Shift+S", "F1", "Page Up". Window's thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

/// The key of a letter (either case) or digit; ImGuiKey_None for other characters.
ImGuiKey keyOf(char character);

/// Parses keys joined by "+", in any case, with or without spaces ("pageup"). Returns an empty list if a name is
/// unknown. A modifier gives its left key.
std::vector<ImGuiKey> keysNamed(std::string_view names);

/// The names as printed on keyboards: "Ctrl+Home" is "Strg+Pos1" in German.
std::string keysText(std::string_view names);
/// A label with its shortcut: "Check  (Enter)".
std::string withKey(std::string_view label, std::string_view names);

/// Whether these keys were pressed in this frame: the last key newly, with exactly the given modifiers. "?" means the
/// character, on any key. An empty text returns false.
bool keysPressed(std::string_view names);

}  // namespace moltact
