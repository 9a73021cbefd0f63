#include "app/commands/language_option.h"

#include "app/commands/value_types.h"
#include "engine/platform/terminal.h"
#include "engine/platform/use_language.h"

namespace moltact {
namespace {

void follow(const std::string& code) {
  if (const auto problem = useLanguage(code)) throw CLI::ValidationError("--language", problem->text());
}

constexpr const char* kHelp = "Language of the output: en, de; default: that of the system";

}  // namespace

void selectLanguage() {
  if (const auto problem = useLanguage({})) err() << "moltact: " << problem->text() << '\n';
}

void addLanguageOption(CLI::App& app) {
  app.add_option_function<std::string>("--language", follow, kHelp)->type_name(kLanguageType)->trigger_on_parse();
}

void addLanguageOption(CLI::App& app, std::string& into) {
  app.add_option_function<std::string>(
         "--language",
         [&into](const std::string& code) {
           follow(code);
           into = code;
         },
         kHelp)
      ->type_name(kLanguageType)
      ->trigger_on_parse();
}

}  // namespace moltact
