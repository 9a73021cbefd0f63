#include "app/ui/extensions/settings_keeper.h"

#include "app/ui/application/application_options.h"
#include "app/ui/widgets/messages.h"

namespace moltact {
namespace {
constexpr double kSaveAfter_s = 1.0;
}

void SettingsKeeper::atStart() { kept_ = changing_ = settings_; }

void SettingsKeeper::afterPanels() {
  const std::filesystem::path& file = options_.settings_file;
  if (file.empty() || settings_ == kept_) return;
  rested_s_ = settings_ == changing_ ? rested_s_ + time_.dt_s : 0.0;
  changing_ = settings_;
  if (rested_s_ < kSaveAfter_s) return;
  if (const std::string fault = saveSettings(settings_, file, kept_); !fault.empty()) messages_.warning(fault);
  kept_ = settings_;
}

void SettingsKeeper::atEnd() {
  const std::filesystem::path& file = options_.settings_file;
  if (!file.empty() && !(settings_ == kept_)) saveSettings(settings_, file, kept_);
}

}  // namespace moltact
