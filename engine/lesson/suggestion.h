// Suggests the known word nearest to a misspelt one: "did you mean …?". Pure functions; any thread.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace moltact {

/// The optimal string alignment distance (Damerau and Levenshtein): the number of insertions, deletions, replacements
/// and swaps of neighbours that turn `b` into `a`. Words longer than 64 bytes give 64.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The nearest of `known` if its distance is at most a third of its length, or 1. Otherwise empty.
std::string_view nearest(std::string_view word, std::span<const std::string_view> known);

/// "did you mean 'feel'?"
std::string didYouMean(std::string_view word);

/// "did you mean 'feel'?" for the nearest of `known`. If none is near enough, the list "known: a, b, c" of at most a
/// hundred words. `list_name` is in the language in use. Empty if `known` is empty.
std::string suggest(std::string_view word, std::span<const std::string_view> known, std::string_view list_name);

/// The words separated by ", ", with `last` before the last one.
std::string joined(std::span<const std::string_view> words, std::string_view last);

}  // namespace moltact
