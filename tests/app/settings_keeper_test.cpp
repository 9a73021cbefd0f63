// An extension constructed from its parts, without an application or a window.
#include "app/ui/extensions/settings_keeper.h"

#include "app/ui/application/application_options.h"
#include "app/ui/widgets/messages.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {

TEST_CASE("the settings keeper, made without an application, writes a change once it has rested for a second") {
  const Scratch scratch;
  Settings settings;
  Messages messages;
  FrameTime time{.dt_s = 0.1};
  const ApplicationOptions options{.settings_file = scratch.folder / "settings.json"};
  SettingsKeeper keeper(settings, messages, options, time);
  keeper.atStart();
  settings.sound_volume = 0.25;
  for (int frame = 0; frame < 9; ++frame) keeper.afterPanels();
  CHECK_FALSE(std::filesystem::exists(options.settings_file));
  settings.sound_volume = 0.75;  // it rests no more
  for (int frame = 0; frame < 9; ++frame) keeper.afterPanels();
  CHECK_FALSE(std::filesystem::exists(options.settings_file));
  for (int frame = 0; frame < 3; ++frame) keeper.afterPanels();
  REQUIRE(std::filesystem::exists(options.settings_file));
  CHECK(loadSettings(options.settings_file).settings.sound_volume == 0.75);
  settings.sound_volume = 0.5;
  keeper.atEnd();
  CHECK(loadSettings(options.settings_file).settings.sound_volume == 0.5);
  CHECK(messages.all().empty());
}

}  // namespace moltact
