// Writes the settings to their file once they have rested for a second, and at the end. Window's thread.
#pragma once

#include "app/ui/application/extension.h"
#include "app/ui/files/settings.h"

namespace moltact {

class SettingsKeeper : public Extension {
 public:
  /// The settings are as they are in the file: from here on changes are kept.
  void atStart(Application& app) override;
  void afterPanels(Application& app) override;
  void atEnd(Application& app) override;

 private:
  Settings kept_, changing_;
  double rested_s_ = 0;
};

}  // namespace moltact
