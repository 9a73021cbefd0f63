// File > Open: folders and files that can be read, what was opened last, and the library.
#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/ui/application.h"
#include "app/ui/controls.h"
#include "app/ui/library.h"
#include "app/ui/theme.h"
#include "app/ui/widget_map.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct Entry {
  std::string name;
  bool folder = false;
};

// The page's own state: where it looks and what it found there.
struct Browser {
  fs::path folder;
  std::vector<Entry> entries;
  std::string typed, trouble;
  bool begun = false;

  void look(const fs::path& where) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(where, error);
    fs::directory_iterator it(whole, fs::directory_options::skip_permission_denied, error);
    if (error) {
      trouble = "The folder " + where.string() + " cannot be read: " + error.message() + ".";
      return;
    }
    trouble.clear();
    folder = whole;
    entries.clear();
    for (; it != fs::directory_iterator(); it.increment(error)) {
      if (error) break;
      std::error_code ignored;
      const std::string name = it->path().filename().string();
      if (name.starts_with('.')) continue;
      const bool is_folder = it->is_directory(ignored);
      if (is_folder || looksLikeMolecule(it->path()) || looksLikeLesson(it->path())) entries.push_back({name, is_folder});
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.folder != b.folder ? a.folder : a.name < b.name;
    });
  }
};

Browser& browser() {
  static Browser the_browser;
  return the_browser;
}

bool row(const std::string& name, Icon icon, const std::string& label) {
  const Look& l = look();
  ImGui::PushID(name.c_str());
  const float width = ImGui::GetContentRegionAvail().x, high = l.px(30);
  const bool clicked = ImGui::InvisibleButton("row", {width, high});
  ImGui::PopID();
  const ImVec2 low = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) draw->AddRectFilled(low, end, l.palette.hovered, l.px(6));
  const float middle = 0.5f * (low.y + end.y);
  drawIcon(draw, icon, {low.x + l.px(16), middle}, l.px(14), icon == Icon::Folder ? l.palette.accent : l.palette.quiet);
  const std::string shown = elided(label, width - l.px(40));
  draw->AddText({low.x + l.px(34), middle - 0.5f * ImGui::GetFontSize()}, l.palette.text, shown.c_str());
  recordItem(name, label);
  return clicked;
}

void chooseFile(Application& app, const fs::path& file) {
  app.open(file);
  app.panels.open_page = false;
  ImGui::CloseCurrentPopup();
}

void drawShelf(Application& app) {
  const auto offer = [&](const char* title, const char* prefix, const std::vector<LibraryItem>& entries) {
    if (entries.empty()) return;
    sectionTitle(title);
    for (const LibraryItem& entry : entries) {
      if (row(prefix + entry.id, Icon::File, entry.label)) chooseFile(app, entry.file);
      tip(entry.label.c_str());
    }
    ImGui::Dummy({0, look().px(6)});
  };
  offer("Molecules", "open/library/", library());
  offer("Lessons", "open/lesson/", lessons());
  if (app.settings.recent.empty()) return;
  sectionTitle("Recent");
  std::string chosen;
  for (std::size_t k = 0; k < app.settings.recent.size(); ++k)
    if (row("open/recent/" + std::to_string(k), Icon::File, fs::path(app.settings.recent[k]).filename().string())) chosen = app.settings.recent[k];
  if (!chosen.empty()) chooseFile(app, chosen);
}

void drawFolder(Application& app, Browser& b) {
  fs::path next;
  if (b.folder.has_parent_path() && b.folder != b.folder.parent_path() && row("open/up", Icon::Up, "Parent folder")) next = b.folder.parent_path();
  fs::path file;
  ImGuiListClipper clipper;
  clipper.Begin(int(b.entries.size()), look().px(30) + ImGui::GetStyle().ItemSpacing.y);
  while (clipper.Step())
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
      const Entry& e = b.entries[std::size_t(k)];
      if (!row("open/entry/" + e.name, e.folder ? Icon::Folder : Icon::File, e.name)) continue;
      (e.folder ? next : file) = b.folder / e.name;
    }
  if (b.entries.empty()) {
    WithText quiet(look().palette.quiet);
    ImGui::TextWrapped("No folders, molecules (.pdb .ent .cif .xyzr, also .gz) or lessons (.md) here.");
  }
  if (!next.empty()) b.look(next);
  if (!file.empty()) chooseFile(app, file);
}

}  // namespace

void drawOpenPage(Application& app) {
  if (!beginPage("open", "Open a molecule or a lesson", app.panels.open_page, 900, 660)) {
    browser().begun = false;
    return;
  }
  Browser& b = browser();
  if (!b.begun) {
    b.begun = true;
    std::error_code ignored;
    if (b.folder.empty()) b.look(fs::current_path(ignored));
    else b.look(b.folder);
    b.typed.clear();
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered = ImGui::InputTextWithHint("##path", b.folder.string().c_str(), &b.typed, ImGuiInputTextFlags_EnterReturnsTrue);
  recordItem("open/path", b.typed);
  if (entered && !b.typed.empty()) {
    fs::path where = b.typed;
    if (b.typed.starts_with("~/") && std::getenv("HOME")) where = fs::path(std::getenv("HOME")) / b.typed.substr(2);
    if (where.is_relative()) where = b.folder / where;
    std::error_code ignored;
    if (fs::is_directory(where, ignored)) {
      b.look(where);
      b.typed.clear();
    } else {
      chooseFile(app, where);
    }
  }
  if (!b.trouble.empty()) {
    WithText bad(look().palette.bad);
    ImGui::TextWrapped("%s", b.trouble.c_str());
  }
  ImGui::Dummy({0, look().px(2)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {look().px(8), look().px(2)});
  const float shelf = std::min(look().px(350), 0.45f * ImGui::GetContentRegionAvail().x);
  ImGui::BeginChild("shelf", {shelf, 0});
  drawShelf(app);
  ImGui::EndChild();
  ImGui::SameLine(0, look().px(18));
  ImGui::BeginChild("folder");
  {
    WithFont strong(Font::Strong);
    ImGui::TextUnformatted(elided(b.folder.string(), ImGui::GetContentRegionAvail().x).c_str());
  }
  drawFolder(app, b);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  endPage();
}

}  // namespace moltact
