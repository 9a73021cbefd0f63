// Right: what is felt and how: force over time, the probe, what is shown; the method and the loop behind "More".
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/panels/dark_view.h"
#include "app/ui/panels/method_chooser.h"
#include "app/ui/panels/while_locked.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/plot.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/workspace/scale.h"

namespace moltact {
namespace {

constexpr double kLargestOffered_A = 4.0;  // of the probe's slider
constexpr double kSoftest_N_per_mm = 0.05, kStiffest_N_per_mm = 2.0;

void drawPartSwitches(Application& app) {
  const WhileLocked locked(app, "show");
  for (const ViewPartInfo& part : viewParts()) {
    if (!part.haptic) continue;  // the others are in the View menu
    if (part.part == ViewPart::Facets && !feltFacets(app.scene.method())) continue;
    bool on = app.scene.shown.has(part.part);
    if (toggle(("show/" + std::string(part.name)).c_str(), part.shownLabel(), on, tr(part.sentence)))
      app.scene.shown.set(part.part, on);
  }
}

}  // namespace

void drawTouchPanel(Application& app) {
  if (app.panels.methodsInFront() || !beginPanel("touch", app.layout().touch)) return;
  if (drawnDark(app)) {
    endPanel();
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {look().px(8), look().px(10)});
  drawTouchHead(app);
  plot("plot/force", app.scene.log().force(), app.scene.log().force_N(),
       {.title = tr("Force"), .least_top = 1.0f, .shown_as = {Dimension::Force, {decimals(1), {}}}});
  ImGui::Spacing();
  {
    const WhileLocked locked(app, "probe");
    slider("probe", tr("Probe radius"), app.scene.servo_settings.probe_A, 0.0, kLargestOffered_A, 0.1,
           {Dimension::Length, {decimals(1), {}}},
           trf("The radius of the ball you touch with. {0} is a water molecule.",
               quantityText(1.4, Dimension::Length, decimals(1)))
               .c_str());
  }
  ImGui::Spacing();
  sectionTitle(tr("What the hand feels"));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {look().px(8), look().px(2)});
  drawPartSwitches(app);
  ImGui::PopStyleVar();
  ImGui::Spacing();
  disclosure("more", tr("Spring, tracker and timing"), app.panels.touch_details);
  if (app.panels.touch_details) {
    {
      const WhileLocked locked(app, "stiffness");
      slider("stiffness", tr("Stiffness"), app.scene.servo_settings.stiffness_N_per_mm, kSoftest_N_per_mm,
             kStiffest_N_per_mm, 0.05, {Dimension::Stiffness},
             tr("The spring between your hand and the surface: how hard the molecule feels."));
    }
    {
      const WhileLocked locked(app, "force");
      toggle("force", tr("Force on"), app.scene.servo_settings.force_on,
             tr("Off: contact is followed, but no force is given."));
    }
    const ServoSettings& servo = app.scene.servo_settings;
    const double energy_J = servo.force_on ? springEnergy_J(app.scene.log().latest().contact.energy_A2,
                                                            servo.stiffness_N_per_mm, servo.workspace.A_per_mm)
                                           : 0.0;
    const std::string energy = trf("Energy in the spring: {0}", quantityText(energy_J, Dimension::Energy));
    ImGui::TextUnformatted(energy.c_str());
    recordItem("energy", energy);
    ImGui::TextUnformatted(tr("Tracker"));
    drawMethodChooser(app);
    if (!app.panels.methods && !app.lesson.locks("panels") &&
        button("compare", tr("Compare the methods …"), ButtonLook::Plain, -1.0f))
      app.panels.showMethods(true);
    plot("plot/tick", app.scene.log().work(), app.scene.log().health().work_mean_us,
         {.title = tr("Time for a tick"), .least_top = 2.0f, .shown_as = {Dimension::Time, {decimals(1), "µs"}, 1e-6}});
  }
  ImGui::PopStyleVar();
  endPanel();
}

}  // namespace moltact
