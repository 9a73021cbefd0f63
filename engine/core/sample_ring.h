// A lock-free queue of fixed capacity from one writing to one reading thread. A full queue drops and counts new values:
// the writer never waits.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace moltact {

template <class T, std::size_t kCapacity>
class SampleRing {
  static_assert((kCapacity & (kCapacity - 1)) == 0, "the capacity is a power of two");
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Writer's thread only. Returns false if the queue is full; the value is then dropped.
  bool push(const T& value) noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head - tail_.load(std::memory_order_acquire) == kCapacity) {
      dropped_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    values_[head & (kCapacity - 1)] = value;
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

  /// Reader's thread only. Removes the oldest value; returns false if there is none.
  bool pop(T& value) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail == head_.load(std::memory_order_acquire)) return false;
    value = values_[tail & (kCapacity - 1)];
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }

  /// Number of dropped values. Any thread.
  std::size_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }

 private:
  std::unique_ptr<T[]> values_ = std::make_unique<T[]>(kCapacity);
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
  std::atomic<std::size_t> dropped_{0};
};

}  // namespace moltact
