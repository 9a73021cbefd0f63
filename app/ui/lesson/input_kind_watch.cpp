#include "app/ui/lesson/input_kind_watch.h"

#include <algorithm>
#include <iterator>

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

void InputKindWatch::look(const ImGuiIO& io) {
  // Shift and Ctrl are excluded, because they also modify drags of the mouse.
  bool key = false;
  for (std::size_t k = 0; k < kKeyCount; ++k) key = key || (!isModifier(keyAt(k)) && ImGui::IsKeyDown(keyAt(k)));
  const bool button = std::any_of(std::begin(io.MouseDown), std::end(io.MouseDown), [](bool down) { return down; });
  // Motion alone does not count, because a hand may lean on the mouse while typing.
  if (button || io.MouseWheel != 0.0f)
    kind_ = InputKind::Mouse;
  else if (key)
    kind_ = InputKind::Keyboard;
  else if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f)
    kind_ = InputKind::Mouse;
}

}  // namespace moltact
