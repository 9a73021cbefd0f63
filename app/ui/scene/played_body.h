// What a played hand holds, on the stage while it is played: an attempt's hand, or a recorded one. Window's thread.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/ui/scene/haptic_session.h"

namespace moltact {

class PlayedBody {
 public:
  explicit PlayedBody(HapticSession& scene) : scene_(scene) {}

  /// The stage's molecule with these atoms (ascending) not felt, and of them those held as a body and drawn in the hand
  /// alone. The view stays as it is. Nothing changes where the stage is so.
  void hold(const std::vector<std::uint32_t>& untouchable, const std::vector<std::uint32_t>& held);
  /// Back to what was felt, held and hidden before the first hold(), unless another scene has come since.
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
  Held played_;  // as hold() left it
};

}  // namespace moltact
