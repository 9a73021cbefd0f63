// "did you mean …?": the known word that is nearest to a misspelt one. Pure functions; any thread.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace moltact {

/// How many letters must be put in, left out, replaced or swapped with their neighbour to make `a` of `b` (the optimal
/// string alignment distance of Damerau and Levenshtein). Words beyond 64 bytes give 64.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The nearest of `known`, where one is near enough: at most a third of its letters away, at least one. Otherwise
/// empty.
std::string_view nearest(std::string_view word, std::span<const std::string_view> known);

/// "did you mean 'feel'?"
std::string didYouMean(std::string_view word);

/// "did you mean 'feel'?" for the nearest of `known`, where one is near enough; otherwise the list "known: a, b, c",
/// the first hundred of it. `list_name` is in the language in use. Empty where nothing is known.
std::string suggest(std::string_view word, std::span<const std::string_view> known, std::string_view list_name);

/// The words with ", " between them and `last` before the last.
std::string joined(std::span<const std::string_view> words, std::string_view last);

}  // namespace moltact
