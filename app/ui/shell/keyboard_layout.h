// From the place of a key to the key that a person reads on it. Windows and pages name a key by its place on a keyboard
// of the United States; on a German keyboard the place of Y has the letter Z, on a French one the place of Q has A.
// Window's thread.
#pragma once

#include <functional>
#include <string_view>

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

/// The character that the key at that place writes without Shift, Ctrl or Alt, in UTF-8, as the layout in use has it:
/// "z" for the place of Y on QWERTZ. Empty for a key that writes none, and for one whose character is not known.
using KeyboardLayout = std::function<std::string_view(ImGuiKey place)>;

/// The key that shortcuts mean. A letter, a digit or a punctuation mark of ImGui's goes by its character. The row of
/// digits is 1 to 0 also where digits need Shift (AZERTY). A key whose character ImGui has no name for ("ö", "я") keeps
/// the name of its place, unless another key writes the character of that place: then it is ImGuiKey_None. Keys that
/// write nothing and those of the number pad stay as they are.
ImGuiKey keyOnLayout(ImGuiKey place, const KeyboardLayout& layout);

}  // namespace moltact
