// The lines of an attempt's file: JSON Lines, UTF-8, one object per line, the key "kind" first. The first line is the
// header ("attempt"). Lengths are rounded to 0.001 angstrom, forces to 0.001 newton, times to 0.001 second. Not for the
// haptic thread. docs/results.md lists all keys.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/core/problem.h"
#include "engine/results/attempt.h"

namespace moltact {

/// One line with its line end. Bytes that are not UTF-8 are replaced; numbers that are not finite become 0.
std::string lineOf(const AttemptHeader& header);
std::string lineOf(const AttemptEvent& event);
/// A line that marks the place of `lines` lines that were lost because neither disk nor memory had room.
std::string gapLine(std::size_t lines);

/// The beginning of every first line, except for blanks that another program may have inserted.
inline constexpr std::string_view kHeaderBegins = R"({"kind":"attempt")";
/// Whether a first line, or an initial part of it, has this beginning.
bool mayBeginAttempt(std::string_view line);

/// The kind of a line without parsing all of it, with any blanks; most bytes of a file are of the kind "trace". Empty
/// if the first key is not "kind", as after a program that sorts keys; then the line must be parsed.
std::string_view leadingKind(std::string_view line);

/// Two readers of a file's first line. beginTimeOf() returns the time at which the attempt began, without parsing the rest;
/// empty if it is missing. readHeaderLine() returns a Problem (without file and line) if the line is not a header. It
/// ignores unknown keys.
std::string beginTimeOf(std::string_view line);
Expected<AttemptHeader> readHeaderLine(std::string_view line);

/// Reads any other line. Returns no value for an unknown kind (of a newer format). Returns a Problem (without file and
/// line) if the line is not a JSON object, marks a gap, or lacks a required key of the right type.
Expected<std::optional<AttemptEvent>> readEventLine(std::string_view line);

/// Longer lines are rejected (unit: byte).
inline constexpr std::size_t kLongestLine = std::size_t{4} << 20;

}  // namespace moltact
