// The program's icons, drawn with lines so that they fit every scale and theme.
#include <algorithm>
#include <cmath>

#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"

namespace moltact {

void drawIcon(ImDrawList* draw, Icon icon, ImVec2 c, float size, ImU32 colour) {
  const float h = 0.5f * size, w = std::max(1.5f, 0.1f * size);
  const auto at = [&](float x, float y) { return ImVec2(c.x + x * h, c.y + y * h); };
  const auto path = [&](std::initializer_list<ImVec2> points, bool closed = false) {
    for (const ImVec2& p : points) draw->PathLineTo(p);
    draw->PathStroke(colour, closed ? ImDrawFlags_Closed : 0, w);
  };
  switch (icon) {
    case Icon::None:
      break;
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
    case Icon::Check:
      path({at(-0.6f, 0.05f), at(-0.15f, 0.5f), at(0.65f, -0.5f)});
      break;
    case Icon::ChevronRight:
      path({at(-0.3f, -0.6f), at(0.35f, 0), at(-0.3f, 0.6f)});
      break;
    case Icon::ChevronDown:
      path({at(-0.6f, -0.3f), at(0, 0.35f), at(0.6f, -0.3f)});
      break;
    case Icon::Folder:
      path({at(-1, 0.75f), at(-1, -0.7f), at(-0.3f, -0.7f), at(0, -0.4f), at(1, -0.4f), at(1, 0.75f)}, true);
      break;
    case Icon::File:
      path({at(-0.7f, 1), at(-0.7f, -1), at(0.2f, -1), at(0.7f, -0.5f), at(0.7f, 1)}, true);
      path({at(0.2f, -1), at(0.2f, -0.5f), at(0.7f, -0.5f)});
      break;
    case Icon::Undo:
    case Icon::Redo: {
      const float s = icon == Icon::Undo ? 1.0f : -1.0f;
      path({at(-0.35f * s, -0.9f), at(-0.85f * s, -0.4f), at(-0.35f * s, 0.1f)});
      for (int k = 0; k <= 12; ++k) {
        const float a = -1.5708f + 3.1416f * float(k) / 12.0f;
        if (k == 0) draw->PathLineTo(at(-0.8f * s, -0.4f));
        draw->PathLineTo(at((0.25f + 0.6f * std::cos(a)) * s, 0.2f + 0.6f * std::sin(a)));
      }
      draw->PathLineTo(at(-0.2f * s, 0.8f));
      draw->PathStroke(colour, 0, w);
      break;
    }
    case Icon::Camera:
      draw->AddRect(at(-1, -0.55f), at(1, 0.8f), colour, 0.25f * h, 0, w);
      path({at(-0.45f, -0.6f), at(-0.25f, -0.9f), at(0.25f, -0.9f), at(0.45f, -0.6f)});
      draw->AddCircle(at(0, 0.12f), 0.38f * h, colour, 24, w);
      break;
    case Icon::Gear:
      draw->AddCircle(c, 0.6f * h, colour, 28, w);
      draw->AddCircle(c, 0.2f * h, colour, 16, w);
      for (int k = 0; k < 8; ++k) {
        const float a = 0.7854f * float(k), x = std::cos(a), y = std::sin(a);
        draw->AddLine(at(0.62f * x, 0.62f * y), at(0.95f * x, 0.95f * y), colour, 1.5f * w);
      }
      break;
    case Icon::FullScreen:
    case Icon::Fit:
      for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f})
          path({at(0.85f * x, 0.35f * y), at(0.85f * x, 0.85f * y), at(0.35f * x, 0.85f * y)});
      if (icon == Icon::Fit) draw->AddCircleFilled(c, 0.22f * h, colour, 16);
      break;
    case Icon::Sound:
      path(
          {at(-0.9f, -0.3f), at(-0.5f, -0.3f), at(-0.05f, -0.75f), at(-0.05f, 0.75f), at(-0.5f, 0.3f), at(-0.9f, 0.3f)},
          true);
      for (const float r : {0.4f, 0.8f}) {
        draw->PathArcTo(at(0.05f, 0), r * h, -0.8f, 0.8f, 12);
        draw->PathStroke(colour, 0, w);
      }
      break;
    case Icon::Question:
      draw->AddCircle(c, 0.92f * h, colour, 28, w);
      path({at(-0.28f, -0.22f), at(-0.2f, -0.42f), at(0, -0.5f), at(0.22f, -0.42f), at(0.28f, -0.2f), at(0.18f, -0.02f),
            at(0, 0.1f), at(0, 0.24f)});
      draw->AddCircleFilled(at(0, 0.5f), 0.11f * h, colour, 12);
      break;
    case Icon::Up:
      path({at(-0.6f, -0.1f), at(0, -0.7f), at(0.6f, -0.1f)});
      path({at(0, -0.6f), at(0, 0.8f)});
      break;
  }
}

}  // namespace moltact
