#include "engine/lesson/suggestion.h"

#include <algorithm>
#include <array>

#include "engine/language/catalogue.h"

namespace moltact {

namespace {

constexpr std::size_t kLongest = 64;

/// The editDistance, or any number above `max` if it exceeds that.
std::size_t distanceUpTo(std::string_view a, std::string_view b, std::size_t max) {
  if (a.size() > kLongest || b.size() > kLongest) return kLongest;
  while (!a.empty() && !b.empty() && a.front() == b.front()) a.remove_prefix(1), b.remove_prefix(1);
  while (!a.empty() && !b.empty() && a.back() == b.back()) a.remove_suffix(1), b.remove_suffix(1);
  std::array<std::array<std::size_t, kLongest + 1>, 3> rows{};
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
  std::size_t min_above = 0;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& row = rows[i % 3];
    const auto& above = rows[(i + 2) % 3];
    row[0] = i;
    std::size_t min = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], rows[(i + 1) % 3][j - 2] + 1);
      min = std::min(min, row[j]);
    }
    // Later rows are not less than this one, except for a swap, which depends on the row above.
    if (std::min(min, min_above) > max) return kLongest;
    min_above = min;
  }
  return rows[a.size() % 3][b.size()];
}

}  // namespace

std::size_t editDistance(std::string_view a, std::string_view b) { return distanceUpTo(a, b, kLongest); }

std::string_view nearest(std::string_view word, std::span<const std::string_view> known) {
  std::string_view found;
  std::size_t min = 1000;
  for (std::string_view k : known) {
    if (min == 0) break;
    // The difference in length is a lower bound of the distance.
    const std::size_t lengths = word.size() > k.size() ? word.size() - k.size() : k.size() - word.size();
    const std::size_t max = std::min(std::max<std::size_t>(1, k.size() / 3), min - 1);
    if (lengths > max) continue;
    const std::size_t distance = distanceUpTo(word, k, max);
    if (distance <= max) {
      min = distance;
      found = k;
    }
  }
  return found;
}

std::string didYouMean(std::string_view word) { return trf("did you mean '{0}'?", word); }

std::string suggest(std::string_view word, std::span<const std::string_view> known, std::string_view list_name) {
  if (known.empty()) return {};
  if (const std::string_view near = nearest(word, known); !near.empty()) return didYouMean(near);
  std::string out = std::string(list_name) + ": ";
  constexpr std::size_t kMaxListed = 100;
  for (std::size_t i = 0; i < std::min(known.size(), kMaxListed); ++i) out += (i ? ", " : "") + std::string(known[i]);
  if (known.size() > kMaxListed) out += ", …";
  return out;
}

std::string joined(std::span<const std::string_view> words, std::string_view last) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out.append(i == 0 ? std::string_view() : i + 1 == words.size() ? last : ", ").append(words[i]);
  return out;
}

}  // namespace moltact
