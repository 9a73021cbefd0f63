// The interface that opens files and molecules, for classes that need no more of the application. Window's thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "engine/core/units.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

class Opener {
 public:
  /// Opens a file by its kind (files/file_kinds.h), or a molecule by its name in the library. On failure, shows a
  /// message and changes nothing.
  virtual void open(const std::filesystem::path& file) = 0;
  /// Shows a molecule as a lesson's step does: without adding it to the recent files.
  virtual void showMolecule(const MoleculeKey& key) = 0;
  /// Whether something is open, so that the welcome page can be closed.
  virtual bool hasWork() const = 0;
  virtual bool loading() const = 0;

  /// Restores the camera of the scene's beginning.
  virtual void resetView() = 0;
  /// Zooms to a point without changing the direction of view; the user can undo it.
  virtual void comeCloseTo(PointA place) = 0;
  /// Restarts the scene as if its molecule had just been opened. With `before`, that point is rotated to the front and
  /// the hand begins there. With `turned`, the molecule is rotated (the screen's axes in the molecule's). The atoms
  /// `removed` (ascending) are not felt until the next call, in addition to those of the scene. If `in_hand`
  /// (ascending) is not empty, the hand holds it instead of what the scene puts into it.
  virtual void beginSceneAgain(std::optional<PointA> before = {}, const std::optional<Quat>& turned = {},
                               const std::vector<std::uint32_t>& removed = {},
                               const std::vector<std::uint32_t>& in_hand = {}) = 0;

 protected:
  ~Opener() = default;
};

}  // namespace moltact
