// The touch tab beside the view: the force over time, the probe, the visible parts; method and loop under "More".
#include <algorithm>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/energy_plot.h"
#include "app/ui/panels/method_chooser.h"
#include "app/ui/panels/while_locked.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/plot.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/haptics/interactions.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/workspace/scale.h"

namespace moltact {
namespace {

// Draws the controls of the scene's touch: the main ones (`first`), or those among the details.
void drawTouchControls(Application& app, bool first) {
  TouchSetup touch = app.scene.touch();
  for (const TouchProperty& p : touchProperties()) {
    const TouchControl& c = p.control;
    if (c.title.empty() || c.first != first || !isChoice(p)) continue;
    if (c.shown && !c.shown(touch, app.scene.stage().body != nullptr)) continue;
    const WhileLocked locked(app, p.key);
    const std::string name(p.key), title(tr(c.title));
    const auto tip = [&](const std::string& usual) { return c.tip.empty() ? std::string() : trf(c.tip.data(), usual); };
    if (const auto* number = std::get_if<double TouchSetup::*>(&p.member)) {
      const Digits digits = c.decimals < 0 ? Digits{} : decimals(c.decimals);
      slider(name.c_str(), title.c_str(), touch.**number, c.range.min, c.range.max, c.step, {p.dimension, {digits, {}}},
             tip(quantityText(TouchSetup().**number, p.dimension, digits)).c_str());
      if (const std::string note = c.note ? c.note(touch) : std::string(); !note.empty()) {
        const WithText quiet(look().palette.quiet);
        drawWrapped((name + "/note").c_str(), note);
      }
    } else if (const auto* on = std::get_if<bool TouchSetup::*>(&p.member)) {
      toggle(name.c_str(), title.c_str(), touch.**on, tip({}).c_str());
    } else {
      std::vector<OfferedWord> words = p.words();
      if (p.member == TouchMember(&TouchSetup::interaction))
        std::erase_if(words, [&](const OfferedWord& w) {
          return findInteractionKind(w.name)->holds_body != (app.scene.stage().body != nullptr);
        });
      if (words.size() < 2) continue;
      ImGui::TextUnformatted(title.c_str());
      wordSegments(name.c_str(), words, touch.*std::get<std::string TouchSetup::*>(p.member));
    }
  }
  if (!(touch == app.scene.touch())) app.scene.setTouch(touch);
}

void drawPartSwitches(Application& app) {
  const WhileLocked locked(app, "show");
  for (const ViewPartInfo& part : viewParts()) {
    if (!part.haptic) continue;  // the others are in the View menu
    if (part.part == ViewPart::Facets && !feltFacets(app.scene.touch().method)) continue;
    bool on = app.scene.look.shown.has(part.part);
    if (part.expert && !on && !app.settings.expert) continue;
    if (toggle(("show/" + std::string(part.name)).c_str(), part.shownLabel(), on, tr(part.sentence)))
      app.scene.look.shown.set(part.part, on);
  }
}

}  // namespace

void drawTouchTab(Application& app) {
  plot("plot/force", app.scene.log().force(), app.scene.log().shownForce_N(),
       {.title = tr("Force"), .min_top = 1.0f, .shown_as = {Dimension::Force, {decimals(1), {}}}});
  drawEnergyPlot(app);
  ImGui::Spacing();
  drawTouchControls(app, true);
  ImGui::Spacing();
  sectionTitle(tr("What the hand feels"));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {look().px(8), look().px(2)});
  drawPartSwitches(app);
  ImGui::PopStyleVar();
  ImGui::Spacing();
  disclosure("more", tr("Spring, friction and tracker"), app.panels.touch_details);
  if (app.panels.touch_details) {
    drawTouchControls(app, false);
    const ServoSettings& servo = app.scene.servo_settings;
    const ServoSample& now = app.scene.log().latest();
    const double A_per_mm = servo.workspace.A_per_mm;
    const double energy_J =
        servo.force_on ? springEnergy_J(now.contact.energy_A2, now.spring_N_per_A * A_per_mm, A_per_mm) : 0.0;
    const double field_J =
        servo.force_on && now.field ? 1e-3 * now.field_share * inDevice(*now.field, servo.workspace).energy_N_mm : 0.0;
    const std::string energy =
        now.field ? trf("Energy of spring and field: {0}", quantityText(energy_J + field_J, Dimension::Energy))
                  : trf("Energy in the spring: {0}", quantityText(energy_J, Dimension::Energy));
    drawWrapped("energy", energy);
    ImGui::TextUnformatted(tr("Tracker"));
    drawMethodChooser(app);
    if (!app.panels.tabs.has("methods") && !app.lesson.locks("panels") &&
        button("compare", tr("Compare the methods …"), ButtonLook::Plain, -1.0f))
      app.panels.tabs.open("methods");
    if (!app.extensions().reveal_policy.all() && (app.settings.expert || app.panels.tabs.has("methods")))
      plot("plot/tick", app.scene.log().work(), app.scene.log().health().work_mean_us,
           {.title = tr("Time for a tick"), .min_top = 2.0f, .shown_as = {Dimension::Time, {decimals(1), "µs"}, 1e-6}});
  }
}

}  // namespace moltact
