// On the view's right edge, while fingers lead: two pads that make the push of another finger harder and lighter, as the wheel
// does for a mouse. What they do is in app/ui/widgets/fingers.h. Window's thread.
#pragma once

#include "app/ui/widgets/layout.h"

namespace moltact {

class Application;

/// Where they stand; empty where they are not shown.
Rectangle pushPadsPlace(const Application& app, const Rectangle& view);
void drawPushPads(Application& app, const Rectangle& view);

inline constexpr const char* kHarderPad = "view/harder";  ///< as the widgets' map names them
inline constexpr const char* kLighterPad = "view/lighter";

}  // namespace moltact
