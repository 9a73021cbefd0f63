// The chosen model of the hand in the view, read when it is first needed. Window's thread.
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

  /// Reads the model after a change of the choice. A model that cannot be read is reported once and not shown.
  void beforeTicks() override;

  /// Null if only the probe is shown.
  const std::shared_ptr<const SolidModel>& model() const { return model_; }

 private:
  const Settings& settings_;
  Messages& messages_;
  ProbeLook look_ = ProbeLook::Water;
  std::shared_ptr<const SolidModel> model_;
};

}  // namespace moltact
