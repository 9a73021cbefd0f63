// Reads molecules on a separate thread, so that a large file does not block the window. Window's thread, except the
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
  /// Reads with readStage() unless another function is given. An exception thrown by `read` becomes a problem.
  explicit Loader(Read read = {});

  /// Starts reading; the result of an earlier call is discarded.
  void begin(const MoleculeKey& key);
  bool busy() const { return newest_.busy(); }

  /// Returns the molecule once it has been read, only once; nothing while it is being read.
  std::optional<Loaded> take() { return newest_.take(); }
  /// The same, but blocks until it has been read.
  std::optional<Loaded> wait() { return newest_.wait(); }

 private:
  Read read_;
  NewestWork<Loaded> newest_;
};

/// Reads a molecule and makes its model. Any thread.
Loaded readStage(const MoleculeKey& key);

}  // namespace moltact
