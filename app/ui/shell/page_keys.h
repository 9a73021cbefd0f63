// The keys of a page's keyboard events as ImGui names them.
#pragma once

#include <string_view>

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

/// For a KeyboardEvent's `code` ("KeyA", "ArrowLeft"); ImGuiKey_None for a key that ImGui has no name for. Both name
/// keys by their place on a keyboard of the United States.
ImGuiKey keyOfPage(std::string_view code);

}  // namespace moltact
