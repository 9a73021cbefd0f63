#include "app/ui/extensions/extensions.h"

#include "app/ui/application/application.h"

namespace moltact {
namespace {
constexpr float kPlayback = 88.0f, kTurn = 56.0f, kTurnAndPrediction = 136.0f;
}

Extensions::Extensions(Application& app)
    : settings_keeper(app.settings, app.messages, app.options(), app.time()),
      lesson_watch(app, app.scene, app.lesson, app.messages, app.options(), app.time()),
      lesson_locks(app.scene, app.lesson, app.panels),
      movers({app.scene, app.lesson, app.messages, app.options()}),
      recorder(movers, app, app.scene, app.lesson, app.messages, app.panels, app.options(), app.time()),
      turns(recorder, app.scene, app.lesson, app.panels, app.time()),
      playback(recorder, movers, app, app.scene, app.lesson, app.settings, app.messages, app.panels, app.options(),
               app.time()),
      name_asker(recorder, turns, playback, app, app.lesson, app.panels, app.options()),
      scene_change(app.scene, app.settings, app.picture(), app.time()),
      history(scene_change, app.scene),
      lesson_list(recorder, app, app.lesson, app.settings, app.messages, app.panels, app.options()),
      card_pictures(app.settings, app.options()),
      lesson_pictures(app.options(), app.time()),
      task_stager(app, app.scene, app.lesson, app.panels),
      reveal_policy(task_stager, app.scene, app.lesson, app.settings, app.picture(), app.time()),
      hand_model(app.settings, app.messages),
      state_text(reveal_policy, app.scene, app.lesson, app.panels, app.time()),
      touch_sound(reveal_policy, playback, app.scene, app.settings, app.messages, app.panels, app.options(),
                  app.time()),
      measuring(app.scene),
      own_look(app.scene),
      held_poses(app, app.scene, app.lesson, app.time()),
      surface_scan(app.scene, app.lesson, app.messages, app.time()),
      potential_colours(app.scene),
      force_faults(app.scene, app.messages),
      touch_paint(reveal_policy, app.scene, app.lesson),
      device(task_stager, app.scene, app.settings, app.messages, app.panels, app.layout(), app.options(), app.time()),
      hand_recorder(movers, recorder, device, app, app.scene, app.messages, app.panels, app.file_dialog,
                    app.options()) {}

float Extensions::stripHeight() const {
  if (playback.on()) return kPlayback;
  if (!turns.on()) return 0.0f;
  return turns.turns().waiting().empty() ? kTurn : kTurnAndPrediction;
}

// The application knows only the base class. Every program constructs it with this class (shell/application_parts.h).
Extensions& Application::extensions() { return static_cast<Extensions&>(*extensions_); }
const Extensions& Application::extensions() const { return static_cast<const Extensions&>(*extensions_); }

}  // namespace moltact
