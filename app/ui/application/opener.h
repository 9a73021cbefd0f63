// What opens files and molecules, for those who need no more of the application. Window's thread.
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
  /// Opens a file by its kind (files/file_kinds.h), or a molecule by its name in the library. A file that cannot be
  /// opened gives a message and changes nothing.
  virtual void open(const std::filesystem::path& file) = 0;
  /// Puts a molecule on the stage as a lesson's step does: it is not among the files opened last.
  virtual void showMolecule(const MoleculeKey& key) = 0;
  /// Something has been opened that the welcome page can be left for.
  virtual bool hasWork() const = 0;
  virtual bool loading() const = 0;

  /// The camera as it was when the scene was opened.
  virtual void resetView() = 0;
  /// Brings the camera close to a place, from the side from which it looks; a person can undo it.
  virtual void comeCloseTo(PointA place) = 0;
  /// The scene as if its molecule had just been opened; `before` a place, it is turned to the front and the hand begins
  /// there; `turned`, the molecule is seen turned so (the screen's axes in its own). What of the `removed` atoms (ascending)
  /// the scene does not take from the hand anyway is not felt until the next call.
  virtual void beginSceneAgain(std::optional<PointA> before = {}, const std::optional<Quat>& turned = {},
                               const std::vector<std::uint32_t>& removed = {}) = 0;

 protected:
  ~Opener() = default;
};

}  // namespace moltact
