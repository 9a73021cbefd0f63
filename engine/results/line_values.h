// The values of a line of an attempt by their keys: each reader gives a value that its key may have, or throws a
// LineError that says what the line lacks, so that a kind of line is read one key after the other. Not for the haptic
// thread.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/core/units.h"

namespace moltact::line_values {

using Json = nlohmann::ordered_json;

/// What a line lacks, in the language in use; caught where the whole line is read (read_attempt_lines.cpp).
struct LineError {
  std::string what;
};

inline constexpr std::size_t kAnyLength = ~std::size_t{0};

const Json& need(const Json& from, const char* key);
const Json& object(const Json& value, const char* what);

std::string text(const Json& value, const char* key);
/// Empty where it is not there and not needed.
std::string text(const Json& from, const char* key, bool needed);
bool flag(const Json& from, const char* key);

/// Every number of the format has a range (attempt_ranges.h).
double number(const Json& value, const char* key);
double numberAt(const Json& from, const char* key);
double numberOr(const Json& from, const char* key, double otherwise);
std::size_t count(const Json& value, const char* key);
std::size_t countAt(const Json& from, const char* key);

const Json& list(const Json& from, const char* key, std::size_t most = kAnyLength);
const Json& listOrNone(const Json& from, const char* key, std::size_t most = kAnyLength);
/// Exactly `size` of them.
std::vector<double> numbers(const Json& from, const char* key, std::size_t size);
Vec3 vector(const Json& from, const char* key);

}  // namespace moltact::line_values
