// Help: what mouse and keys do, over the molecule and in the program.
#include <array>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/panels/actions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"

namespace moltact {
namespace {

struct Row {
  const char *what, *mouse, *keys;
};
// What is no command but a movement.
constexpr std::array kRows{
    Row{"Move the probe", "move", "arrows"},
    Row{"Push it in", "hold left button", "hold Space"},
    Row{"Push harder, softer", "wheel while pushing", "+   −"},
    Row{"Let go", "release", "Esc"},
    Row{"Turn the molecule", "drag right button", "Ctrl + arrows"},
    Row{"Move the view", "drag middle button", "Shift + arrows"},
    Row{"Closer, farther", "wheel", "Page Up, Page Down"},
    Row{"Answer a question", "click", "1 to 9, then Enter for several"},
    Row{"Write an answer", "click the field", "A, then Enter"},
    Row{"Buttons of a task", "click", "Enter, or the letter on it"},
    Row{"Hints", "click", "H"},
    Row{"Link in what is said", "click", "G"},
    Row{"Scroll the lesson", "wheel", "Ctrl + Page Up, Page Down"},
    Row{"Next, previous method", "click", "M, Shift + M"},
    Row{"From control to control", "", "Tab, Shift + Tab"},
    Row{"From panel to panel", "", "F6, Shift + F6"},
    Row{"Press it, change it", "click, drag", "Space or Enter, arrows"},
    Row{"Back to the molecule", "click", "Esc"},
    Row{"Menus", "click", "F10 or Alt, or Alt + F, E, V, L, H"},
    Row{"Open a file", "drop it on the window", "Ctrl + O"},
    Row{"Leave the molecule", "house in the tool bar", "Esc with a free hand"},
};

void head(const char* text) {
  ImGui::TableNextColumn();
  WithText quiet(look().palette.quiet);
  ImGui::TextWrapped("%s", text);
}

// Left and right change places for a left-handed mouse.
std::string forHand(std::string text, bool left_handed) {
  if (!left_handed) return text;
  if (const std::size_t at = text.find("left button"); at != std::string::npos) return text.replace(at, 4, "right");
  if (const std::size_t at = text.find("right button"); at != std::string::npos) return text.replace(at, 5, "left");
  return text;
}

void drawMovements(const Application& app) {
  if (!ImGui::BeginTable("rows", 3,
                         ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_PadOuterX))
    return;
  ImGui::TableSetupColumn("", 0, 1.1f);
  ImGui::TableSetupColumn("Mouse", 0, 1.1f);
  ImGui::TableSetupColumn("Keyboard", 0, 1.2f);
  ImGui::TableNextRow();
  for (const char* text : {"Over the molecule", "Mouse", "Keyboard"}) head(text);
  for (const Row& row : kRows) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    {
      WithFont strong(Font::Strong);
      ImGui::TextWrapped("%s", row.what);
    }
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", forHand(row.mouse, app.settings.left_handed).c_str());
    recordItem(std::string("controls/") + row.what, forHand(row.mouse, app.settings.left_handed));
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", row.keys);
  }
  ImGui::EndTable();
}

void drawCommands() {
  if (!ImGui::BeginTable("commands", 3,
                         ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_PadOuterX))
    return;
  ImGui::TableSetupColumn("", 0, 1.1f);
  ImGui::TableSetupColumn("Menu", 0, 1.1f);
  ImGui::TableSetupColumn("Keyboard", 0, 1.2f);
  ImGui::TableNextRow();
  for (const char* text : {"In the program", "Menu", "Keyboard"}) head(text);
  for (const Action& a : allActions()) {
    if (a.shortcut.empty()) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    {
      WithFont strong(Font::Strong);
      ImGui::TextWrapped("%s", std::string(a.label).c_str());
    }
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", std::string(menuLabel(a.menu)).c_str());
    ImGui::TableNextColumn();
    std::string keys(a.shortcut);
    if (!a.also.empty()) keys += " or " + std::string(a.also);
    ImGui::TextWrapped("%s", keys.c_str());
    recordItem("controls/command/" + std::string(a.name), keys);
  }
  ImGui::EndTable();
}

}  // namespace

void drawControlsPage(Application& app) {
  if (!beginPage("controls", "Mouse and keys", app.panels.controls_page, 640, 700)) return;
  ImGui::BeginChild("sheet");
  drawMovements(app);
  ImGui::Dummy({0, look().px(10)});
  drawCommands();
  ImGui::EndChild();
  endPage();
}

}  // namespace moltact
