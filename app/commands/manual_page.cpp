// moltact manual-page: prints the manual page moltact(1) from the same tables as --help. The output is roff, the format
// of man(1).
#include <sstream>

#include "app/commands/command.h"
#include "app/commands/command_tree.h"
#include "app/commands/language_option.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

// Escapes backslashes, hyphens and a line's first character, which have a special meaning in roff.
std::string roff(const std::string& text) {
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool begins_line = k == 0 || text[k - 1] == '\n';
    if (begins_line && (text[k] == '.' || text[k] == '\'')) out += "\\&";
    if (text[k] == '\\')
      out += "\\e";
    else if (text[k] == '-')
      out += "\\-";
    else if (text[k] == '\n')
      out += "\n.br\n";
    else if (begins_line && text[k] == ' ')
      out += "\\ ";  // a plain blank there would break the line
    else
      out += text[k];
  }
  return out;
}

// "-o,--out FILE REQUIRED" as in --help; an argument's name is in italics. A long list of choices may break at a comma.
std::string headOf(const CLI::Option& option) {
  const std::string name = roff(option.get_name(option.get_positional(), true));
  std::string takes = roff(CLI::Formatter().make_option_opts(&option));
  for (std::size_t at = takes.find(','); at != std::string::npos; at = takes.find(',', at + 1))
    takes.insert(at + 1, "\\:");
  return (option.get_positional() ? "\\fI" : "\\fB") + name + "\\fR" + takes;
}

void putOptions(std::ostream& page, const CLI::App& command) {
  for (const Wanted wanted : {Wanted::Arguments, Wanted::Options})
    for (const CLI::Option* option : shownOptions(command, wanted)) {
      if (command.get_parent() && option == command.get_help_ptr()) continue;  // described once, for the program
      page << ".TP\n" << headOf(*option) << '\n' << roff(option->get_description()) << '\n';
    }
}

// Writes the name and the arguments in one line, the description and the options; then the same for the subcommands.
void putCommand(std::ostream& page, const CLI::App& command) {
  page << ".SS \"" << roff(fullName(command));
  for (const CLI::Option* argument : shownOptions(command, Wanted::Arguments))
    page << ' ' << roff(argument->get_name(true)) << (argument->get_items_expected_max() > 1 ? " ..." : "");
  page << "\"\n" << roff(command.get_description()) << ".\n";
  putOptions(page, command);
  for (const CLI::App* inner : shownCommands(command)) putCommand(page, *inner);
}

// The sections that no option describes. The paths are those of engine/platform/folders.h and
// app/ui/files/user_folders.h.
constexpr const char* kEnvironment = R"(.SH ENVIRONMENT
.TP
.B MOLTACT_LANGUAGE
The language of the output, )";
constexpr const char* kRest = R"(, unless
.B \-\-language
gives it. The default is the language of the system.
.TP
.B MOLTACT_HOME
The folder of the program's molecules, lessons and assets, if it is not that of the installation.
.TP
.B MOLTACT_LIBHD
The driver's file libHD.so for an Omni or Touch, if the system does not find it.
.TP
.BR XDG_CONFIG_HOME ", " XDG_DATA_HOME ", " XDG_CACHE_HOME
The base folders of the files below.
.TP
.B XDG_DATA_DIRS
The folders in which lessons for all users are searched: in
.I moltact/lessons
of each folder; without it of
.I /usr/local/share
and
.IR /usr/share .
.SH FILES
.TP
.I ~/.config/moltact/settings.json
Preferences.
.TP
.I ~/.local/share/moltact/attempts
What was done in lessons, a file for each attempt.
.TP
.I ~/.local/share/moltact/lessons
Lessons of one's own; the preferences may name another folder.
.TP
.I ~/.local/share/moltact/packs
Lessons from packs that were opened.
.TP
.I ~/.local/share/moltact/molecules
Downloaded entries of the Protein Data Bank.
.TP
.I ~/.cache/moltact
Data that the program can create again.
.TP
.I /usr/local/share/moltact/lessons
Lessons for everyone on this computer.
.SH EXIT STATUS
0: what was asked for is done. 1: it could not be done, or is wrong; a message says what. 2: the command line is wrong.
.B moltact device check
also gives 3 where nothing was checked, and 130 where it was broken off.
.SH EXAMPLES
.TP
.B moltact
opens the window, with its lessons.
.TP
.B moltact 1ubq
opens ubiquitin in it.
.TP
.B moltact render 1ubq \-\-out picture.png \-\-hip 30,29,22
draws ubiquitin, and a probe pushed against it.
.TP
.B moltact report results \-\-csv class.csv \-\-html class.html
reports on a class.
)";

std::string manualPage(const CLI::App& program) {
  std::ostringstream page;
  page << ".TH MOLTACT 1 \"\" \"moltact " << MOLTACT_VERSION << "\" \"User Commands\"\n.ad l\n.nh\n"
       << ".SH NAME\nmoltact \\- learn structural biology by touching molecules\n"
       << ".SH SYNOPSIS\n.B moltact\n[\\fIoptions\\fR] [\\fIfile\\fR]\n.br\n.B moltact\n\\fIcommand\\fR "
          "[\\fIoptions\\fR] "
          "[\\fIarguments\\fR]\n"
       << ".SH DESCRIPTION\n"
          "Without a command a window opens. A student works through a guided lesson and pushes a probe against a\n"
          "molecule, with a force\\-feedback stylus, a mouse or a keyboard. The commands need no display.\n"
       << ".SH OPTIONS\n";
  putOptions(page, program);
  page << ".SH COMMANDS\n";
  for (const CLI::App* command : shownCommands(program)) putCommand(page, *command);
  page << kEnvironment << languageCodes(" or ") << kRest;
  return page.str();
}

}  // namespace

void addManualPage(CLI::App& app) {
  CLI::App* command = app.add_subcommand("manual-page", "Print the manual page, moltact(1)");
  command->group("");  // for packagers; not shown in the help
  command->callback([command] { out() << Lines{manualPage(programOf(*command))}; });
}

}  // namespace moltact
