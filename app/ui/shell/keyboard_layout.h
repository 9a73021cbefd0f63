// Maps a key's place to the key printed on the user's keyboard. Window systems name a key by its place on a US
// keyboard. On a German keyboard the place of Y has the letter Z, on a French one the place of Q has A. Window's
// thread.
#pragma once

#include <functional>
#include <string_view>

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

/// Returns the character in UTF-8 that the key at that place writes without modifiers in the current layout: "z" for
/// the place of Y on QWERTZ. Empty if the key writes none or its character is unknown.
using KeyboardLayout = std::function<std::string_view(ImGuiKey place)>;

/// Returns the key for shortcuts. A letter, digit or punctuation mark known to ImGui is identified by its character.
/// The digit row is 1 to 0 also where digits need Shift (AZERTY). A key with another character ("ö", "я") keeps the
/// name of its place. If another key writes the character of that place, it is ImGuiKey_None instead. Keys that write
/// nothing and the keypad stay unchanged.
ImGuiKey keyOnLayout(ImGuiKey place, const KeyboardLayout& layout);

}  // namespace moltact
