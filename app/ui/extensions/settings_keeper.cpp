#include "app/ui/extensions/settings_keeper.h"

#include "app/ui/application/application.h"

namespace moltact {
namespace {
constexpr double kSaveAfter_s = 1.0;
}

void SettingsKeeper::atStart(Application& app) { kept_ = changing_ = app.settings; }

void SettingsKeeper::afterPanels(Application& app) {
  const std::filesystem::path& file = app.options().settings_file;
  if (file.empty() || app.settings == kept_) return;
  rested_s_ = app.settings == changing_ ? rested_s_ + app.dt_s() : 0.0;
  changing_ = app.settings;
  if (rested_s_ < kSaveAfter_s) return;
  if (const std::string fault = saveSettings(app.settings, file, kept_); !fault.empty()) app.messages.warning(fault);
  kept_ = app.settings;
}

void SettingsKeeper::atEnd(Application& app) {
  const std::filesystem::path& file = app.options().settings_file;
  if (!file.empty() && !(app.settings == kept_)) saveSettings(app.settings, file, kept_);
}

}  // namespace moltact
