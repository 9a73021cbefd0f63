// A tab beside the view, on request: switches the haptic method during touch and shows its time and error at
// once.
#include "app/ui/application/application.h"
#include "app/ui/panels/method_charts.h"
#include "app/ui/panels/method_chooser.h"
#include "app/ui/panels/while_locked.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/plot.h"
#include "app/ui/widgets/theme.h"
#include "engine/language/catalogue.h"

namespace moltact {

void drawMethodsTab(Application& app) {
  drawMethodChooser(app);
  if (feltFacets(app.scene.touch().method)) {
    const WhileLocked locked(app, "show");
    bool on = app.scene.look.shown.has(ViewPart::Facets);
    if (toggle("show/facets", tr("Draw the triangles"), on,
               tr("The triangles that the method feels, round the probe.")))
      app.scene.look.shown.set(ViewPart::Facets, on);
  }
  plot("plot/force", app.scene.log().force(), app.scene.log().shownForce_N(),
       {.title = tr("Force"), .min_top = 1.0f, .height = 50.0f, .shown_as = {Dimension::Force, {decimals(1), {}}}});
  plot("plot/turn", app.scene.watch().turns(), app.scene.watch().greatestTurn_deg(),
       {.title = tr("Largest turn in a tick"),
        .min_top = 2.0f,
        .height = 50.0f,
        .shown_as = {Dimension::Angle, {decimals(1), {}}}});
  const MethodRecord* record = app.scene.watch().find(app.scene.touch().method);
  tickHistogram("plot/times", record, 56.0f);
  speedAccuracyChart("plot/tradeoff", app.scene.watch(), app.scene.touch().method, 140.0f);
}

}  // namespace moltact
