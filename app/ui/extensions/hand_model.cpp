#include "app/ui/extensions/hand_model.h"

#include "app/ui/widgets/messages.h"
#include "engine/platform/folders.h"

namespace moltact {

void HandModel::beforeTicks() {
  if (settings_.probe_look == look_) return;
  look_ = settings_.probe_look;
  model_ = nullptr;
  if (look_ != ProbeLook::Stylus) return;
  Expected<SolidModel> read = readGltf(assetsFolder() / "models" / (std::string(probeLookName(look_)) + ".glb"));
  if (read)
    model_ = std::make_shared<const SolidModel>(*std::move(read));
  else
    messages_.error(read.problem().text());
}

}  // namespace moltact
