// Converts between the keys of GLFW and of ImGui.
#pragma once

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

/// The key for one of GLFW_KEY_…, or ImGuiKey_None if ImGui has no name for it. Both libraries name keys by their place
/// on a US keyboard.
ImGuiKey keyOfGlfw(int glfw_key);
/// The inverse; GLFW_KEY_UNKNOWN if GLFW has no name for the key.
int glfwKeyOf(ImGuiKey key);

}  // namespace moltact
