// The model that stands for the hand in the view, as the person chose it: read when it is first wanted. Window's
// thread.
#pragma once

#include <memory>

#include "app/ui/application/extension.h"
#include "app/ui/files/settings.h"
#include "engine/gltf/gltf_file.h"

namespace moltact {

class Messages;

class HandModel : public Extension {
 public:
  HandModel(const Settings& settings, Messages& messages) : settings_(settings), messages_(messages) {}

  /// Reads another model where another was chosen; one that cannot be read is reported once, and no model is shown.
  void beforeTicks() override;

  /// Null where the probe alone is shown.
  const std::shared_ptr<const SolidModel>& model() const { return model_; }

 private:
  const Settings& settings_;
  Messages& messages_;
  ProbeLook look_ = ProbeLook::Water;
  std::shared_ptr<const SolidModel> model_;
};

}  // namespace moltact
