// Help: what mouse and keys do.
#include <array>

#include "app/ui/application.h"
#include "app/ui/controls.h"
#include "app/ui/theme.h"

namespace moltact {
namespace {

struct Row {
  const char *what, *mouse, *keys;
};
constexpr std::array kRows{
    Row{"Move the probe", "move", "arrows"},
    Row{"Push it in", "hold left button", "hold Space"},
    Row{"Push harder, softer", "wheel while pushing", "+   −"},
    Row{"Let go", "release", "Esc"},
    Row{"Turn the molecule", "drag right button", "Ctrl + arrows"},
    Row{"Move the view", "drag middle button", "Shift + arrows"},
    Row{"Closer, farther", "wheel", "Page Up, Page Down"},
    Row{"Reset the view", "house in the corner", "Home"},
    Row{"Lesson: next, back", "Next, Back", "Alt + right, Alt + left"},
    Row{"Lesson: answer", "click", "1 to 9"},
    Row{"Open a file", "drop it on the window", "Ctrl + O"},
    Row{"This page", "Help, Controls", "F1"},
    Row{"Leave", "File, Quit", "Ctrl + Q"},
};

}  // namespace

void drawControlsPage(Application& app) {
  if (!beginPage("controls", "Controls", app.panels.controls_page, 640, 560)) return;
  if (ImGui::BeginTable("rows", 3, ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_PadOuterX)) {
    ImGui::TableSetupColumn("", 0, 1.1f);
    ImGui::TableSetupColumn("Mouse", 0, 1.1f);
    ImGui::TableSetupColumn("Keyboard", 0, 1.2f);
    ImGui::TableNextRow();
    for (const char* head : {"", "Mouse", "Keyboard"}) {
      ImGui::TableNextColumn();
      WithText quiet(look().palette.quiet);
      ImGui::TextUnformatted(head);
    }
    for (const Row& row : kRows) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      {
        WithFont strong(Font::Strong);
        ImGui::TextWrapped("%s", row.what);
      }
      ImGui::TableNextColumn();
      ImGui::TextWrapped("%s", row.mouse);
      ImGui::TableNextColumn();
      ImGui::TextWrapped("%s", row.keys);
    }
    ImGui::EndTable();
  }
  endPage();
}

}  // namespace moltact
