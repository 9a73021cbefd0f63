// How the molecule's file is read: its model, waters, biological assembly and second molecule. Generated from the table
// of reading options.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <string>
#include <variant>

#include "app/ui/application/application.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

void drawOption(const ReadingOption& option, const Molecule& molecule, ReadOptions& reading) {
  const std::string name = "reading/" + std::string(option.name);
  if (const auto* on = std::get_if<bool ReadOptions::*>(&option.member)) {
    toggle(name.c_str(), tr(option.label), reading.**on);
  } else {
    sectionTitle(tr(option.label));
    ImGui::SetNextItemWidth(-1.0f);
    if (const auto* number = std::get_if<int ReadOptions::*>(&option.member)) {
      int& chosen = reading.**number;
      ImGui::InputInt(("##" + name).c_str(), &chosen, 1, 10);
      chosen = std::clamp(chosen, 1, option.max ? option.max(molecule) : kMaxReadNumber);
      recordItem(name, std::to_string(chosen));
    } else if (std::string& text = reading.*std::get<std::string ReadOptions::*>(option.member); option.words) {
      wordSegments(name.c_str(), option.words(), text);
    } else {
      ImGui::InputTextWithHint(("##" + name).c_str(), *option.hint ? tr(option.hint) : "", &text);
      recordItem(name, text);
    }
  }
  if (!option.note) return;
  const WithText quiet(look().palette.quiet);
  ImGui::TextWrapped("%s", option.note(molecule).c_str());
}

}  // namespace

void drawReadingPage(Application& app) {
  PanelState& panels = app.panels;
  const bool appears = panels.pages.reading && !ImGui::IsPopupOpen("reading");
  if (appears) panels.reading = app.scene.molecule().reading;
  if (!beginPage("reading", tr("Models, waters, assembly"), panels.pages.reading, 520, 560)) return;
  const TouchableModel& stage = app.scene.stage();
  bool go = false;
  if (stage) {
    const float foot = look().tx(34) + look().px(12);
    ImGui::BeginChild("options", {0, -foot});
    for (const ReadingOption& option : readingOptions()) {
      drawOption(option, *stage.molecule, panels.reading);
      ImGui::Dummy({0, look().px(6)});
    }
    ImGui::EndChild();
    ReadOptions wanted = panels.reading;
    for (const ReadingOption& option : readingOptions())
      if (std::holds_alternative<std::string ReadOptions::*>(option.member))
        readText(wanted, option, std::string(trimmed(textOf(wanted, option))));
    go = button("reading/open", tr("Open it so"), ButtonLook::Primary, -1.0f, wanted != app.scene.molecule().reading);
    if (go) panels.reading = wanted;
  }
  if (go) {
    panels.pages.reading = false;
    ImGui::CloseCurrentPopup();
  }
  endPage();
  if (go) app.openMolecule({app.scene.molecule().file, panels.reading});
}

}  // namespace moltact
