// An immutable array whose copies share one storage. Any thread may read it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace moltact {

/// A copy costs one reference count. A std::vector of new elements replaces the whole array.
template <class T>
class SharedArray {
 public:
  SharedArray() = default;
  SharedArray(std::vector<T> items) {
    if (items.empty()) return;
    items_ = std::make_shared<const std::vector<T>>(std::move(items));
    first_ = items_->data();
    size_ = items_->size();
  }
  SharedArray(std::initializer_list<T> items) : SharedArray(std::vector<T>(items)) {}
  SharedArray(const SharedArray&) = default;
  SharedArray& operator=(const SharedArray&) = default;
  // A moved-from array is empty.
  SharedArray(SharedArray&& other) noexcept { swap(other); }
  SharedArray& operator=(SharedArray&& other) noexcept {
    SharedArray taken(std::move(other));
    swap(taken);
    return *this;
  }

  const T& operator[](std::size_t i) const { return first_[i]; }
  const T& front() const { return first_[0]; }
  const T& back() const { return first_[size_ - 1]; }
  const T* data() const { return first_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T* begin() const { return first_; }
  const T* end() const { return first_ + size_; }
  /// A copy that can be changed.
  std::vector<T> copy() const { return std::vector<T>(begin(), end()); }

  /// True if both share one storage.
  bool sharesWith(const SharedArray& other) const { return first_ == other.first_; }
  friend bool operator==(const SharedArray& a, const SharedArray& b) {
    return a.sharesWith(b) || std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  void swap(SharedArray& other) noexcept {
    std::swap(items_, other.items_);
    std::swap(first_, other.first_);
    std::swap(size_, other.size_);
  }

  std::shared_ptr<const std::vector<T>> items_;  // null where empty
  const T* first_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace moltact
