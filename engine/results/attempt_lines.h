// How an attempt stands in its file: JSON Lines, UTF-8, one object a line, the key "kind" first. The first line is the
// header ("attempt"). Lengths are in angstrom to 0.001, forces in newton to 0.001, times in second to 0.001.
// Not for the haptic thread. The table of all keys is in docs/results.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/core/problem.h"
#include "engine/results/attempt.h"

namespace moltact {

/// One line with its line end. Bytes that are no UTF-8 are replaced, numbers that are not finite become 0.
std::string lineOf(const AttemptHeader& header);
std::string lineOf(const AttemptEvent& event);
/// The mark that so many lines are missing at this place, for which there was neither disk nor memory.
std::string gapLine(std::size_t lines);

/// How every first line begins, but for the blanks that another program may have put between.
inline constexpr std::string_view kHeaderBegins = R"({"kind":"attempt")";
/// Whether a first line, or the part of it that there is, begins so.
bool mayBeginAttempt(std::string_view line);

/// The kind of a line without parsing it, whatever blanks stand in it: most bytes of a file are of the kind "trace".
/// Empty where its first key is another, as a program that sorts keys writes it: then only reading the line tells.
std::string_view leadingKind(std::string_view line);

/// The first line of a file. A Problem (without file and line) where it is none. Unknown keys are passed over.
/// When the attempt of this first line began, without reading the rest of the line; empty where it does not say.
std::string beganOf(std::string_view line);
Expected<AttemptHeader> readHeaderLine(std::string_view line);

/// Any other line; no value for a kind that is not known (of a newer format). A Problem (without file and line) where
/// it is no JSON object or the mark of a gap, or where a key that its kind needs is missing or of another type.
Expected<std::optional<AttemptEvent>> readEventLine(std::string_view line);

/// Longer lines are refused (unit: byte).
inline constexpr std::size_t kLongestLine = std::size_t{4} << 20;

}  // namespace moltact
