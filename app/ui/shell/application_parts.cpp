#include "app/ui/shell/application_parts.h"

#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/actions.h"
#include "app/ui/panels/panels.h"

namespace moltact {

ApplicationParts applicationParts() {
  return {std::make_unique<Extensions>(), [](Application& app) { runKeys(app); },
          [](Application& app) {
            for (const Panel& panel : allPanels()) panel.draw(app);
          }};
}

}  // namespace moltact
