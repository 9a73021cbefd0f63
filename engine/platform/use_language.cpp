#include "engine/platform/use_language.h"

#include <cstdlib>

#include "engine/language/catalogue.h"
#include "engine/platform/folders.h"

namespace moltact {

std::string languageOfEnvironment() {
  const char* value = std::getenv("MOLTACT_LANGUAGE");
  return value ? value : "";
}

std::optional<Problem> useLanguage(const std::string& wanted) {
  const std::filesystem::path folder = translationsFolder();
  const std::string asked = wanted.empty() ? languageOfEnvironment() : wanted;
  return setLanguage(asked.empty() ? systemLanguage(folder, systemLocale()) : asked, folder);
}

}  // namespace moltact
