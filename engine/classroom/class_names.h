// The names of a class: what students type, and animals for those who type nothing. No two students have the same name.
// Pure; any one thread but the haptic one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace moltact {

/// A typed name on one line, without characters that control a display, with single blanks, of at most
/// kMaxNameCharacters.
std::string cleanName(std::string_view typed);
inline constexpr std::size_t kMaxNameCharacters = 40;

class NameBook {
 public:
  /// `seed` sets the order of the animals.
  explicit NameBook(std::uint64_t seed);

  /// Gives out a name: the wanted one, or an animal's if it is empty after cleaning. If it is taken (capitals do not
  /// count), a number follows: "Anna 2".
  std::string take(std::string_view wanted);
  /// Marks a name as taken, as after a restart.
  void mark(const std::string& name);

 private:
  std::vector<std::string> animals_;
  std::size_t next_ = 0;
  std::set<std::string> taken_;
};

}  // namespace moltact
