// How the atoms are drawn, in the words of a lesson's scene: a field for each key, and its error below.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {

void drawLookPage(Application& app) {
  PanelState& panels = app.panels;
  const bool appears = panels.pages.look && !ImGui::IsPopupOpen("look");
  if (!beginPage("look", tr("How the atoms are drawn"), panels.pages.look, 600, 620)) return;
  OwnLook& own = app.extensions().own_look;
  const Look& l = look();
  ImGui::TextWrapped("%s", tr("In the words of a lesson's scene: what works here works there. Without a style or "
                              "colours here, the picture keeps those that it has."));
  ImGui::Spacing();
  bool asked = false, faulty = false;
  const auto faults =
      app.scene.stage() ? own.faults(app.scene.stage().molecule) : std::array<std::string, OwnLook::kKeys>{};
  for (std::size_t k = 0; k < OwnLook::kKeys; ++k) {
    const OwnLookKey& key = OwnLook::keys()[k];
    const std::string id = "##" + std::string(key.key);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr(key.label));
    ImGui::SameLine(l.tx(206));
    ImGui::SetNextItemWidth(-1.0f);
    asked = ImGui::InputTextWithHint(id.c_str(), key.example, &own.values[k], ImGuiInputTextFlags_EnterReturnsTrue) ||
            asked;
    recordItem("look/" + std::string(key.key), own.values[k]);
    if (appears && k == 0) writeInLastField(id.c_str());
    const std::string& fault = faults[k];
    faulty = faulty || !fault.empty();
    // Reserves a line, so that nothing below moves during typing.
    const float y = ImGui::GetCursorPosY();
    ImGui::SetCursorPosX(l.tx(206));
    {
      const WithText bad(l.palette.bad);
      const WithFont small(Font::Small);
      ImGui::TextWrapped("%s", fault.c_str());
      recordItem("look/" + std::string(key.key) + "/fault", fault);
    }
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), y + 1.1f * ImGui::GetTextLineHeightWithSpacing()));
  }
  asked = button("look/show", tr("Show it so"), ButtonLook::Primary, -1.0f, !faulty) || asked;
  if (asked && !faulty) {
    own.show(app.scene);
    panels.pages.look = false;
    ImGui::CloseCurrentPopup();
  }
  endPage();
}

}  // namespace moltact
