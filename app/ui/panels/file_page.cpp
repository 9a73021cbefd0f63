// The dialog for an output file or a folder: place and name.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "app/ui/application/application.h"
#include "app/ui/files/file_list.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {

void drawFilePage(Application& app) {
  FileDialog& d = app.file_dialog;
  bool open = d.open();
  const std::string title = open ? d.question().title : std::string();
  if (!beginPage("file", title.c_str(), open, 640, 560)) return;
  const Look& l = look();
  const bool folder = d.asksForFolder();
  bool chosen = false;
  const std::filesystem::path answer = d.answer();
  std::error_code ignored;
  const bool there = !folder && !answer.empty() && std::filesystem::exists(answer, ignored);
  if (open) {
    if (!folder) {
      ImGui::SetNextItemWidth(-1.0f);
      chosen = ImGui::InputText("##name", &d.written, ImGuiInputTextFlags_EnterReturnsTrue) && !there;
      recordItem("file/name", d.written);
      if (!d.question().note.empty()) {
        const WithText quiet(l.palette.quiet);
        ImGui::TextWrapped("%s", d.question().note.c_str());
        recordItem("file/note", d.question().note);
      }
    }
    {
      WithFont strong(Font::Strong);
      ImGui::TextUnformatted(elided(d.browser.folder().string(), ImGui::GetContentRegionAvail().x).c_str());
      recordItem("file/folder", d.browser.folder().string());
    }
    const float foot = l.tx(34) + l.px(12) + (there ? ImGui::GetTextLineHeightWithSpacing() : 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {l.px(8), l.px(2)});
    ImGui::BeginChild("entries", {0, -foot});
    const std::filesystem::path file =
        drawFileList(d.browser, "file", folder ? tr("No folders here.") : tr("No folders or files of this kind here."));
    if (!file.empty()) d.written = file.filename().string();
    ImGui::EndChild();
    ImGui::PopStyleVar();
    if (!d.browser.fault().empty() || there) {
      WithText warn(l.palette.warn);
      ImGui::TextWrapped("%s", there ? tr("There is already a file of this name.") : d.browser.fault().c_str());
      recordItem("file/warning", "there");
    }
    const char* label = folder ? tr("Choose this folder") : there ? tr("Replace it") : tr("Save");
    chosen = button("file/choose", label, ButtonLook::Primary, -1.0f, !answer.empty()) || chosen;
  }
  if (chosen) {
    ImGui::CloseCurrentPopup();
    d.choose();
  } else if (!open) {
    d.close();
  }
  endPage();
}

}  // namespace moltact
