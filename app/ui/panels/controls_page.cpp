// Help > Mouse and keys: the controls of the view and of the program.
#include <array>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/panels/actions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

struct Row {
  const char *what, *mouse, *keys;
  const char* left_handed = nullptr;  // with a left-handed mouse; null: the same
  bool of_body = false;               // shown only while the hand holds a body
};
// Controls that are movements and not commands.
constexpr std::array kRows{
    Row{N_("Move the probe"), N_("move"), N_("arrows")},
    Row{N_("Push it in"), N_("hold left button"), N_("hold Space"), N_("hold right button")},
    Row{N_("Push harder, softer"), N_("wheel while pushing"), N_("+   −")},
    Row{N_("Let go"), N_("release"), N_("Esc")},
    Row{N_("Turn the molecule"), N_("drag right button"), N_("Ctrl + arrows"), N_("drag left button")},
    Row{N_("Turn what you hold"), N_("Ctrl, drag right button"), N_("Ctrl + Shift + arrows"),
        N_("Ctrl, drag left button"), true},
    Row{N_("Move the view"), N_("drag middle button"), N_("Shift + arrows")},
    Row{N_("Closer, farther"), N_("wheel"), N_("Page Up, Page Down")},
    Row{N_("Close to an atom"), N_("click twice"), N_("Ctrl + F")},
    Row{N_("Name of an atom"), N_("point at it"), ""},
    Row{N_("Answer a question"), N_("click"), N_("1 to 9, then Enter for several")},
    Row{N_("Write an answer"), N_("click the field"), N_("A, then Enter")},
    Row{N_("Buttons of a task"), N_("click"), N_("Enter, or the letter on it")},
    Row{N_("Hints"), N_("click"), N_("H")},
    Row{N_("Link in what is said"), N_("click"), N_("G")},
    Row{N_("Scroll the lesson"), N_("wheel"), N_("Ctrl + Page Up, Page Down")},
    Row{N_("Next, previous method"), N_("click"), N_("M, Shift + M")},
    Row{N_("From control to control"), "", N_("Tab, Shift + Tab")},
    Row{N_("From panel to panel"), "", N_("F6, Shift + F6")},
    Row{N_("Press it, change it"), N_("click, drag"), N_("Space or Enter, arrows")},
    Row{N_("Back to the molecule"), N_("click"), N_("Esc")},
    Row{N_("Menus"), N_("click"), N_("F10 or Alt, or Alt + {0}")},
    Row{N_("Open a file"), N_("drop it on the window"), N_("Ctrl + O")},
    Row{N_("Leave the molecule"), N_("house in the tool bar"), N_("Ctrl + H")},
};

void head(const char* text) {
  ImGui::TableNextColumn();
  WithText quiet(look().palette.quiet);
  ImGui::TextWrapped("%s", text);
}

// "F, E, V, L, H"
std::string menuLetters() {
  std::string out;
  for (int menu = 0; menu < kMenus; ++menu) out += (menu ? ", " : "") + std::string(1, menuLetter(Menu(menu)));
  return out;
}

// An empty text must not be passed to the translation.
const char* shown(const char* text) { return *text ? tr(text) : text; }

void drawMovements(const Application& app) {
  if (!ImGui::BeginTable("rows", 3,
                         ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_PadOuterX))
    return;
  ImGui::TableSetupColumn("", 0, 1.1f);
  ImGui::TableSetupColumn("Mouse", 0, 1.1f);
  ImGui::TableSetupColumn("Keyboard", 0, 1.2f);
  ImGui::TableNextRow();
  for (const char* text : {tr("Over the molecule"), tr("Mouse"), tr("Keyboard")}) head(text);
  for (const Row& row : kRows) {
    if (row.of_body && !app.scene.stage().body) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    {
      WithFont strong(Font::Strong);
      ImGui::TextWrapped("%s", tr(row.what));
    }
    ImGui::TableNextColumn();
    const char* mouse = shown(app.settings.left_handed && row.left_handed ? row.left_handed : row.mouse);
    ImGui::TextWrapped("%s", mouse);
    recordItem(std::string("controls/") + row.what, mouse);
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", trf(row.keys, menuLetters()).c_str());
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
  for (const char* text : {tr("In the program"), tr("Menu"), tr("Keyboard")}) head(text);
  for (const Action& a : allActions()) {
    if (a.shortcut.empty()) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    {
      WithFont strong(Font::Strong);
      ImGui::TextWrapped("%s", std::string(tr(a.label)).c_str());
    }
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", menuLabel(a.menu));
    ImGui::TableNextColumn();
    const std::string keys =
        a.also.empty() ? keysText(a.shortcut) : trf("{0} or {1}", keysText(a.shortcut), keysText(a.also));
    ImGui::TextWrapped("%s", keys.c_str());
    recordItem("controls/command/" + std::string(a.name), keys);
  }
  ImGui::EndTable();
}

}  // namespace

void drawControlsPage(Application& app) {
  if (!beginPage("controls", tr("Mouse and keys"), app.panels.pages.controls, 640, 700)) return;
  ImGui::BeginChild("sheet");
  drawMovements(app);
  ImGui::Dummy({0, look().px(10)});
  drawCommands();
  ImGui::EndChild();
  endPage();
}

}  // namespace moltact
