#include "app/ui/shell/application_parts.h"

#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/actions.h"
#include "app/ui/panels/panels.h"

namespace moltact {

ApplicationParts applicationParts() {
  return {[](Application& app) -> std::unique_ptr<ExtensionSet> { return std::make_unique<Extensions>(app); },
          [](Application& app) { runKeys(app); },
          [](Application& app) {
            for (const Panel& panel : allPanels()) panel.draw(app);
          }};
}

}  // namespace moltact
