#include "app/ui/extensions/force_faults.h"

namespace moltact {

void ForceFaults::beforeTicks() {
  const auto& field = scene_.forces().field();
  if (!field || field->faults.empty() || molecule_ == scene_.stage().molecule) return;
  molecule_ = scene_.stage().molecule;
  messages_.warning(field->faults);
}

}  // namespace moltact
