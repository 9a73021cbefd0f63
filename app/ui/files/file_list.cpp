#include "app/ui/files/file_list.h"

#include <imgui.h>

#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {

namespace fs = std::filesystem;

bool fileRow(const std::string& name, Icon icon, const std::string& label, RowLabel shows) {
  const Look& l = look();
  ImGui::PushID(name.c_str());
  const float width = ImGui::GetContentRegionAvail().x, room = width - l.px(40);
  const bool wraps = shows == RowLabel::Whole;
  const float text_high = ImGui::CalcTextSize(label.c_str(), nullptr, false, wraps ? room : -1.0f).y;
  const float high = l.tx(30) + (wraps ? text_high - ImGui::GetFontSize() : 0.0f);
  const bool clicked = ImGui::InvisibleButton("row", {width, high});
  ImGui::PopID();
  const ImVec2 low = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) draw->AddRectFilled(low, end, l.palette.hovered, l.px(6));
  const float middle = 0.5f * (low.y + end.y);
  drawIcon(draw, icon, {low.x + l.px(16), middle}, l.px(14), icon == Icon::Folder ? l.palette.accent : l.palette.quiet);
  const std::string shown = wraps ? label : elided(label, room);
  draw->AddText(nullptr, 0.0f, {low.x + l.px(34), middle - 0.5f * (wraps ? text_high : ImGui::GetFontSize())},
                l.palette.text, shown.c_str(), nullptr, wraps ? room : 0.0f);
  recordItem(name, label);
  return clicked;
}

fs::path drawFileList(FileBrowser& b, const std::string& prefix, const char* nothing) {
  fs::path next, file;
  if (b.folder().has_parent_path() && b.folder() != b.folder().parent_path() &&
      fileRow(prefix + "/up", Icon::Up, tr("Parent folder")))
    next = b.folder().parent_path();
  ImGuiListClipper clipper;
  clipper.Begin(int(b.entries().size()), look().tx(30) + ImGui::GetStyle().ItemSpacing.y);
  while (clipper.Step())
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
      const FileEntry& e = b.entries()[std::size_t(k)];
      if (!fileRow(prefix + "/entry/" + e.name, e.folder ? Icon::Folder : Icon::File, e.name)) continue;
      (e.folder ? next : file) = b.folder() / e.name;
    }
  if (b.entries().empty()) {
    WithText quiet(look().palette.quiet);
    ImGui::TextWrapped("%s", nothing);
  }
  if (!next.empty()) b.look(next);
  return file;
}

}  // namespace moltact
