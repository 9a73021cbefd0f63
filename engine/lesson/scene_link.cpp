#include "engine/lesson/scene_link.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/lesson/quantity.h"
#include "engine/lesson/reader.h"

namespace moltact {

std::optional<SceneLink> sceneLink(std::string_view link) {
  using Kind = SceneLink::Kind;
  for (const auto& [start, kind] :
       std::array{std::pair{std::string_view("#view:"), Kind::View}, std::pair{std::string_view("#zoom:"), Kind::Zoom},
                  std::pair{std::string_view("#state:"), Kind::State}})
    if (link.starts_with(start)) return SceneLink{kind, std::string(stripped(link.substr(start.size())))};
  return std::nullopt;
}

const NamedView* findView(const SceneSpec& scene, std::string_view name) {
  const auto at =
      std::find_if(scene.views.begin(), scene.views.end(), [&](const NamedView& v) { return slug(v.name) == name; });
  return at == scene.views.end() ? nullptr : &*at;
}

std::optional<double> stateNamed(const SceneSpec& scene, std::string_view text) {
  for (std::size_t k = 0; k < scene.then.states.size(); ++k)
    if (text == scene.then.states[k] || text == slug(scene.then.states[k])) return double(k);
  if (!text.ends_with('%')) return std::nullopt;
  const auto percent = parseNumber(stripped(text.substr(0, text.size() - 1)));
  if (!percent || *percent < 0.0 || *percent > 100.0) return std::nullopt;
  return *percent / 100.0;
}

}  // namespace moltact
