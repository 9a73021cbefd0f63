// The choice of the haptic method under the hand: a family, and within it how finely it works. Window's thread.
#pragma once

namespace moltact {

class Application;

/// Segments for the family, its grades and their variants, each only where there is a choice, and a plain sentence.
/// Recorded as "method/<family>", "grade/<grade>", "variant/<variant>" and "method/sentence".
void drawMethodChooser(Application& app);

/// "Touch | Methods" where the methods are compared, else the panel's title.
void drawTouchHead(Application& app);

}  // namespace moltact
