// Decides which source of motion moves the scene's atoms when several could: the two states of a scene, an elastic
// network, a trajectory, a simulation, a playback. A source claims the atoms before it moves them; HapticSession moves
// them for the owner only. Window's thread.
#pragma once

#include <cstdint>

namespace moltact {

enum class MotionRank : std::uint8_t {
  Scene,     ///< moves the atoms of the open scene
  Playback,  ///< repeats a recorded motion; takes the atoms from a source of the scene
};

class MotionSource;

class MotionOwner {
 public:
  /// The source that moves the atoms; null: none.
  const MotionSource* holder() const { return holder_; }

 private:
  friend class MotionSource;
  const MotionSource* holder_ = nullptr;
};

/// One source of motion, as a member of the class that moves the atoms. `owner` must outlive it.
class MotionSource {
 public:
  MotionSource(MotionOwner& owner, MotionRank rank) : owner_(owner), rank_(rank) {}
  ~MotionSource() { release(); }
  MotionSource(const MotionSource&) = delete;
  MotionSource& operator=(const MotionSource&) = delete;

  /// Claims the atoms. Returns true if this source owns them from now on: nobody did, it did already, or the owner has a
  /// lower rank. Returns false while another source of the same or a higher rank owns them; try again in a later frame.
  bool claim() {
    if (!owner_.holder_ || owner_.holder_->rank_ < rank_) owner_.holder_ = this;
    return owns();
  }
  /// Gives the atoms back. Does nothing if another source owns them.
  void release() {
    if (owns()) owner_.holder_ = nullptr;
  }
  bool owns() const { return owner_.holder_ == this; }

 private:
  MotionOwner& owner_;
  const MotionRank rank_;
};

}  // namespace moltact
