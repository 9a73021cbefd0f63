// The body that a played hand holds, on the stage during playback of an attempt or a recording. Window's thread.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/ui/scene/haptic_session.h"

namespace moltact {

class PlayedBody {
 public:
  explicit PlayedBody(HapticSession& scene) : scene_(scene) {}

  /// Excludes these atoms (ascending) of the stage's molecule from touch; those of them held as a body are drawn only
  /// in the hand. The view is unchanged. Does nothing if the stage already is in this state.
  void hold(const std::vector<std::uint32_t>& untouchable, const std::vector<std::uint32_t>& held);
  /// Restores what was felt, held and hidden before the first hold(), unless another scene has been opened since.
  void release();

 private:
  struct Held {
    MoleculeKey molecule;
    std::vector<std::uint32_t> untouchable, held;
    AtomList hidden;
    friend bool operator==(const Held&, const Held&) = default;
  };
  Held now() const;
  void restage(const Held& wanted);

  HapticSession& scene_;
  std::optional<Held> before_;
  Held played_;  // set by hold()
};

}  // namespace moltact
