// How the molecule's file is read: which model, with its waters, as which biological assembly, beside which other molecule. From the table of readings.
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

const char* labelOf(const ReadingOption& option) {
  if (option.name == "model") return tr("Model");
  if (option.name == "waters") return tr("Water molecules of the file");
  if (option.name == "beside") return tr("Molecule beside it");
  return tr("Biological assembly");
}

void drawOption(const ReadingOption& option, const Molecule& molecule, ReadOptions& reading) {
  const std::string name = "reading/" + std::string(option.name);
  if (const auto* on = std::get_if<bool ReadOptions::*>(&option.member)) {
    toggle(name.c_str(), labelOf(option), reading.**on);
    return;
  }
  sectionTitle(labelOf(option));
  ImGui::SetNextItemWidth(-1.0f);
  if (const auto* number = std::get_if<int ReadOptions::*>(&option.member)) {
    int& chosen = reading.**number;
    const int most = std::max(1, int(molecule.models_in_file));
    ImGui::InputInt(("##" + name).c_str(), &chosen, 1, 10);
    chosen = std::clamp(chosen, 1, most);
    recordItem(name, std::to_string(chosen));
    const WithText quiet(look().palette.quiet);
    ImGui::TextWrapped("%s", trnf("The file has {0} model.", "The file has {0} models.", most, most).c_str());
    return;
  }
  std::string& text = reading.*std::get<std::string ReadOptions::*>(option.member);
  const bool beside = option.name == "beside";
  ImGui::InputTextWithHint(
      ("##" + name).c_str(),
      beside ? tr("none: the molecule alone") : tr("none: the coordinates as they stand in the file"), &text);
  recordItem(name, text);
  const WithText quiet(look().palette.quiet);
  ImGui::TextWrapped(
      "%s", beside ? tr("For comparison: one of the library by its name, or a file in the same folder.")
                   : tr("Its name in the file, mostly 1. Copies of the chains are made as they are in the cell."));
}

}  // namespace

void drawReadingPage(Application& app) {
  PanelState& panels = app.panels;
  const bool appears = panels.reading_page && !ImGui::IsPopupOpen("reading");
  if (appears) panels.reading = app.scene.molecule().reading;
  if (!beginPage("reading", tr("Models, waters, assembly"), panels.reading_page, 520, 560)) return;
  const Stage& stage = app.scene.stage();
  bool goes = false;
  if (stage) {
    const float foot = look().tx(34) + look().px(12);
    ImGui::BeginChild("options", {0, -foot});
    for (const ReadingOption& option : readingOptions()) {
      drawOption(option, *stage.molecule, panels.reading);
      ImGui::Dummy({0, look().px(6)});
    }
    ImGui::EndChild();
    ReadOptions wanted = panels.reading;
    for (std::string* text : {&wanted.assembly, &wanted.beside})
      *text = *text == "none" ? std::string() : std::string(trimmed(*text));
    goes = button("reading/open", tr("Open it so"), ButtonLook::Primary, -1.0f, wanted != app.scene.molecule().reading);
    if (goes) panels.reading = wanted;
  }
  if (goes) {
    panels.reading_page = false;
    ImGui::CloseCurrentPopup();
  }
  endPage();
  if (goes) app.openMolecule({app.scene.molecule().file, panels.reading});
}

}  // namespace moltact
