// Reads molecules away from the window's thread, so that a large file does not stop it. Window's thread, but for the
// reading itself.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/ui/scene/touchable_model.h"
#include "engine/molecule/molecule_key.h"
#include "engine/platform/background.h"

namespace moltact {

struct Loaded {
  MoleculeKey key;
  Expected<TouchableModel> stage;
};

class Loader {
 public:
  using Read = std::function<Loaded(const MoleculeKey&)>;
  /// Reads by readStage unless another function is given. An exception that `read` throws becomes a problem.
  explicit Loader(Read read = {});

  /// Begins to read; what was being read before is no longer wanted.
  void begin(const MoleculeKey& key);
  bool busy() const { return newest_.busy(); }

  /// The molecule once it has been read, given once; nothing while it is being read.
  std::optional<Loaded> take() { return newest_.take(); }
  /// The same, waiting for it.
  std::optional<Loaded> wait() { return newest_.wait(); }

 private:
  Read read_;
  NewestWork<Loaded> newest_;
};

/// Reads a molecule and puts it on a stage. Any thread.
Loaded readStage(const MoleculeKey& key);

}  // namespace moltact
