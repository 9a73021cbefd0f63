// `moltact class`: serves the browser edition and lessons to a room, and shows the teacher who is where.
#include <chrono>
#include <filesystem>
#include <memory>

#include "app/commands/command.h"
#include "app/commands/value_types.h"
#include "engine/classroom/class_folder.h"
#include "engine/classroom/live_class.h"
#include "engine/language/catalogue.h"
#include "engine/platform/folders.h"
#include "engine/platform/interrupt.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct ClassArguments {
  std::vector<std::string> lessons;
  std::string folder, page;
  bool share = false;
  int port = -1;
};

std::string goOnCommand(const fs::path& folder) { return "moltact class --folder '" + folder.string() + "'"; }

// After a crash, whoever types the first command again begins another class, which no student's page knows.
void tellOfOpenClass(const fs::path& classes) {
  const std::string oldest = classFolderName(std::chrono::system_clock::now() - std::chrono::hours(12));
  fs::path newest;
  std::error_code error;
  for (const fs::directory_entry& one : fs::directory_iterator(classes, error))
    if (one.path().filename().string() > oldest && one.path() > newest) newest = one.path();
  if (newest.empty() || !classIsOpen(newest)) return;
  out()
      << tr("This is a new class. An earlier one of the last 12 hours was not ended. To go on with that one, stop this "
            "one with Ctrl+C and give the command:")
      << "\n\n    " << goOnCommand(newest) << "\n\n";
}

void tellTeacher(const LiveClassNews& news, const LiveClassOptions& options) {
  if (news.kind == LiveClassNews::Kind::Note) {
    err() << "moltact: " << trf("note: {0}", news.text) << '\n';
    return;
  }
  if (news.kind == LiveClassNews::Kind::Started) {
    if (news.resumed)
      out() << trnf("The class goes on, with {0} student.", "The class goes on, with {0} students.", news.students,
                    news.students)
            << '\n';
    if (news.ended) out() << tr("It has ended: nobody can join, and late work still arrives.") << '\n';
    out() << '\n' << tr("Students open:") << "\n\n    " << news.address << "\n\n";
    if (!news.others.empty()) {
      out() << tr("If that address does not answer, this computer has others:") << "\n\n";
      for (const std::string& other : news.others) out() << "    " << other << '\n';
      out() << '\n';
    }
    if (news.alone)
      out()
          << tr("This computer is in no network now, so that nobody else reaches the class. Connect it, and start the "
                "command again with this class's folder.")
          << '\n';
    else if (news.shared)
      out() << Lines{news.qr} << '\n'
            << tr("Shared: every computer and telephone in this network reaches the class, and whoever has the address "
                  "can join it. The connection is not encrypted: others in the network can read names and answers.")
            << '\n';
    else
      out() << tr("Only this computer reaches the class. With --share, the computers and telephones in the network do.")
            << '\n';
    out() << '\n' << tr("You open, and tell nobody:") << "\n\n    " << news.teacher << "\n\n";
    out() << trf("What students do is kept in {0}", options.folder.string()) << '\n';
    out() << tr("Stop with Ctrl+C.") << '\n';
    out().flush();
    return;
  }
  out() << '\n';
  if (!news.report.empty()) out() << trf("Report: {0}", news.report.string()) << '\n';
  if (!news.ended) out() << trf("To go on with this class: {0}", goOnCommand(fs::absolute(options.folder))) << '\n';
}

void run(const ClassArguments& arguments) {
  LiveClassOptions options;
  options.lessons = arguments.lessons;
  options.page = arguments.page.empty() ? browserEdition() : fs::path(arguments.page);
  options.share = arguments.share;
  options.port = arguments.port;
  if (options.page.empty())
    throw CommandError{tr(
        "there is no browser edition here for the students; make it with './run.sh web', or name a moltact.html with "
        "--page")};
  if (arguments.folder.empty()) {
    if (userDataFolder().empty())
      throw CommandError{tr("this computer names no folder for the class; name one with --folder")};
    options.folder = userDataFolder() / "classes" / classFolderName(std::chrono::system_clock::now());
    tellOfOpenClass(options.folder.parent_path());
  } else {
    options.folder = arguments.folder;
  }
  const InterruptWatch watch;
  const auto problem = runLiveClass(
      options, [&](const LiveClassNews& news) { tellTeacher(news, options); }, [&] { return watch.seen(); });
  if (problem) throw CommandError{problem->text()};
}

}  // namespace

void addClass(CLI::App& app) {
  auto arguments = std::make_shared<ClassArguments>();
  CLI::App* command = app.add_subcommand(
      "class", "Serve lessons to the browsers of a class, and show the teacher who is where (docs/live-class.md)");
  command
      ->add_option("lessons", arguments->lessons,
                   "Lessons (.md), packs (.moltact) or names of the program's lessons; none: all of the program's")
      ->type_name("FILE|NAME");
  command->add_flag("--share", arguments->share,
                    "Let other computers in the network join; without it, only this computer can");
  command
      ->add_option("--folder", arguments->folder,
                   "Folder of the class; a class that was begun there goes on (default: a new one in the user's data)")
      ->type_name(kFolderType);
  command
      ->add_option("--port", arguments->port,
                   "Port of the address (default: 8230, or any free one; a class that goes on keeps its port)")
      ->check(CLI::Range(0, 65535));
  command
      ->add_option("--page", arguments->page,
                   "The browser edition to serve (default: the moltact.html that was built or installed)")
      ->type_name(kFileType);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace moltact
