#include "engine/servo/atom_impulses.h"

#include <bit>

namespace moltact {

AtomImpulses::AtomImpulses(std::size_t max_atoms)
    : atoms_(max_atoms), slots_(max_atoms ? std::bit_ceil(2 * max_atoms) : 0) {}

void AtomImpulses::clear() noexcept {
  ticks = 0;
  sum_N_s = dropped_N_s = earlier_N_s = Vec3(0.0);
  dropped = count_ = 0;
  if (++generation_ != 0) return;
  // Once in 2^32 calls: the slots of the first generations would be valid again.
  for (Slot& slot : slots_) slot = {};
  generation_ = 1;
}

void AtomImpulses::begin(std::uint32_t next_scene) noexcept {
  if (scene == next_scene) return;
  const Vec3 earlier = earlier_N_s + sum_N_s;
  clear();
  earlier_N_s = earlier;
  scene = next_scene;
}

AtomImpulse* AtomImpulses::entryOf(std::int32_t atom) noexcept {
  constexpr std::uint32_t kSpread = 2654435769u;  // Fibonacci hashing: 2^32 divided by the golden ratio
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t at = (static_cast<std::uint32_t>(atom) * kSpread >> 8) & mask;; at = (at + 1) & mask) {
    Slot& slot = slots_[at];
    if (slot.generation == generation_) {
      if (atoms_[slot.entry].atom == atom) return &atoms_[slot.entry];
      continue;
    }
    if (count_ == atoms_.size()) return nullptr;
    slot = {generation_, static_cast<std::uint32_t>(count_)};
    atoms_[count_] = {atom, Vec3(0.0)};
    return &atoms_[count_++];
  }
}

void AtomImpulses::add(const AtomForce& force, double dt_s) noexcept {
  const Vec3 impulse_N_s = force.force_N * dt_s;
  sum_N_s += impulse_N_s;
  if (AtomImpulse* entry = entryOf(force.atom)) {
    entry->impulse_N_s += impulse_N_s;
    return;
  }
  dropped_N_s += impulse_N_s;
  ++dropped;
}

ImpulseExchange::ImpulseExchange(std::size_t max_atoms) : first_(max_atoms), second_(max_atoms) {}

void ImpulseExchange::add(std::span<const AtomForce> reactions, double dt_s, std::uint32_t scene) noexcept {
  // The sum that the reader has not taken yet continues; otherwise the empty one begins.
  AtomImpulses* sum = filled_.exchange(nullptr, std::memory_order_acq_rel);
  if (!sum) sum = empty_.exchange(nullptr, std::memory_order_acq_rel);
  sum->begin(scene);
  ++sum->ticks;
  for (const AtomForce& force : reactions) sum->add(force, dt_s);
  filled_.store(sum, std::memory_order_release);
}

const AtomImpulses& ImpulseExchange::take() noexcept {
  if (taken_) {
    taken_->clear();
    // add() uses the empty sum in the first tick after a read. While it is there, no tick has passed.
    if (empty_.load(std::memory_order_acquire)) return *taken_;
    empty_.store(taken_, std::memory_order_release);
  }
  taken_ = filled_.exchange(nullptr, std::memory_order_acq_rel);
  return taken_ ? *taken_ : none_;
}

}  // namespace moltact
