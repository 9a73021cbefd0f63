// Lesson > Take turns: the names of a class that shares one device, and the page between two turns.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

void drawHandOver(Application& app, ClassTurns& turns) {
  bool open = true;
  if (!beginPage("hand over", tr("Next turn"), open, 460, 300)) return;
  const Look& l = look();
  const std::string name = turns.turns().current();
  {
    WithFont heading(Font::Heading);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(trf("{0}, it is your turn.", name).c_str());
    ImGui::PopTextWrapPos();
    recordItem("turn/name", name);
  }
  ImGui::Spacing();
  ImGui::TextWrapped("%s", tr("Take the device in your hand, or the mouse. The force is off until you begin, and comes "
                              "up softly."));
  if (app.lesson.session()) ImGui::TextWrapped("%s", tr("What you do is kept under your name."));
  ImGui::Dummy({0, l.px(10)});
  const float whole = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x, side = l.tx(110);
  const bool begun = button("turn/begin", tr("Begin"), ButtonLook::Primary, whole - 2 * side - 2 * gap);
  ImGui::SameLine();
  const bool absent = button("turn/absent", tr("Not here"), ButtonLook::Plain, side);
  tip(tr("Takes this name out of the round"));
  ImGui::SameLine();
  const bool end = button("turn/end", tr("End turns"), ButtonLook::Plain, side);
  if (begun || absent || end) ImGui::CloseCurrentPopup();
  endPage();
  if (begun)
    turns.start();
  else if (absent)
    turns.skip();
  else if (end)
    turns.end();
}

void drawSetUp(Application& app, ClassTurns& turns) {
  if (!beginPage("turns page", tr("Take turns at one device"), app.panels.pages.turns, 520, 560)) return;
  const Look& l = look();
  ClassTurns::Draft& draft = turns.draft;
  ImGui::TextWrapped("%s", tr("Each student works for the same time; what each does is kept under the name. Those who "
                              "wait predict."));
  ImGui::Spacing();
  {
    WithFont strong(Font::Strong);
    ImGui::TextUnformatted(tr("Names or codes, one a line, in the order of the turns"));
  }
  const float below = l.tx(150);
  inputLines("##names", draft.names, {-1, std::max(l.tx(80), ImGui::GetContentRegionAvail().y - below)});
  recordItem("turns/names", draft.names);
  slider("turns/minutes", tr("Minutes a turn"), draft.minutes, 0.5, 20.0, 0.5,
         {Dimension::Time, {decimals(1), "min"}, 60.0});
  if (!app.lesson.session()) {
    WithText warn(l.palette.warn);
    ImGui::TextWrapped("%s", tr("No lesson is open: turns are timed, but nothing is kept."));
  } else {
    WithText quiet(l.palette.quiet);
    ImGui::TextWrapped("%s", tr("The names stay on this computer, with what was done."));
  }
  const std::vector<std::string> names = Turns::namesIn(draft.names);
  const std::string label = names.empty() ? tr("Begin") : trf("Begin with {0}", elided(names.front(), l.tx(200)));
  const bool begun = button("turns/begin", label.c_str(), ButtonLook::Primary, -1.0f, !names.empty());
  if (begun) {
    app.panels.pages.turns = false;
    ImGui::CloseCurrentPopup();
  }
  endPage();
  if (begun) turns.begin(names, 60.0 * draft.minutes);
}

}  // namespace

void drawTurnsPage(Application& app) {
  ClassTurns& turns = app.extensions().turns;
  if (turns.turns().state() == Turns::State::HandOver)
    drawHandOver(app, turns);
  else
    drawSetUp(app, turns);
}

}  // namespace moltact
