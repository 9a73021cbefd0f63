// Keeps the documentation current: each command that a page shows is run in a quick form in a temporary folder.
// Commands that cannot be run are listed with a reason, and their options are checked against the command's --help.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/command_place.h"
#include "tests/core/source_tree.h"
#include "tests/results/sample_attempt.h"

namespace moltact::test {
namespace {

namespace fs = std::filesystem;

bool pageCommandsHas(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A command as a page has it, without what stands behind it to explain it.
struct Named {
  std::string command, where;
};

// Of inline code whole, of a block each line: "moltact info 1ubq", "./run.sh web", "build/release/test_fuzz".
std::vector<Named> commandsOf(const std::string& page, const std::string& text) {
  static const std::regex kCommand(R"(^(\./run\.sh|\./test\.sh|moltact|build/[a-z]+/[a-z_]+)( .*)?$)");
  static const std::regex kBehind(R"((  +|#).*$)"), kInline("`([^`]+)`");
  std::vector<Named> out;
  const auto take = [&](std::string command, std::size_t line) {
    if (command.starts_with("$ ")) command.erase(0, 2);
    if (!std::regex_match(command, kCommand)) return;
    const std::size_t quote = command.find_first_of("'\"");
    if (quote == std::string::npos) command = std::regex_replace(command, kBehind, "");
    while (command.ends_with(' ')) command.pop_back();
    out.push_back({command, page + ":" + std::to_string(line)});
  };
  std::istringstream lines(text);
  bool block = false;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.starts_with("```")) block = !block;
    if (block || line.starts_with("    ")) {
      take(line.substr(std::min(line.find_first_not_of(' '), line.size())), number);
      continue;
    }
    for (std::sregex_iterator it(line.begin(), line.end(), kInline), end; it != end; ++it) take((*it)[1], number);
  }
  return out;
}

const std::vector<Named>& allCommands() {
  static const std::vector<Named> all = [] {
    std::vector<fs::path> pages{"README.md", "CONTRIBUTING.md", "lessons/README.md", "molecules/README.md"};
    for (const auto& entry : fs::directory_iterator(kSource / "docs"))
      if (entry.path().extension() == ".md") pages.push_back(fs::relative(entry.path(), kSource));
    std::sort(pages.begin(), pages.end());
    std::vector<Named> out;
    for (const fs::path& page : pages)
      for (Named& one : commandsOf(page.generic_string(), textOf(kSource / page))) out.push_back(std::move(one));
    return out;
  }();
  return all;
}

// Replaces placeholders for the reader's own values.
std::string filledIn(std::string command) {
  for (const auto& [name, by] : {std::pair{"RESULTS…", "results"},
                                 {"FILE.jsonl", "a.jsonl"},
                                 {"FOLDER", "results"},
                                 {"MOLECULE", "1ubq"},
                                 {"LESSON", "my-lesson.md"},
                                 {"NAME RUN", "xyzr 1"}})
    if (const std::size_t at = command.find(name); at != std::string::npos)
      command.replace(at, std::string(name).size(), by);
  if (const std::size_t at = command.find(" check FILE"); at != std::string::npos)
    command.replace(at, 11, " check my-lesson.md");
  return command;
}

// Why a command is not run, by what it begins with.
const std::vector<std::pair<std::string, std::string>> kNotRun = {
    {"fetch", "it needs the network"},
    {"bench", "it takes minutes; tests/app/bench_command_test.cpp runs each part in short"},
    {"device check", "it wants a device in a hand; tests/app/device_command_test.cpp checks the simulated one"},
    {"class", "it serves until it is stopped; tests/classroom/class_server_test.cpp runs it"},
    {"imd ", "it opens the window and wants a server; tests/app/imd_window_test.cpp has one"},
    {"simulate", "it wants OpenMM and files of one's own; the package's trial runs it"},
    {"device record omni", "it wants that device"},
    {"check /usr/local", "the folder is an administrator's"},
    {"render capsid.cif", "the structure is downloaded"},
    {"info capsid.cif", "the structure is downloaded"},
    {"info md.xtc", "a trajectory of one's own"},
    {"render protein.gro", "a structure and a trajectory of one's own"},
    {"render 4ake", "the structure is downloaded"},
    {"grid 1hpv --around ligand --compare",
     "the maps of another program; tests/app/grid_command_test.cpp compares some"},
    {"info small.", "the file is made as the page tells, of gigabytes"},
    {"pack --html", "the name of an option, with no lesson"},
    {"check --play", "the name of an option, with no lesson"},
    {"forget", "the student of the pages has no attempts; tests/app/forget_command_test.cpp deletes one"},
    {"report --anonymous", "the name of an option, with no results"},
    {"report RESULTS --study", "the results are of no study; tests/study/simulated_class_test.cpp has one"}};

// What opens the window.
bool opensWindow(const std::string& arguments) {
  return arguments.empty() || (arguments.find(' ') == std::string::npos && arguments.find('.') != std::string::npos) ||
         arguments == "2hhb" || arguments.starts_with("--language") || arguments.starts_with("--device ") ||
         arguments.starts_with("-d ");
}

struct PagePlace : CommandPlace {
  PagePlace() {
    REQUIRE(run("new-lesson my-lesson --folder new").status == 0);
    fs::rename(folder / "new" / "my-lesson.md", folder / "my-lesson.md");
    fs::copy_file(folder / "my-lesson.md", folder / "lesson.md");
    fs::create_directory(folder / "lessons");
    fs::copy_file(kSource / "lessons/first-touch.md", folder / "lessons/first-touch.md");
    fs::copy_file(kSource / "lessons/glossary.md", folder / "lessons/glossary.md");
    fs::copy_file(kSource / "molecules/1ubq.pdb", folder / "molecule.pdb");
    fs::create_directories(folder / "docs/pictures");
    fs::create_directory(folder / "results");
    writeFile(folder / "results/a.jsonl", sampleFile());
    writeFile(folder / "a.jsonl", sampleFile());
    std::string path = "x,y,z\n";
    for (int k = 0; k < 100; ++k) path += "0,0," + std::to_string(40 - 0.4 * k) + "\n";
    writeFile(folder / "hip.csv", path);
    writeFile(folder / "edition.html",
              "<html><script id=\"platform-script\"></script><!--a lesson comes here--></html>");
    for (const char* name : {"a.recording", "mine.recording"})
      REQUIRE(run("device record simulated 1ubq --seconds 0.3 --out " + std::string(name)).status == 0);
    writeFile(folder / "plan.md", "---\ntitle: S\nstudy: s\ngroups:\n- hands -> touch: my-lesson\n---\n");
    writeFile(folder / "answers.txt", "next\n");
    writeFile(folder / "jabs.txt", "next\n");
  }
};

std::vector<std::string> optionsIn(const std::string& arguments) {
  static const std::regex kOption(R"((^| )(--[a-z][a-z-]*))");
  std::vector<std::string> out;
  // Text in quotes is a value.
  const std::string plain = std::regex_replace(arguments, std::regex(R"("[^"]*"|'[^']*')"), "x");
  for (std::sregex_iterator it(plain.begin(), plain.end(), kOption), end; it != end; ++it) out.push_back((*it)[2]);
  return out;
}

// "device check" of "device check omni".
std::string subcommandOf(const std::string& arguments) {
  std::istringstream words(arguments);
  std::string first, second;
  words >> first >> second;
  return first == "device" || first == "simulate" ? first + " " + second : first;
}

}  // namespace

TEST_CASE("what this test reads of a page: commands in inline code and in blocks, without what explains them") {
  const auto found = commandsOf("p.md",
                                "Say `moltact info 1ubq` or `moltact.html`.\n\n    ./run.sh web   # builds\n"
                                "```\n$ moltact render a --label '#x  y'\n```\n`ls`\n");
  REQUIRE(found.size() == 3);
  CHECK(found[0].command == "moltact info 1ubq");
  CHECK(found[1].command == "./run.sh web");
  CHECK(found[1].where == "p.md:3");
  CHECK(found[2].command == "moltact render a --label '#x  y'");
}

TEST_CASE(
    "every command of moltact that a page names runs, or is listed with its reason and has the options it is given") {
  const PagePlace place;
  std::set<std::string> done, reasons_met;
  std::size_t ran = 0;
  for (const Named& named : allCommands()) {
    std::string command = filledIn(named.command);
    std::string arguments;
    bool script = false;
    for (const std::string begin : {"moltact", "build/release/moltact", "./run.sh"})
      if (command == begin || command.starts_with(begin + " ")) {
        arguments = command.size() > begin.size() ? command.substr(begin.size() + 1) : "";
        script = true;
      }
    if (!script || arguments == "web" || arguments == "package") continue;  // tests/package and tests/web run those
    if (!done.insert(arguments).second) continue;
    CAPTURE(named.where);
    CAPTURE(arguments);
    if (opensWindow(arguments)) continue;
    if (arguments.find(" --screenshot ") != std::string::npos) {
      CHECK(place.run(arguments + " --size 200x160").status == 0);
      ++ran;
      continue;
    }
    const std::string subcommand = subcommandOf(arguments);
    const Run help = place.run(subcommand + " --help");
    CHECK(help.status == 0);
    for (const std::string& option : optionsIn(arguments)) CHECK_MESSAGE(pageCommandsHas(help.out, option), option);
    const auto reason =
        std::find_if(kNotRun.begin(), kNotRun.end(), [&](const auto& r) { return arguments.starts_with(r.first); });
    if (reason != kNotRun.end()) {
      reasons_met.insert(reason->first);
      continue;
    }
    if (arguments == subcommand) continue;  // the command's name
    // A smaller picture, one step of a lesson of which every step is tried elsewhere, and the page of the test.
    arguments = std::regex_replace(arguments, std::regex("--size [0-9x]+"), "--size 64x64");
    if (arguments.starts_with("study ") || (arguments.starts_with("pack ") && (pageCommandsHas(arguments, "--html") ||
                                                                               pageCommandsHas(arguments, "--scorm") ||
                                                                               pageCommandsHas(arguments, "--cmi5"))))
      arguments += " --page edition.html";
    if (arguments == "check lessons") arguments = "check lessons/first-touch.md";
    if (arguments == "check results") arguments = "check new";
    if (arguments == "new-lesson my-lesson") arguments += " --folder new";
    const Run run = place.run(arguments);
    ++ran;
    // The scripted answers here are no answers: the lesson is not finished.
    if (pageCommandsHas(arguments, " --answers "))
      CHECK_MESSAGE(pageCommandsHas(run.out + run.err, "not finished"), run.err);
    else
      CHECK_MESSAGE(run.status == 0, run.err);
  }
  CHECK(ran >= 25);
  for (const auto& [begin, reason] : kNotRun)
    CHECK_MESSAGE(reasons_met.contains(begin), begin, " is on no page any more; take it from the list");
}

TEST_CASE("every build, preset and test case that a page names with ./test.sh or build/ is there") {
  const std::string presets = textOf(kSource / "CMakePresets.json") + textOf(kSource / "test.sh");
  std::string lists, tests;
  for (const char* top : {"CMakeLists.txt", "app", "engine", "tests"})
    for (const fs::path path = kSource / top; const auto& file : [&] {
           std::vector<fs::path> files;
           if (fs::is_regular_file(path))
             files.push_back(path);
           else
             for (const auto& entry : fs::recursive_directory_iterator(path))
               if (entry.path().filename() == "CMakeLists.txt" || entry.path().extension() == ".cpp")
                 files.push_back(entry.path());
           return files;
         }())
      (file.extension() == ".cpp" ? tests : lists) += textOf(file);
  // A title may go over several literals.
  tests = std::regex_replace(tests, std::regex("\"\\s*\n\\s*\""), "");
  std::size_t met = 0;
  for (const Named& named : allCommands()) {
    CAPTURE(named.where);
    CAPTURE(named.command);
    std::istringstream words(named.command);
    std::string first;
    words >> first;
    if (first == "./test.sh") {
      for (std::string preset; words >> preset; ++met)
        CHECK_MESSAGE(
            (pageCommandsHas(presets, "\"" + preset + "\"") || pageCommandsHas(presets, "= " + preset + " ]")), preset);
    } else if (first.starts_with("build/")) {
      const std::string program = first.substr(first.rfind('/') + 1);
      const std::string bare = program.starts_with("test_") ? "NAME " + program.substr(5) : program;
      CHECK_MESSAGE((pageCommandsHas(lists, bare) || pageCommandsHas(lists, program) || program == "moltact"), program);
      ++met;
      const std::size_t filter = named.command.find("-tc=");
      if (filter == std::string::npos) continue;
      std::string title = named.command.substr(filter + 4);
      title = title.substr(0, title.find(title[0] == '\'' ? "'" : " ", 1));
      if (title.starts_with('\'')) title.erase(0, 1);
      while (title.ends_with('*')) title.pop_back();
      CHECK_MESSAGE((pageCommandsHas(tests, "\"" + title) || pageCommandsHas(tests, "TEST_CASE(\"" + title)), title);
    }
  }
  CHECK(met > 20);
}

}  // namespace moltact::test
