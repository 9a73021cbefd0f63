// The part of the tab Motion about a trajectory.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/played_trajectory.h"
#include "app/ui/panels/motion_sections.h"
#include "app/ui/panels/while_locked.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/plot.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

void drawRmsd(PlayedTrajectory& trajectory, const TrajectorySurvey& survey) {
  seriesPlot("trajectory/rmsd", survey.rmsd_A,
             {.title = tr("Distance from the structure (RMSD)"),
              .across = tr("frame"),
              .up = "Å",
              .first = double(trajectory.first() + 1),
              .step = double(survey.every),
              .at = std::min(trajectory.at(), double(trajectory.last())) + 1.0});
}

}  // namespace

bool drawPlayedTrajectorySection(Application& app) {
  PlayedTrajectory& trajectory = app.extensions().movers.get<PlayedTrajectory>();
  if (!trajectory.ready()) return false;
  sectionTitle(tr("Trajectory"));
  const std::string frames = trnf("{0} frame", "{0} frames", trajectory.frames(), trajectory.frames());
  drawWrapped("trajectory/file", trf("{0}: {1}, {2}", trajectory.file().filename().string(), trajectory.format(),
                                     trajectory.complete() ? frames : trf("{0} so far", frames)));
  if (const auto time = trajectory.time_ps())
    drawWrapped("trajectory/time", trf("Simulated time: {0} ps", numberText(*time, decimals(2))));
  const WhileLocked locked(app, "trajectory");
  double speed = trajectory.framesPerSecond();
  if (slider("trajectory/speed", tr("Speed (frames per second)"), speed, PlayedTrajectory::kSlowest_per_s,
             PlayedTrajectory::kFastest_per_s, 0.5, {Dimension::None, {decimals(1), {}}}))
    trajectory.setFramesPerSecond(speed);
  double smoothing = double(trajectory.smoothing());
  if (slider("trajectory/smoothing", tr("Smoothing (frames)"), smoothing, 0.0, double(PlayedTrajectory::kMaxSmoothing),
             1.0, {Dimension::None, {decimals(0), {}}},
             tr("Each frame becomes the mean of so many frames before it, itself, and as many after it.")))
    trajectory.setSmoothing(std::size_t(std::lround(smoothing)));
  ImGui::Spacing();
  static const std::array<std::string, 3> kEnds{N_("Stop"), N_("Return"), N_("Repeat")};
  auto end = std::size_t(trajectory.at_end);
  drawWrapped("trajectory/end_title", tr("At the last frame"));
  if (segments("trajectory/end", kEnds, end)) trajectory.at_end = PlayedTrajectory::AtEnd(end);
  ImGui::Spacing();
  if (const TrajectorySurvey* survey = trajectory.survey(); survey && survey->rmsd_A.size() > 1)
    drawRmsd(trajectory, *survey);
  else
    drawWrapped("trajectory/survey", tr("The frames are being compared with the structure."));
  if (!app.lesson.session() && button("trajectory/close", tr("Close the trajectory"))) trajectory.close();
  return true;
}

}  // namespace moltact
