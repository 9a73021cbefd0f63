// Converts keys of a browser's keyboard events to keys of ImGui.
#pragma once

#include <string_view>

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

/// The key for a KeyboardEvent's `code` ("KeyA", "ArrowLeft"), or ImGuiKey_None if ImGui has no name for it. Both name
/// keys by their place on a US keyboard.
ImGuiKey keyOfPage(std::string_view code);

}  // namespace moltact
