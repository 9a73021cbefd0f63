#include "app/ui/shell/pointers.h"

#include <imgui.h>

#include "app/ui/application/application.h"
#include "app/ui/panels/push_pads.h"
#include "app/ui/panels/splitters.h"
#include "app/ui/widgets/widget_map.h"

namespace moltact {
namespace {

bool within(glm::dvec2 at, glm::vec2 low, glm::vec2 high) {
  return at.x >= double(low.x) && at.x < double(high.x) && at.y >= double(low.y) && at.y < double(high.y);
}

}  // namespace

Fingers::Target fingerOn(const Application& app, glm::dvec2 at) {
  if (app.panels.pages.welcome || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
    return Fingers::Target::Panel;
  const auto& all = widgets().all();
  const auto on = [&](const char* name) {
    const auto found = all.find(name);
    return found != all.end() && within(at, found->second.low, found->second.high);
  };
  for (const char* edge : kPanelEdges)
    if (on(edge)) return Fingers::Target::Edge;
  const Rectangle& view = app.layout().view;
  if (!within(at, view.low, view.high)) return Fingers::Target::Panel;
  return on(kHarderPad) ? Fingers::Target::Harder : on(kLighterPad) ? Fingers::Target::Lighter : Fingers::Target::View;
}

void Pointers::mouse(glm::dvec2 place) {
  app_.panels.window.fingers = false;
  to_.pointer(place.x, place.y);
}

void Pointers::fingerDown(int id, glm::dvec2 place, double now_s) {
  const Fingers::Target on = fingerOn(app_, place);
  app_.panels.window.fingers = true;
  fingers_.down(id, place, on, now_s, double(ImGui::GetFontSize()));
}

}  // namespace moltact
