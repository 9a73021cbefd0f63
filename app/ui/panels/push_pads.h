// Two pads on the view's right edge while fingers are used. They change the push of another finger, as the wheel does
// for a mouse. app/ui/widgets/fingers.h implements them. Window's thread.
#pragma once

#include "app/ui/widgets/layout.h"

namespace moltact {

class Application;

/// The rectangle of the pads; empty if they are hidden.
Rectangle pushPadsPlace(const Application& app, const Rectangle& view);
void drawPushPads(Application& app, const Rectangle& view);

inline constexpr const char* kHarderPad = "view/harder";  ///< names in the widget map
inline constexpr const char* kLighterPad = "view/lighter";

}  // namespace moltact
