// The keys of a window of GLFW's as ImGui names them.
#pragma once

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

/// For one of GLFW_KEY_…; ImGuiKey_None for a key that ImGui has no name for. Both name keys by their place on a
/// keyboard of the United States.
ImGuiKey keyOfGlfw(int glfw_key);
/// The other way round; GLFW_KEY_UNKNOWN for a key that GLFW has no name for.
int glfwKeyOf(ImGuiKey key);

}  // namespace moltact
