// Links in a lesson's text that change the scene instead of the step: [the cleft](#view:the-cleft), [the
// ligand](<#zoom:ligand>), [closed](#state:closed). Pure functions; any thread but the haptic one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/lesson/lesson.h"

namespace moltact {

struct SceneLink {
  enum class Kind : std::uint8_t { View, Zoom, State };
  Kind kind = Kind::View;
  std::string of;  ///< the slug of a view, a selection, or a state
};

/// Parses the link; nothing for other kinds of links.
std::optional<SceneLink> sceneLink(std::string_view link);

/// The scene's view with that slug ("the-cleft"); null if there is none.
const NamedView* findView(const SceneSpec& scene, std::string_view name);

/// The share of the way to the second structure (0 to 1) for one of the scene's `states` ("open") or a percentage
/// ("40%"). Nothing for other texts.
std::optional<double> stateNamed(const SceneSpec& scene, std::string_view text);

}  // namespace moltact
