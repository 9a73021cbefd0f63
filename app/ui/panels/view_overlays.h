// The overlays of the 3-D view: the state in words, the scale bar, the hint of controls. Window's thread.
#pragma once

#include <string>
#include <vector>

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

/// The part of the view that overlays may use in this frame, and what already stands in it: nothing covers anything.
struct ViewRoom {
  ViewRoom(const Rectangle& picture, const Rectangle& below_messages) : whole(picture), view(below_messages) {}

  Rectangle whole;         ///< the picture
  Rectangle view;          ///< of it what lies below the messages
  Rectangle slider = {};   ///< of a scene's two structures; empty where there is none
  float words_top = 0.0f;  ///< where the lines at the lower edge begin (unit: pixel)

  void take(const Rectangle& place) { taken_.push_back(place); }
  bool isFree(const Rectangle& place) const;

 private:
  std::vector<Rectangle> taken_;
};

void drawViewOverlays(Application& app, const Rectangle& whole_view);

/// What safety does to the force, in words; empty where it does nothing that is to be told over the view.
std::string limitText(const Application& app);

/// The slider between a scene's two structures. Returns where it stands; empty where there is none.
Rectangle drawStateSlider(Application& app, const Rectangle& view);

/// How deep the hand is pressed, seen from the side: at the view's right edge, ending at `bottom_px`. It is left out where
/// that place is taken.
void drawDepthGauge(Application& app, ViewRoom& room, float bottom_px);

/// The legend of the atoms' colours, where there is more than one or they tell more than the elements.
/// Where it would take more than a third of the view's width or half of its height it is closed at first. It stands
/// below the slider where both would meet, and ends above the lines at the lower edge.
void drawColourLegend(Application& app, ViewRoom& room);

}  // namespace moltact
