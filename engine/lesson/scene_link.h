// Links in a lesson's text that lead to no other step but change what the scene shows: [the cleft](#view:the-cleft),
// [the ligand](<#zoom:ligand>), [closed](#state:closed). Pure functions; any thread but the haptic one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/lesson/lesson.h"

namespace moltact {

struct SceneLink {
  enum class Kind : std::uint8_t { View, Zoom, State };
  Kind kind = Kind::View;
  std::string of;  ///< the view's name as links write it, a selection, or a state
};

/// The link taken apart; nothing where it is another kind of link.
std::optional<SceneLink> sceneLink(std::string_view link);

/// The scene's view of that name, as links write it ("the-cleft"); null where it has none.
const NamedView* findView(const SceneSpec& scene, std::string_view name);

/// Which share of the way to its second structure a scene means by "open" (one of its `states`) or "40%" (0 to 1);
/// nothing where it means none.
std::optional<double> stateNamed(const SceneSpec& scene, std::string_view text);

}  // namespace moltact
