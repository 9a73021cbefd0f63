#include "app/ui/lesson/input_way_watch.h"

#include <algorithm>
#include <iterator>

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

void InputWayWatch::look(const ImGuiIO& io) {
  // Shift and Ctrl belong to drags of the mouse as well.
  bool key = false;
  for (std::size_t k = 0; k < kKeyCount; ++k) key = key || (!isModifier(keyAt(k)) && ImGui::IsKeyDown(keyAt(k)));
  const bool button = std::any_of(std::begin(io.MouseDown), std::end(io.MouseDown), [](bool down) { return down; });
  // A hand that leans on the mouse while it types stays at the keyboard.
  if (button || io.MouseWheel != 0.0f)
    way_ = InputWay::Mouse;
  else if (key)
    way_ = InputWay::Keyboard;
  else if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f)
    way_ = InputWay::Mouse;
}

}  // namespace moltact
