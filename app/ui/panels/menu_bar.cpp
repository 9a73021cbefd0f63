// Top: the menus, and switches for the side panels at the right end.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/ui/application.h"
#include "app/ui/controls.h"
#include "app/ui/library.h"
#include "app/ui/shape_label.h"
#include "app/ui/theme.h"
#include "app/ui/widget_map.h"

namespace moltact {
namespace {

bool item(const char* name, const char* label, const char* shortcut = nullptr, bool on = false, bool enabled = true) {
  const bool chosen = ImGui::MenuItem(label, shortcut, on, enabled);
  recordItem(name, on ? "on" : "");
  return chosen;
}

bool beginMenu(const char* name, const char* label, bool enabled = true) {
  const bool open = ImGui::BeginMenu(label, enabled);
  // Within an open menu the last item is the menu's own window, so its head is recorded only while it is closed.
  if (!open) recordItem(name, label);
  return open;
}

void fileMenu(Application& app) {
  if (!beginMenu("menu/file", "File")) return;
  if (item("menu/file/open", "Open …", "Ctrl+O")) app.panels.open_page = true;
  if (beginMenu("menu/file/library", "Library")) {
    for (const LibraryItem& entry : library())
      if (item(("menu/file/library/" + entry.id).c_str(), entry.label.c_str())) app.open(entry.file);
    ImGui::EndMenu();
  }
  if (beginMenu("menu/file/recent", "Recent", !app.settings.recent.empty())) {
    std::string chosen;
    for (std::size_t k = 0; k < app.settings.recent.size(); ++k)
      if (item(("menu/file/recent/" + std::to_string(k)).c_str(), app.settings.recent[k].c_str())) chosen = app.settings.recent[k];
    if (!chosen.empty()) app.open(chosen);
    ImGui::EndMenu();
  }
  ImGui::Separator();
  if (item("menu/file/picture", "Save picture", "Ctrl+S", false, bool(app.stage))) app.take_picture = true;
  ImGui::Separator();
  if (item("menu/file/quit", "Quit", "Ctrl+Q")) app.quit = true;
  ImGui::EndMenu();
}

void viewMenu(Application& app) {
  if (!beginMenu("menu/view", "View")) return;
  Settings& s = app.settings;
  if (item("menu/view/lesson", "Lesson panel", nullptr, app.panels.lesson)) app.panels.lesson = !app.panels.lesson;
  if (item("menu/view/touch", "Touch panel", nullptr, app.panels.touch)) app.panels.touch = !app.panels.touch;
  if (item("menu/view/methods", "Methods panel", nullptr, app.panels.methods)) app.showMethods(!app.panels.methods);
  if (beginMenu("menu/view/shapes", "Shapes")) {
    for (const ShapeName& shape : shapeNames()) {
      const bool on = app.shown.has(shape.shape);
      if (item(("menu/view/shapes/" + std::string(shape.name)).c_str(), shapeLabel(shape).c_str(), nullptr, on))
        app.shown.set(shape.shape, !on);
    }
    ImGui::EndMenu();
  }
  ImGui::Separator();
  if (item("menu/view/light", "Light", nullptr, s.theme == ThemeChoice::Light)) s.theme = ThemeChoice::Light;
  if (item("menu/view/dark", "Dark", nullptr, s.theme == ThemeChoice::Dark)) s.theme = ThemeChoice::Dark;
  if (beginMenu("menu/view/scale", "Interface size")) {
    for (const int percent : {75, 90, 100, 125, 150, 175, 200, 250, 300}) {
      char label[16];
      std::snprintf(label, sizeof label, "%d %%", percent);
      if (item(("menu/view/scale/" + std::to_string(percent)).c_str(), label, nullptr, s.scale * 100.0 == double(percent)))
        s.scale = percent / 100.0;
    }
    ImGui::EndMenu();
  }
  ImGui::Separator();
  if (item("menu/view/reset", "Reset view", "Home", false, bool(app.stage))) app.resetView();
  ImGui::EndMenu();
}

void lessonMenu(Application& app) {
  if (!beginMenu("menu/lesson", "Lesson")) return;
  if (item("menu/lesson/next", "Next step", "Alt+Right", false, app.lesson.canGoOn())) app.lesson.next();
  if (item("menu/lesson/back", "Previous step", "Alt+Left", false, app.lesson.canGoBack())) app.lesson.back();
  ImGui::Separator();
  for (const LibraryItem& entry : lessons())
    if (item(("menu/lesson/" + entry.id).c_str(), entry.label.c_str())) app.open(entry.file);
  ImGui::EndMenu();
}

void helpMenu(Application& app) {
  if (!beginMenu("menu/help", "Help")) return;
  if (item("menu/help/controls", "Controls", "F1")) app.panels.controls_page = true;
  if (item("menu/help/about", "About Moltact")) app.panels.about_page = true;
  ImGui::EndMenu();
}

// Where only one side panel has room, showing one hides the other.
void panelSwitch(Application& app, const char* name, Icon icon, const char* tip, bool lesson) {
  bool& wanted = lesson ? app.panels.lesson : app.panels.touch;
  const bool seen = !(lesson ? app.layout.lesson : app.layout.touch).empty();
  if (!iconButton(name, icon, tip, seen)) return;
  if (seen) wanted = false;
  else {
    wanted = true;
    app.panels.lesson_first = lesson;
  }
}

}  // namespace

void drawMenuBar(Application& app) {
  const Look& l = look();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {l.px(8), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {l.px(8), std::floor(0.5f * (app.layout.menu.size().y - ImGui::GetFontSize()))});
  const bool shown = beginPanel("menu bar", app.layout.menu, ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (shown && ImGui::BeginMenuBar()) {
    // The bar's own paddings are not the menus'.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {l.px(12), l.px(10)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {l.px(16), l.px(10)});
    fileMenu(app);
    viewMenu(app);
    lessonMenu(app);
    helpMenu(app);
    ImGui::PopStyleVar(2);
    ImGui::EndMenuBar();
  }
  if (shown) {
    const Rectangle& r = app.layout.menu;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRectFullScreen();
    draw->AddLine({r.low.x, r.high.y - 1}, {r.high.x, r.high.y - 1}, l.palette.line, std::max(1.0f, l.scale));
    draw->PopClipRect();
    endPanel();
  }
  ImGui::PopStyleVar(2);
  const float size = l.px(30), edge = 0.5f * (app.layout.menu.size().y - size);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {l.px(4), 0});
  const float right = app.layout.menu.high.x;
  if (beginOverlay("menu bar/switches", {{right - 2 * size - l.px(14), edge}, {right, edge + size}})) {
    panelSwitch(app, "switch/lesson", Icon::LeftPanel, "Lesson panel", true);
    ImGui::SameLine();
    panelSwitch(app, "switch/touch", Icon::RightPanel, "Touch panel", false);
    endPanel();
  }
  ImGui::PopStyleVar();
}

}  // namespace moltact
