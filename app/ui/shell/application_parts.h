// The parts of the application: the only place that knows all rooms. Window's thread.
#pragma once

#include "app/ui/application/application.h"

namespace moltact {

/// Every extension (extensions/extensions.h), the keys and shortcuts, and every panel (panels/panels.h).
ApplicationParts applicationParts();

}  // namespace moltact
