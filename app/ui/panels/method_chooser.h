// The choice of the haptic method under the hand: a family, and within it how finely it works. Window's thread.
#pragma once

#include <memory>
#include <string_view>

namespace moltact {

class Application;
class SphereMesh;

/// Segments for the family, its grades and their variants, each only where there is a choice, and a plain sentence.
/// Recorded as "method/<family>", "grade/<grade>", "variant/<variant>" and "method/sentence".
void drawMethodChooser(Application& app);

/// "Touch | Methods" where the methods are compared, else the panel's title.
void drawTouchHead(Application& app);

/// The triangles that a method feels for a ball of radius 1; null for a method without.
std::shared_ptr<const SphereMesh> feltFacets(std::string_view method);

}  // namespace moltact
