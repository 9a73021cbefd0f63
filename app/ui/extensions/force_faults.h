// Says once for each scene with forces between atoms what is wrong with the parameters of its atoms. Window's thread.
#pragma once

#include <string>

#include "app/ui/application/extension.h"
#include "app/ui/scene/haptic_session.h"
#include "app/ui/widgets/messages.h"

namespace moltact {

class ForceFaults final : public Extension {
 public:
  ForceFaults(const HapticSession& scene, Messages& messages) : scene_(scene), messages_(messages) {}

  void beforeTicks() override;

 private:
  const HapticSession& scene_;
  Messages& messages_;
  std::shared_ptr<const Molecule> molecule_;  // the last one in whose forces the faults were reported
};

}  // namespace moltact
