// Assembles the application from its parts; the only place that includes all rooms. Window's thread.
#pragma once

#include "app/ui/application/application.h"

namespace moltact {

/// Returns every extension (extensions/extensions.h), the handler of keys and shortcuts, and every panel
/// (panels/panels.h).
ApplicationParts applicationParts();

}  // namespace moltact
