#include <windows.h>

#include "engine/platform/use_language.h"

namespace moltact {

std::string systemLocale() {
  wchar_t name[LOCALE_NAME_MAX_LENGTH] = {};
  if (!GetUserDefaultLocaleName(name, LOCALE_NAME_MAX_LENGTH)) return {};
  std::string out;
  for (const wchar_t* c = name; *c && *c < 128; ++c) out += char(*c);  // locale names are ASCII
  return out;
}

}  // namespace moltact
