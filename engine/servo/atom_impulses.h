// The impulses that the hand gives the scene's atoms, summed by the haptic thread and taken by a slower one: lock-free,
// and nothing is lost or counted twice. A simulation or an elastic molecule integrates them. All memory is allocated at
// construction. Units: newton second at the hand (force times the time of a tick), in the molecule's axes.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/units.h"
#include "engine/haptics/felt_force.h"

namespace moltact {

struct AtomImpulse {
  std::int32_t atom = -1;
  Vec3 impulse_N_s{0.0};
};

/// The impulses of all ticks since the last read, one entry per atom.
class AtomImpulses {
 public:
  explicit AtomImpulses(std::size_t max_atoms);

  std::span<const AtomImpulse> atoms() const { return std::span(atoms_).first(count_); }
  std::uint64_t ticks = 0;  ///< number of ticks with an interaction since the last read, also those without a force
  std::uint32_t scene = 0;  ///< number of the scene to which the atoms belong
  Vec3 sum_N_s{0.0};        ///< sum over all atoms of the scene, with `dropped_N_s`
  /// Sum over the atoms for which there was no room, and the number of their reactions.
  Vec3 dropped_N_s{0.0};
  std::size_t dropped = 0;
  /// Sum over the scenes before `scene` that were not read; their atoms are no longer known.
  Vec3 earlier_N_s{0.0};

 private:
  friend class ImpulseExchange;
  void clear() noexcept;
  void begin(std::uint32_t next_scene) noexcept;
  void add(const AtomForce& force, double dt_s) noexcept;
  AtomImpulse* entryOf(std::int32_t atom) noexcept;

  // A hash table with open addressing, at most half full, of indices into atoms_. A slot of another generation is
  // empty, so that the table is cleared in constant time.
  struct Slot {
    std::uint32_t generation = 0, entry = 0;
  };
  std::vector<AtomImpulse> atoms_;
  std::size_t count_ = 0;
  std::vector<Slot> slots_;
  std::uint32_t generation_ = 1;
};

/// Two sums, of which the haptic thread fills one and the reader holds the other.
class ImpulseExchange {
 public:
  explicit ImpulseExchange(std::size_t max_atoms = kMaxAtoms);
  ImpulseExchange(const ImpulseExchange&) = delete;
  ImpulseExchange& operator=(const ImpulseExchange&) = delete;

  /// The greatest number of atoms with their own entry between two reads.
  static constexpr std::size_t kMaxAtoms = 1024;

  /// Adds the reactions of one tick of `dt_s`. Haptic thread: no lock and no allocation; the work is proportional to
  /// the number of reactions.
  void add(std::span<const AtomForce> reactions, double dt_s, std::uint32_t scene) noexcept;

  /// Takes the sum since the last call and starts a new one. If a tick is being added at this moment, the result is
  /// empty and the sum comes with the next call. The reference is valid until the next call. Reader's thread.
  const AtomImpulses& take() noexcept;

 private:
  AtomImpulses first_, second_;
  const AtomImpulses none_{0};
  // Each sum is in one of four places: in add(), at the reader, or in one of these two. The reader holds at most one, so
  // that add() always finds the other; it returns one only after add() has taken the empty one.
  std::atomic<AtomImpulses*> filled_{&first_}, empty_{&second_};
  AtomImpulses* taken_ = nullptr;  // owned by the reader's thread
};

}  // namespace moltact
