// Writes the settings to their file one second after the last change, and at the end. Window's thread.
#pragma once

#include "app/ui/application/extension.h"
#include "app/ui/files/settings.h"

namespace moltact {

struct ApplicationOptions;
class Messages;

class SettingsKeeper : public Extension {
 public:
  SettingsKeeper(Settings& settings, Messages& messages, const ApplicationOptions& options, const FrameTime& time)
      : settings_(settings), messages_(messages), options_(options), time_(time) {}

  /// The settings equal the file's; later changes are stored.
  void atStart() override;
  void afterPanels() override;
  void atEnd() override;

 private:
  Settings& settings_;
  Messages& messages_;
  const ApplicationOptions& options_;
  const FrameTime& time_;
  Settings kept_, changing_;
  double rested_s_ = 0;
};

}  // namespace moltact
