// The overlays of the 3-D view: the state in words, the scale bar, the hint of controls. Window's thread.
#pragma once

#include <string>

#include "app/ui/widgets/layout.h"
#include "engine/render/view_scene.h"

namespace moltact {

class Application;

/// How long the force arrow is on the screen (unit: pixel at 96 dpi for 1 N): as long for a protein as for one atom,
/// because what the hand gives does not depend on the zoom.
inline constexpr float kArrow_px_per_N = 70.0f;

/// The scene that the 3-D view shows now.
ViewScene seenScene(const Application& app);

/// Names, arrows and measures of the scene that is shown.
void drawViewLabels(Application& app, const ViewScene& scene, const Rectangle& view);

/// While a person measures: what was measured last, else how it is done; empty while nobody does.
std::string measuringText(const Application& app);

void drawViewOverlays(Application& app, const Rectangle& view);

/// The slider between a scene's two structures. Returns where it stands; empty where there is none.
Rectangle drawStateSlider(Application& app, const Rectangle& view);

/// How deep the hand is pressed, seen from the side.
void drawDepthGauge(Application& app, const Rectangle& view);

/// The legend of the atoms' colours, where there is more than one or they tell more than the elements.
/// Where it would take more than a third of the view's width or half of its height it is closed at first. It stands
/// below `kept_free`, where both would meet.
void drawColourLegend(Application& app, const Rectangle& view, const Rectangle& kept_free);

}  // namespace moltact
