// File > Open: folders and readable files, recent files, and the library.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/files/file_kinds.h"
#include "app/ui/files/file_list.h"
#include "app/ui/files/library.h"
#include "app/ui/files/user_folders.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/reader.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

void chooseFile(Application& app, const fs::path& file) {
  if (app.panels.open_adds)
    app.extensions().lesson_list.add(file);
  else
    app.open(file);
  app.panels.pages.open = false;
  ImGui::CloseCurrentPopup();
}

bool isLesson(const fs::path& file) {
  const std::optional<FileKind> kind = fileKind(file);
  return kind == FileKind::Lesson || kind == FileKind::Pack;
}

void drawShelf(Application& app) {
  const auto offer = [&](const char* title, const char* prefix, const std::vector<LibraryItem>& entries) {
    if (entries.empty()) return;
    sectionTitle(title);
    for (const LibraryItem& entry : entries)
      if (fileRow(prefix + entry.id, Icon::File, entry.label, RowLabel::Whole)) chooseFile(app, entry.file);
    ImGui::Dummy({0, look().px(6)});
  };
  offer(tr("Molecules"), "open/library/", library());
  offer(tr("Lessons"), "open/lesson/", lessons());
  if (app.settings.recent.empty()) return;
  sectionTitle(tr("Recent"));
  std::string chosen;
  for (std::size_t k = 0; k < app.settings.recent.size(); ++k)
    if (fileRow("open/recent/" + std::to_string(k), Icon::File, fs::path(app.settings.recent[k]).filename().string()))
      chosen = app.settings.recent[k];
  if (!chosen.empty()) chooseFile(app, chosen);
}

}  // namespace

void drawOpenPage(Application& app) {
  PanelState& panels = app.panels;
  FileBrowser& b = app.files;
  const bool adds = panels.open_adds;
  if (!beginPage("open", adds ? tr("Add a lesson to your shelf") : tr("Open a molecule or a lesson"), panels.pages.open,
                 900, 660)) {
    panels.open_adds = panels.open_adds && panels.pages.open;
    b.open = false;
    return;
  }
  const bool newly = !std::exchange(b.open, true);
  if (newly) {
    b.accept(adds ? FileBrowser::Accept(isLesson) : FileBrowser::Accept());
    std::error_code ignored;
    if (b.folder().empty())
      b.look(fs::current_path(ignored));
    else
      b.look(b.folder());
    b.typed.clear();
  }
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered =
      ImGui::InputTextWithHint("##path", b.folder().string().c_str(), &b.typed, ImGuiInputTextFlags_EnterReturnsTrue);
  recordItem("open/path", b.typed);
  if (newly) writeInLastField("##path");
  if (entered && !b.typed.empty()) {
    fs::path where = typedPath(b.typed);
    if (where.is_relative()) where = b.folder() / where;
    std::error_code ignored;
    if (fs::is_directory(where, ignored)) {
      b.look(where);
      b.typed.clear();
    } else {
      chooseFile(app, where);
    }
  }
  if (!b.fault().empty()) {
    WithText bad(look().palette.bad);
    ImGui::TextWrapped("%s", b.fault().c_str());
  }
  ImGui::Dummy({0, look().px(2)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {look().px(8), look().px(2)});
  if (!adds) {
    const float shelf = std::min(look().tx(350), 0.45f * ImGui::GetContentRegionAvail().x);
    ImGui::BeginChild("shelf", {shelf, 0});
    drawShelf(app);
    ImGui::EndChild();
    ImGui::SameLine(0, look().px(18));
  }
  ImGui::BeginChild("folder");
  {
    WithFont strong(Font::Strong);
    ImGui::TextUnformatted(elided(b.folder().string(), ImGui::GetContentRegionAvail().x).c_str());
  }
  const std::string nothing =
      adds ? std::string(tr("No folders or lessons (.moltact .md) here."))
           : trf("No folders, molecules ({0}, also .gz) or lessons (.moltact .md) here.", moleculeEndingsText());
  const fs::path file = drawFileList(b, "open", nothing.c_str());
  if (!file.empty()) chooseFile(app, file);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  panels.open_adds = panels.open_adds && panels.pages.open;
  endPage();
}

}  // namespace moltact
