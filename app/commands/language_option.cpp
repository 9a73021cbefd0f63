#include "app/commands/language_option.h"

#include "app/commands/value_types.h"
#include "engine/language/catalogue.h"
#include "engine/platform/folders.h"
#include "engine/platform/terminal.h"
#include "engine/platform/use_language.h"

namespace moltact {
namespace {

void follow(const std::string& code) {
  if (const auto problem = useLanguage(code)) throw CLI::ValidationError("--language", problem->text());
}

std::string help() { return "Language of the output: " + languageCodes(", ") + "; default: that of the system"; }

}  // namespace

std::string languageCodes(const std::string& last_separator) {
  static const std::vector<Language> kLanguages = languages(translationsFolder());
  std::string out;
  for (const Language& l : kLanguages)
    out += (out.empty() ? "" : &l == &kLanguages.back() ? last_separator : ", ") + l.code;
  return out;
}

void selectLanguage() {
  if (const auto problem = useLanguage({})) err() << "moltact: " << problem->text() << '\n';
}

void addLanguageOption(CLI::App& app) {
  app.add_option_function<std::string>("--language", follow, help())->type_name(kLanguageType)->trigger_on_parse();
}

void addLanguageOption(CLI::App& app, std::string& into) {
  app.add_option_function<std::string>(
         "--language",
         [&into](const std::string& code) {
           follow(code);
           into = code;
         },
         help())
      ->type_name(kLanguageType)
      ->trigger_on_parse();
}

}  // namespace moltact
