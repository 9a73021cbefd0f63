// At the top of the view while a trajectory moves the atoms: play, the frames as a slider, the present frame.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/played_trajectory.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/panels/while_locked.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {

Rectangle drawTrajectoryBar(Application& app, const Rectangle& view) {
  PlayedTrajectory& trajectory = app.extensions().movers.get<PlayedTrajectory>();
  // During playback, the recording moves the atoms.
  if (!trajectory.ready() || app.extensions().playback.on()) return {};
  const Look& l = look();
  // The button that resets the view is in the corner beside it.
  const float room = view.size().x - l.px(120), pad = l.px(8), gap = l.px(8), high = l.tx(30);
  if (room < l.tx(200)) return {};
  const std::string present =
      trf("{0} of {1}", int(std::lround(std::min(trajectory.at(), double(trajectory.last()))) + 1),
          std::to_string(trajectory.last() + 1) + (trajectory.complete() ? "" : "+"));
  const bool running = trajectory.running();
  const char* const label = running ? tr("Pause") : tr("Play");
  const float play = std::max(ImGui::CalcTextSize(tr("Pause")).x, ImGui::CalcTextSize(tr("Play")).x) + l.px(28),
              words = std::max(ImGui::CalcTextSize(present.c_str()).x, l.tx(64)),
              track = std::min(l.tx(240), room - play - words - 2 * (gap + pad)),
              width = play + words + track + 2 * (gap + pad);
  const ImVec2 low{std::round(0.5f * (view.low.x + view.high.x - width)), view.low.y + l.px(10)};
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + high + 2 * pad}, faded(l.palette.panel, 0.9f),
                                            l.px(8));
  const WhileLocked locked(app, "trajectory");
  ImGui::SetCursorScreenPos({low.x + pad, low.y + pad});
  if (button("trajectory/play", label, ButtonLook::Plain, play)) trajectory.run(!running);
  ImGui::SetCursorScreenPos({low.x + pad + play + gap, low.y + pad + 0.5f * (high - ImGui::GetFrameHeight())});
  ImGui::SetNextItemWidth(track);
  float frame = float(std::min(trajectory.at(), double(trajectory.last())));
  if (ImGui::SliderFloat("##frames", &frame, float(trajectory.first()), float(trajectory.last()), "",
                         ImGuiSliderFlags_AlwaysClamp))
    trajectory.goTo(std::round(double(frame)));
  tip(tr("Move the atoms to a frame of the trajectory"));
  recordItem("trajectory/frames", present);
  const float line = ImGui::GetTextLineHeight();
  ImGui::SetCursorScreenPos({low.x + pad + play + gap + track + gap, low.y + pad + 0.5f * (high - line)});
  ImGui::TextUnformatted(present.c_str());
  recordItem("trajectory/frame", present);
  return {{low.x, low.y}, {low.x + width, low.y + high + 2 * pad}};
}

}  // namespace moltact
