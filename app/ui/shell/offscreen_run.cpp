#include "app/ui/shell/offscreen_run.h"

#include <fstream>
#include <sstream>

#include "app/ui/extensions/extensions.h"
#include "app/ui/shell/scripted_user.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

int fail(const Problem& problem) {
  err() << "moltact: " << problem.text() << '\n';
  return 1;
}

}  // namespace

int runOffscreen(const OffscreenOptions& options) {
  ScriptedUser::Options wanted;
  wanted.width = options.width;
  wanted.height = options.height;
  wanted.content_scale = options.content_scale;
  wanted.draws = options.frame_stats ? ScriptedUser::Draws::All : ScriptedUser::Draws::LastInRow;
  wanted.application.language = options.language;
  wanted.application.device = options.device;
  wanted.application.simulation = options.simulation;
  wanted.application.attempts_folder = options.attempts;
  Expected<std::unique_ptr<ScriptedUser>> made = ScriptedUser::create(std::move(wanted));
  if (!made) return fail(made.problem());
  ScriptedUser& user = **made;
  if (!options.state_text.empty())
    if (const auto problem = user.app().extensions().state_text.writeTo(options.state_text)) return fail(*problem);
  if (options.file.empty())
    user.app().panels.pages.welcome = true;
  else
    user.app().open(options.file);
  constexpr int kSettle_frames = 20;  // the hand reaches its place and the picture is smoothed
  user.frames(kSettle_frames);
  user.stats() = FrameStats();
  if (!options.script.empty()) {
    std::ifstream in(options.script);
    std::stringstream text;
    text << in.rdbuf();
    if (!in) return fail({options.script.string(), 0, 0, "the script cannot be read", "check its name"});
    if (const std::optional<Problem> problem = user.run(text.str(), options.script.string())) return fail(*problem);
  }
  if (options.frame_stats) out() << user.stats().json() << '\n';
  if (!options.screenshot.empty())
    if (const std::optional<Problem> problem = writePng(options.screenshot, user.picture())) return fail(*problem);
  return 0;
}

}  // namespace moltact
