// moltact completion: prints a bash completion of the program's commands, options and values. It is generated from the
// same tables as --help and requires only bash.
#include <algorithm>
#include <sstream>

#include "app/commands/command.h"
#include "app/commands/command_tree.h"
#include "app/commands/value_types.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/catalogue.h"
#include "engine/platform/folders.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

std::string inQuotes(const std::vector<std::string>& words) {
  std::string out = "'";
  for (const std::string& word : words) out += (out.size() > 1 ? " " : "") + word;
  return out + "'";
}

std::vector<std::string> moleculeIds() {
  std::vector<std::string> out;
  if (const auto entries = readCatalogue(moleculesFolder()))
    for (const CatalogueEntry& e : *entries) out.push_back(e.id);
  return out;
}

std::vector<std::string> knownLanguages() {
  std::vector<std::string> out;
  for (const Language& l : languages(translationsFolder())) out.push_back(l.code);
  return out;
}

// The possible values of an option or argument: words, and a file kind for `compgen -A`.
struct Values {
  std::vector<std::string> words;
  const char* files = "";
};

Values valuesOf(const CLI::Option& option) {
  Values out{choicesOf(option)};
  const std::string type = option.get_type_name();
  if (type == kMoleculeType) out.words = moleculeIds();
  if (type == kLanguageType) out.words = knownLanguages();
  if (type == kFileType || type == kMoleculeType || type == kFilesOrFoldersType) out.files = "file";
  if (type == kFolderType) out.files = "directory";
  return out;
}

std::vector<std::string> spellings(const CLI::Option& option) {
  std::vector<std::string> out;
  for (const std::string& name : option.get_snames()) out.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.push_back("--" + name);
  return out;
}

void putPaths(std::ostream& script, const CLI::App& command) {
  for (const CLI::App* inner : shownCommands(command)) {
    script << "      " << inQuotes({fullName(*inner)}) << ") path=" << inQuotes({fullName(*inner)}) << " ;;\n";
    putPaths(script, *inner);
  }
}

void putValues(std::ostream& script, const CLI::App& command) {
  for (const CLI::Option* option : shownOptions(command, Wanted::Options)) {
    if (!takesValue(*option)) continue;
    script << "    ";
    const char* bar = "";
    for (const std::string& name : spellings(*option)) {
      script << bar << inQuotes({fullName(command) + ' ' + name});
      bar = "|";
    }
    const Values values = valuesOf(*option);
    script << ") words=" << inQuotes(values.words) << " files=" << inQuotes({values.files}) << " ;;\n";
  }
  for (const CLI::App* inner : shownCommands(command)) putValues(script, *inner);
}

void putCommands(std::ostream& script, const CLI::App& command) {
  std::vector<std::string> words, options;
  const char* files = "";
  for (const CLI::App* inner : shownCommands(command)) words.push_back(inner->get_name());
  for (const CLI::Option* argument : shownOptions(command, Wanted::Arguments)) {
    const Values values = valuesOf(*argument);
    words.insert(words.end(), values.words.begin(), values.words.end());
    if (*values.files) files = values.files;
  }
  for (const CLI::Option* option : shownOptions(command, Wanted::Options))
    for (const std::string& name : spellings(*option)) options.push_back(name);
  script << "    " << inQuotes({fullName(command)}) << ") words=" << inQuotes(words) << " files=" << inQuotes({files})
         << "\n      options=" << inQuotes(options) << " ;;\n";
  for (const CLI::App* inner : shownCommands(command)) putCommands(script, *inner);
}

std::string bashScript(const CLI::App& program) {
  std::ostringstream script;
  script << R"(# Completion of moltact in bash; made by `moltact completion`.
_moltact() {
  local current=${COMP_WORDS[COMP_CWORD]} before= path=moltact words= files= options= k
  ((COMP_CWORD > 0)) && before=${COMP_WORDS[COMP_CWORD - 1]}
  # bash parts words at '=' too: --theme=dark are three.
  if [[ $current == = ]]; then current=
  elif [[ $before == = ]] && ((COMP_CWORD > 1)); then before=${COMP_WORDS[COMP_CWORD - 2]}; fi
  for ((k = 1; k < COMP_CWORD; ++k)); do
    case "$path ${COMP_WORDS[k]}" in
)";
  putPaths(script, program);
  script << "    esac\n  done\n  case \"$path\" in\n";
  putCommands(script, program);
  script << "  esac\n  case \"$path $before\" in\n";
  putValues(script, program);
  script << R"(    *) [[ $current == -* ]] && words=$options files= ;;
  esac
  COMPREPLY=()
  while read -r k; do COMPREPLY+=("$k"); done < <(compgen -W "$words" -- "$current")
  [[ $files ]] || return 0
  compopt -o filenames 2>/dev/null
  while read -r k; do COMPREPLY+=("$k"); done < <(compgen -A "$files" -- "$current")
}
complete -F _moltact moltact
)";
  return script.str();
}

}  // namespace

void addCompletion(CLI::App& app) {
  CLI::App* command = app.add_subcommand("completion", "Print the bash completion of this program");
  command->group("");  // for packagers; not shown in the help
  command->callback([command] { out() << Lines{bashScript(programOf(*command))}; });
}

}  // namespace moltact
