// Reads the values of a line of an attempt by their keys. Each function returns a valid value or throws a LineError
// that describes the fault. Not for the haptic thread.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/core/units.h"

namespace moltact::line_values {

using Json = nlohmann::ordered_json;

/// The fault of a line, in the language in use. The reader of the whole line catches it (read_attempt_lines.cpp).
struct LineError {
  std::string what;
};

inline constexpr std::size_t kAnyLength = ~std::size_t{0};

const Json& need(const Json& from, const char* key);
const Json& object(const Json& value, const char* what);

std::string text(const Json& value, const char* key);
/// With `needed` false, a missing key gives an empty text.
std::string text(const Json& from, const char* key, bool needed);
bool flag(const Json& from, const char* key);

/// Every number must be in the range of its key (attempt_ranges.h).
double number(const Json& value, const char* key);
double numberAt(const Json& from, const char* key);
double numberOr(const Json& from, const char* key, double otherwise);
std::size_t count(const Json& value, const char* key);
std::size_t countAt(const Json& from, const char* key);

const Json& list(const Json& from, const char* key, std::size_t max = kAnyLength);
const Json& listOrNone(const Json& from, const char* key, std::size_t max = kAnyLength);
/// The list must have exactly `size` numbers.
std::vector<double> numbers(const Json& from, const char* key, std::size_t size);
Vec3 vector(const Json& from, const char* key);

}  // namespace moltact::line_values
