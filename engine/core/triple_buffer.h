// Passes complete values from one writing to one reading thread without locks; neither thread waits. The reader gets
// the newest complete value; intermediate values are skipped.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace moltact {

template <class T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& first = T{}) { slots_.fill(first); }

  /// Writer's thread only. No allocation, no waiting.
  void write(const T& value) noexcept {
    static_assert(std::is_trivially_copyable_v<T>, "a value is handed over whole, byte for byte");
    slots_[back_] = value;
    publish();
  }

  /// Writer's thread only: the buffer that publish() will pass on, to be filled in place. It contains some older value.
  T& back() noexcept { return slots_[back_]; }
  void publish() noexcept {
    back_ = middle_.exchange(static_cast<std::uint8_t>(back_ | kFresh), std::memory_order_acq_rel) & kIndex;
  }

  /// Reader's thread only: the newest value. The reference is valid until the next read.
  const T& read() noexcept {
    if (middle_.load(std::memory_order_relaxed) & kFresh)
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return slots_[front_];
  }

 private:
  static constexpr std::uint8_t kIndex = 3, kFresh = 4;
  std::array<T, 3> slots_;
  alignas(64) std::uint8_t back_ = 0;  // owned by the writer
  alignas(64) std::atomic<std::uint8_t> middle_{1};
  alignas(64) std::uint8_t front_ = 2;  // owned by the reader
};

}  // namespace moltact
