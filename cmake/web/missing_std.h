// The parts of C++20 that this program uses and emscripten's libc++ lacks (13 in Debian 12, 19 in Debian 13). Included
// before every source of the browser edition, so that the sources need no conditions.
#pragma once

#include <version>

#ifndef __cpp_lib_to_chars
#ifndef FMT_HEADER_ONLY
#define FMT_HEADER_ONLY 1
#endif
#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <type_traits>

namespace std {

template <class F, enable_if_t<is_floating_point_v<F>, int> = 0>
from_chars_result from_chars(const char* first, const char* last, F& value,
                             chars_format format = chars_format::general) {
  if (format == chars_format::hex) {
    // Without "0x", as the standard requires.
    char text[64] = "0x";
    size_t to = 2;
    const char* at = first;
    if (at != last && *at == '-') text[0] = '-', text[1] = '0', text[2] = 'x', to = 3, ++at;
    while (at != last && to + 1 < sizeof text) text[to++] = *at++;
    text[to] = '\0';
    char* end = nullptr;
    const double read = strtod(text, &end);
    const ptrdiff_t prefix = text[0] == '-' ? 3 : 2;
    if (end - text <= prefix) return {first, errc::invalid_argument};
    value = F(read);
    return {first + (end - text) - 2, errc{}};
  }
  const auto [end, error] = fast_float::from_chars(first, last, value);
  return {end, error};
}

template <class F, enable_if_t<is_floating_point_v<F>, int> = 0>
to_chars_result to_chars(char* first, char* last, F value) {
  const auto [end, size] = fmt::format_to_n(first, size_t(last - first), "{}", value);
  if (size > size_t(last - first)) return {last, errc::value_too_large};
  return {end, errc{}};
}

template <class F, enable_if_t<is_floating_point_v<F>, int> = 0>
to_chars_result to_chars(char* first, char* last, F value, chars_format format) {
  if (format != chars_format::hex) return to_chars(first, last, value);
  char text[40];
  const int size = snprintf(text, sizeof text, "%a", double(value));
  char* out = first;
  for (int k = 0; k < size; ++k) {
    if (text[k] == 'x' || (text[k] == '0' && k + 1 < size && text[k + 1] == 'x')) continue;
    if (out == last) return {last, errc::value_too_large};
    *out++ = text[k];
  }
  return {out, errc{}};
}

}  // namespace std
#endif

#ifndef __cpp_lib_bit_cast
#include <cstring>
namespace std {
template <class To, class From>
To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  memcpy(&to, &from, sizeof to);
  return to;
}
}  // namespace std
#endif
