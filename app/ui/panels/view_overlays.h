// The overlays of the 3-D view: the contact in words, the scale bar, the hint of controls. Window's thread.
#pragma once

#include <string>
#include <vector>

#include "app/ui/widgets/layout.h"
#include "engine/render/view_scene.h"

namespace moltact {

class Application;

/// The length of the force arrow on the screen (unit: pixel at 96 dpi per newton). It does not depend on the zoom or
/// the molecule's size, as the force does not either.
inline constexpr float kArrow_px_per_N = 70.0f;

/// Whether the names of atoms give no answer away: there is no lesson, or everything in the step is done.
bool mayNameAtoms(const Application& app);

/// The scene that the 3-D view shows now.
ViewScene seenScene(const Application& app);

/// Draws names, arrows and measures of the scene.
void drawViewLabels(Application& app, const ViewScene& scene, const Rectangle& view);

/// While the user measures: the last measurement, or instructions before the first. Empty otherwise.
std::string measuringText(const Application& app);

/// The room for overlays in this frame and the places that are taken, so that overlays do not overlap.
struct ViewRoom {
  ViewRoom(const Rectangle& picture, const Rectangle& below_messages) : whole(picture), view(below_messages) {}

  Rectangle whole;         ///< the picture
  Rectangle view;          ///< its part below the messages
  Rectangle slider = {};   ///< the slider of a scene's two structures; empty if there is none
  float words_top = 0.0f;  ///< top of the lines at the lower edge (unit: pixel)

  void take(const Rectangle& place) { taken_.push_back(place); }
  bool isFree(const Rectangle& place) const;

 private:
  std::vector<Rectangle> taken_;
};

void drawViewOverlays(Application& app, const Rectangle& whole_view);

/// Describes in words how the safety stage limits the force; empty if there is nothing to report over the view.
std::string limitText(const Application& app);

/// Draws the slider between a scene's two structures, or the bar of a trajectory. Returns its rectangle; empty if there is none.
Rectangle drawStateSlider(Application& app, const Rectangle& view);
Rectangle drawTrajectoryBar(Application& app, const Rectangle& view);

/// Draws the depth of the hand seen from the side, at the view's right edge, ending at `bottom_px`. Draws nothing if
/// that place is taken.
void drawDepthGauge(Application& app, ViewRoom& room, float bottom_px);
/// The same for the energy between atoms, left of the depth.
void drawEnergyGauge(Application& app, ViewRoom& room, float bottom_px);

/// Draws the height picture of the scanning tip with its buttons, if the scene is scanned, at the view's upper right. Draws
/// nothing if that place is taken.
void drawScanCard(Application& app, ViewRoom& room);

/// Draws the legend of the atoms' colours if there is more than one colour, or if the colours do not only stand for
/// elements. A legend larger than a third of the view's width or half of its height is closed at first. It is below the
/// slider where both would overlap, and ends above the lines at the lower edge.
void drawColourLegend(Application& app, ViewRoom& room);

}  // namespace moltact
