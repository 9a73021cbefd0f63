// The atoms of a held body and of the molecule that bear a contact's force, with their shares of it. Pure functions.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "engine/haptics/felt_force.h"
#include "engine/render/view_scene.h"

namespace moltact {

struct LoadedAtoms {
  std::vector<LoadedAtom> body;   ///< stopped atoms of the body, by index within the body, ascending
  std::vector<LoadedAtom> scene;  ///< atoms of the molecule that stop them, ascending
  std::size_t count = 0;          ///< number of contacts; 0: none, or not known

  friend bool operator==(const LoadedAtoms&, const LoadedAtoms&) = default;
};

/// Sums the reactions to a body (Interaction::reactions) by atom; the shares are those of the sum of their sizes.
/// Reactions to a probe do not count.
inline LoadedAtoms loadedAtoms(std::span<const AtomForce> reactions) {
  LoadedAtoms out;
  std::map<std::uint32_t, double> body, scene;
  double sum = 0.0;
  for (const AtomForce& one : reactions) {
    const double size = glm::length(one.force_N);
    if (one.atom < 0 || one.body_sphere < 0 || !(size > 0.0)) continue;
    body[std::uint32_t(one.body_sphere)] += size;
    scene[std::uint32_t(one.atom)] += size;
    sum += size;
    ++out.count;
  }
  for (const auto& [atom, size] : body) out.body.push_back({atom, size / sum});
  for (const auto& [atom, size] : scene) out.scene.push_back({atom, size / sum});
  return out;
}

}  // namespace moltact
