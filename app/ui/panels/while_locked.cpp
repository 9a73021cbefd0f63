#include "app/ui/panels/while_locked.h"

#include "app/ui/application/application.h"
#include "app/ui/widgets/theme.h"
#include "engine/language/catalogue.h"

namespace moltact {

WhileLocked::WhileLocked(const Application& app, std::string_view key) : locked_(app.lesson.locks(key)) {
  if (!locked_) return;
  low_ = ImGui::GetCursorScreenPos();
  width_ = ImGui::GetContentRegionAvail().x;
  // The panel's colour is drawn over everything; ImGui would fade texts additionally.
  ImGui::PushStyleVar(ImGuiStyleVar_DisabledAlpha, 1.0f);
  ImGui::BeginDisabled();
}

WhileLocked::~WhileLocked() {
  if (!locked_) return;
  ImGui::EndDisabled();
  ImGui::PopStyleVar();
  const ImVec2 high{low_.x + width_, ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y};
  // The controls use the palette's own colours, which ImGui does not fade for disabled items.
  ImGui::GetWindowDrawList()->AddRectFilled(low_, high, faded(look().palette.panel, 0.5f));
  if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low_, high))
    ImGui::SetTooltip("%s", tr("The lesson keeps this as it is."));
}

}  // namespace moltact
