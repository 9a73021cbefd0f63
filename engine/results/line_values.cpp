#include "engine/results/line_values.h"

#include <algorithm>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/results/attempt_ranges.h"

namespace moltact::line_values {

const Json& need(const Json& from, const char* key) {
  const auto it = from.find(key);
  if (it == from.end()) throw LineError{trf("'{0}' is missing", key)};
  return *it;
}

std::string text(const Json& value, const char* key) {
  if (!value.is_string()) throw LineError{trf("'{0}' is no text", key)};
  return value.get<std::string>();
}
std::string text(const Json& from, const char* key, bool needed) {
  const auto it = from.find(key);
  if (it == from.end() && !needed) return {};
  return text(need(from, key), key);
}

double number(const Json& value, const char* key) {
  if (!value.is_number()) throw LineError{trf("'{0}' is no number", key)};
  const double number = value.get<double>();
  const AttemptRange* range = attemptRange(key);
  if (range && number >= range->min && number <= range->max && (!range->whole || number == std::floor(number)))
    return number;
  if (range && range->whole) throw LineError{trf("'{0}' is no whole number that fits", key)};
  throw LineError{trf("'{0}' is a number that no Moltact writes", key)};
}
double numberAt(const Json& from, const char* key) { return number(need(from, key), key); }
double numberOr(const Json& from, const char* key, double otherwise) {
  return from.contains(key) ? numberAt(from, key) : otherwise;
}

std::size_t count(const Json& value, const char* key) {
  return static_cast<std::size_t>(std::max(0.0, number(value, key)));
}
std::size_t countAt(const Json& from, const char* key) { return count(need(from, key), key); }

const Json& list(const Json& from, const char* key, std::size_t max) {
  const Json& value = need(from, key);
  if (!value.is_array()) throw LineError{trf("'{0}' is no list", key)};
  if (value.size() > max) throw LineError{trf("'{0}' is longer than any that Moltact writes", key)};
  return value;
}
const Json& listOrNone(const Json& from, const char* key, std::size_t max) {
  static const Json kNone = Json::array();
  return from.contains(key) ? list(from, key, max) : kNone;
}

bool flag(const Json& from, const char* key) {
  const Json& value = need(from, key);
  if (!value.is_boolean()) throw LineError{trf("'{0}' is neither true nor false", key)};
  return value.get<bool>();
}

std::vector<double> numbers(const Json& from, const char* key, std::size_t size) {
  const Json& values = list(from, key);
  if (values.size() != size) throw LineError{trf("'{0}' should hold {1} numbers", key, size)};
  std::vector<double> out;
  for (const Json& v : values) out.push_back(number(v, key));
  return out;
}

Vec3 vector(const Json& from, const char* key) {
  const std::vector<double> v = numbers(from, key, 3);
  return {v[0], v[1], v[2]};
}

const Json& object(const Json& value, const char* what) {
  if (!value.is_object()) throw LineError{trf("'{0}' is no object", what)};
  return value;
}

}  // namespace moltact::line_values
