// The few signs of the program, drawn with lines so that they fit every scale and theme.
#include <algorithm>
#include <cmath>

#include "app/ui/controls.h"
#include "app/ui/theme.h"

namespace moltact {

void drawIcon(ImDrawList* draw, Icon icon, ImVec2 c, float size, ImU32 colour) {
  const float h = 0.5f * size, w = std::max(1.5f, 0.1f * size);
  const auto at = [&](float x, float y) { return ImVec2(c.x + x * h, c.y + y * h); };
  const auto path = [&](std::initializer_list<ImVec2> points, bool closed = false) {
    for (const ImVec2& p : points) draw->PathLineTo(p);
    draw->PathStroke(colour, closed ? ImDrawFlags_Closed : 0, w);
  };
  switch (icon) {
    case Icon::None: break;
    case Icon::Home:
      path({at(-1, 0), at(0, -0.9f), at(1, 0)});
      path({at(-0.7f, -0.2f), at(-0.7f, 0.9f), at(0.7f, 0.9f), at(0.7f, -0.2f)});
      break;
    case Icon::LeftPanel:
    case Icon::RightPanel: {
      const float x = icon == Icon::LeftPanel ? -0.3f : 0.3f;
      draw->AddRect(at(-1, -0.8f), at(1, 0.8f), colour, 0.25f * h, 0, w);
      path({at(x, -0.8f), at(x, 0.8f)});
      break;
    }
    case Icon::Close:
      path({at(-0.6f, -0.6f), at(0.6f, 0.6f)});
      path({at(0.6f, -0.6f), at(-0.6f, 0.6f)});
      break;
    case Icon::Check: path({at(-0.6f, 0.05f), at(-0.15f, 0.5f), at(0.65f, -0.5f)}); break;
    case Icon::ChevronRight: path({at(-0.3f, -0.6f), at(0.35f, 0), at(-0.3f, 0.6f)}); break;
    case Icon::ChevronDown: path({at(-0.6f, -0.3f), at(0, 0.35f), at(0.6f, -0.3f)}); break;
    case Icon::Folder:
      path({at(-1, 0.75f), at(-1, -0.7f), at(-0.3f, -0.7f), at(0, -0.4f), at(1, -0.4f), at(1, 0.75f)}, true);
      break;
    case Icon::File:
      path({at(-0.7f, 1), at(-0.7f, -1), at(0.2f, -1), at(0.7f, -0.5f), at(0.7f, 1)}, true);
      path({at(0.2f, -1), at(0.2f, -0.5f), at(0.7f, -0.5f)});
      break;
    case Icon::Up:
      path({at(-0.6f, -0.1f), at(0, -0.7f), at(0.6f, -0.1f)});
      path({at(0, -0.6f), at(0, 0.8f)});
      break;
  }
}

}  // namespace moltact
