// The choice of the haptic method: a family, and within it the fineness. Window's thread.
#pragma once

namespace moltact {

class Application;

/// Draws segments for the family, its grades and their variants, each only if there is a choice, and a plain sentence.
/// Recorded as "method/<family>", "grade/<grade>", "variant/<variant>" and "method/sentence".
void drawMethodChooser(Application& app);

}  // namespace moltact
