// A string optimized for short texts that occur in millions: 16 bytes instead of the 32 of std::string. Any thread
// except the haptic one.
#pragma once

#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

namespace moltact {

/// Up to 15 bytes are stored in the object itself, longer texts on the heap (at most 4 GiB). Converts to
/// std::string_view.
class ShortText {
 public:
  static constexpr std::size_t kInside = 15;

  ShortText() = default;
  ShortText(std::string_view text) {
    if (text.size() <= kInside) {
      if (!text.empty()) std::memcpy(bytes_, text.data(), text.size());
      bytes_[kInside] = static_cast<char>(text.size());
      return;
    }
    char* const copy = new char[text.size()];
    std::memcpy(copy, text.data(), text.size());
    const auto size = static_cast<std::uint32_t>(text.size());
    std::memcpy(bytes_, &copy, sizeof copy);
    std::memcpy(bytes_ + sizeof copy, &size, sizeof size);
    bytes_[kInside] = kOnHeap;
  }
  ShortText(const std::string& text) : ShortText(std::string_view(text)) {}
  ShortText(const char* text) : ShortText(std::string_view(text)) {}
  ShortText(const ShortText& from) : ShortText(std::string_view(from)) {}
  ShortText(ShortText&& from) noexcept { swap(from); }
  ShortText& operator=(ShortText from) noexcept {
    swap(from);
    return *this;
  }
  ~ShortText() {
    if (bytes_[kInside] == kOnHeap) delete[] heap();
  }

  operator std::string_view() const {
    if (bytes_[kInside] != kOnHeap) return {bytes_, static_cast<std::size_t>(bytes_[kInside])};
    std::uint32_t size = 0;
    std::memcpy(&size, bytes_ + sizeof(char*), sizeof size);
    return {heap(), size};
  }
  std::string string() const { return std::string(std::string_view(*this)); }
  bool empty() const { return bytes_[kInside] == 0; }

  friend bool operator==(const ShortText& a, const ShortText& b) { return std::string_view(a) == std::string_view(b); }
  friend bool operator==(const ShortText& a, std::string_view b) { return std::string_view(a) == b; }
  friend bool operator==(const ShortText& a, const std::string& b) { return std::string_view(a) == b; }
  friend bool operator==(const ShortText& a, const char* b) { return std::string_view(a) == b; }
  friend std::ostream& operator<<(std::ostream& out, const ShortText& text) { return out << std::string_view(text); }

 private:
  static constexpr char kOnHeap = 0x7f;
  char* heap() const {
    char* out = nullptr;
    std::memcpy(&out, bytes_, sizeof out);
    return out;
  }
  void swap(ShortText& other) noexcept {
    char held[sizeof bytes_];
    std::memcpy(held, bytes_, sizeof held);
    std::memcpy(bytes_, other.bytes_, sizeof held);
    std::memcpy(other.bytes_, held, sizeof held);
  }
  // The text and its length; or, with kOnHeap, a pointer followed by a length of 4 bytes. Aligned like a pointer, so
  // that leak checkers find it.
  alignas(char*) char bytes_[kInside + 1]{};
};

}  // namespace moltact
