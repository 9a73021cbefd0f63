// Names and texts with terminal control characters, wherever a command could print them. Oracle: the bytes of the
// output.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "engine/core/printable.h"
#include "tests/app/command_place.h"
#include "tests/results/sample_attempt.h"

namespace moltact::test {
namespace {

namespace fs = std::filesystem;

// A title of the window, a cleared screen, C1 as UTF-8 and as a byte, DEL, a turned direction, and a line of its own.
const std::string kText =
    "\x1b]0;owned\x07\x1b[2J\xc2\x9b"
    "31m\x7f\xe2\x80\xae"
    "evil";
const std::string kName = kText +
                          "\x9b"
                          "5n\nforged";

// Empty, or what is wrong with it.
std::string fault(std::string_view printed) {
  for (std::size_t at = 0; at < printed.size();) {
    const CodePoint c = firstCodePoint(printed.substr(at));
    if (!c.valid) return "a byte that is no UTF-8 at " + std::to_string(at);
    if (isTerminalControl(c.code)) return "code point " + std::to_string(c.code) + " at " + std::to_string(at);
    at += c.bytes;
  }
  if (printed.starts_with("forged") || printed.find("\nforged") != std::string_view::npos) return "a forged line";
  return {};
}

std::string atom(int serial, const char* record, const std::string& residue, char chain, int number, double x) {
  char line[100];
  std::snprintf(line, sizeof line, "%-6s%5d  C   %3s %c%4d    %8.3f%8.3f%8.3f  1.00  0.00           C\n", record,
                serial, residue.c_str(), chain, number, x, 0.0, 0.0);
  return line;
}

const std::string kPdb = "HEADER    X                                       01-JAN-00   1EVL\nTITLE     " + kText +
                         "\n" + atom(1, "ATOM", "ALA", '\x1b', 1, 0.0) + atom(2, "HETATM", "\x1b[2", '\x07', 2, 4.0);
const std::string kCif =
    "data_"
    "X\n_struct.title\n;\n" +
    kText +
    "\nforged\n;\nloop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.auth_asym_id\n_atom_site.auth_comp_"
    "id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\nHETATM C '" +
    kText + "' '" + kText + "' 0 0 0\nHETATM N '" + kText + "' '" + kText + "' 2 0 0\n";

const std::string kLesson = "---\ntitle: " + kText + "\nmolecule: " + "own.pdb\n---\n\n# " + kText + "\n\nText " +
                            kText + "\n\n## Question: " + kText + "?\n\n- [ ] " + kText + " a\n- [x] " + kText +
                            " b\n\n```" + kText + "\nkey " + kText + ": 1\n```\n";

std::string newLesson(const CommandPlace& place) {
  place.run("new-lesson 'A good one' --folder made");
  return contents(place.folder / "made" / "a-good-one.md");
}

std::string quoted(const std::string& word) { return "'" + word + "'"; }

TEST_CASE("every command, given hostile names and files, prints no control characters and no forged line") {
  const CommandPlace place;
  const fs::path& at = place.folder;
  const auto put = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(at / name, std::ios::binary) << bytes;
  };
  put(kName + ".pdb", kPdb);
  put(kName + ".cif", kCif);
  put("own.pdb", kPdb);
  put("bad.pdb", "ATOM  " + kText + "\n");
  put("bad.cif", "data_x\nloop_\n_" + kText + "\n'" + kText + "\n");
  put("bad.xyzr", kText + " 0 0\n");
  put(kName + ".md", kLesson);
  put("good.md", newLesson(place));
  put(kName + ".txt", "answer " + kText + ": " + kText + "\nsay " + kText + "\n" + kText + "\n");
  put(kName + ".csv", "x,y,z\n0,0,30\n0,0,20\n");
  put("bad.csv", "x,y,z\n" + kText + "\n");
  put(kName + ".jsonl", sampleFile() + "{\"kind\":\"" + "hint\",\"t\":1,\"step\":2}\n" + kText + "\n");
  put("b.jsonl", kText);
  put(kName + ".recording", "MOLTACT TRACE" + kText);
  put(kName + ".script", kText + "\n");
  fs::create_directory(at / (kName + " folder"));
  put(kName + " folder/" + kName + ".md", kLesson);
  put(kName + " folder/README.md", "nothing");
  const std::string evil = quoted(kName);
  const auto file = [&](const char* ending) { return quoted(kName + ending); };
  int tried = 0, replaced = 0;
  for (const std::string& arguments :
       std::vector<std::string>{evil,
                                "--" + evil,
                                evil + " --screenshot /none/" + file(".png"),
                                "--screenshot x.png --script " + file(".script"),
                                "--screenshot x.png --script " + evil,
                                "--screenshot x.png --size " + evil,
                                file(".md") + " --screenshot x.png --state-text -",
                                "--screenshot x.png --state-text /none/" + evil,
                                "info " + evil,
                                "info " + file(".pdb"),
                                "info " + file(".cif"),
                                "info --json " + file(".pdb"),
                                "info --json " + file(".cif"),
                                "info bad.pdb",
                                "info bad.cif",
                                "info bad.xyzr",
                                "info own.pdb --assembly " + evil,
                                "info own.pdb --model " + evil,
                                "replay " + file(".pdb") + " --path " + file(".csv") + " --out /none/" + evil,
                                "replay own.pdb --path " + evil + " --time",
                                "replay own.pdb --path bad.csv --time",
                                "replay own.pdb --path " + file(".csv") + " --time --method " + evil,
                                "play " + file(".md") + " --demonstrate",
                                "play " + evil + " --demonstrate",
                                "play good.md --answers " + file(".txt"),
                                "play good.md --answers " + evil,
                                "play --json " + file(".md") + " --demonstrate",
                                "check " + file(".md"),
                                "check " + evil,
                                "check " + file(" folder"),
                                "check --json " + file(".md"),
                                "check --json " + file(" folder"),
                                "render own.pdb --out /none/" + evil,
                                "render own.pdb --out x.png --size " + evil,
                                "render own.pdb --out x.png --hip " + evil,
                                "render own.pdb --out x.png --show " + evil,
                                "export " + file(".pdb") + " " + file(".glb"),
                                "export own.pdb " + evil,
                                "export own.pdb /none/" + file(".glb"),
                                "fetch " + evil,
                                "fetch 5adh --url file:///none/" + evil,
                                "fetch 5adh --url " + evil,
                                "fetch 5adh --url \"file://$PWD/own.pdb\"",
                                "report " + file(".jsonl") + " b.jsonl " + evil + " --csv " + file("-out.csv"),
                                "report b.jsonl --csv x.csv",
                                "report " + file(".jsonl") + " --html /none/" + evil,
                                "bench feel --methods " + evil,
                                "bench feel --docs " + evil,
                                "bench feel --json /dev/null/" + evil,
                                "bench " + evil,
                                "devices",
                                "devices --json",
                                "device check " + evil,
                                "device record " + evil + " own.pdb --out x.recording",
                                "device record simulated " + evil + " --out x.recording",
                                "device record simulated own.pdb --seconds 0.1 --out " + file("-new.recording"),
                                "device replay " + file(".recording"),
                                "device replay " + evil,
                                "device replay " + file("-new.recording"),
                                "new-lesson " + evil,
                                "new-lesson " + quoted(kText),
                                "new-lesson name --folder " + file("-lessons"),
                                "new-lesson name --folder " + file(".md"),
                                "pack " + evil,
                                "pack " + file(".md"),
                                "pack " + file(".md") + " -o " + evil,
                                "info " + file(".md"),
                                "info --json " + file(".md"),
                                "lesson-reference",
                                "lesson-reference " + evil}) {
    const Run run = place.run(arguments, "env MOLTACT_LIBHD=" + quoted("/none/" + kName + ".so") +
                                             " HOME=" + quoted(at.string() + "/" + kName));
    CAPTURE(arguments);
    CAPTURE(run.status);
    CHECK_MESSAGE(fault(run.out).empty(), fault(run.out), ": ", printable(run.out));
    CHECK_MESSAGE(fault(run.err).empty(), fault(run.err), ": ", printable(run.err));
    CHECK(run.err.find("it could not go on") == std::string::npos);
    CHECK((run.status >= 0 && run.status < 126));
    if (arguments.find("--json ") != std::string::npos && run.status == 0 && !run.out.empty())
      CHECK(nlohmann::json::accept(run.out));
    ++tried;
    replaced += (run.out + run.err).find(kReplacement) != std::string::npos;
  }
  MESSAGE(tried << " commands, " << replaced << " of them printed hostile text");
  CHECK(tried > 60);
  CHECK(replaced > 40);
  // What could not be shown is in the JSON all the same.
  const Run info = place.run("info --json " + file(".cif"));
  REQUIRE(info.status == 0);
  CHECK(nlohmann::json::parse(info.out)["chain_names"][0] == kText);
  const Run play = place.run("play --json good.md --answers " + file(".txt"));
  CHECK(play.status == 1);
  REQUIRE(place.run("check --json " + file(".md")).status == 1);
  CHECK(nlohmann::json::parse(place.run("check --json " + file(".md")).out)["problems"][0]["file"]
            .get<std::string>()
            .find("\x1b]0;owned") == 0);
}

TEST_CASE("what is piped into a full disk or past a limit on files is reported, and the status is not 0") {
  const CommandPlace place;
  const Run full = place.run("lesson-reference >/dev/full; echo $? >status; true");
  CHECK(contents(place.folder / "status") == "1\n");
}

// The same by the sources: no other code writes to the terminal or writes whole files.
TEST_CASE(
    "in app and engine only engine/platform/terminal_linux.cpp writes to the terminal, and only engine/platform opens "
    "files for writing") {
  const std::regex terminal(
      R"(std::(cout|cerr|clog|wcout|puts|putchar|printf|fprintf|vprintf|fputs|print|println)\b|\b(printf|fprintf|puts|putchar|perror)\s*\(|\bstd(out|err)\b|STD(OUT|ERR)_FILENO)");
  const std::regex files(
      R"(\bofstream\b|std::fstream\b|\bfopen\s*\(|fs::rename\b|filesystem::rename\b|std::rename\b|fs::copy_file\b|O_WRONLY|O_RDWR|O_CREAT)");
  std::size_t looked_at = 0;
  std::string found;
  for (const char* room : {"app", "engine"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(MOLTACT_SOURCE_DIR) / room)) {
      const fs::path& file = entry.path();
      if (file.extension() != ".cpp" && file.extension() != ".h") continue;
      ++looked_at;
      std::ifstream in(file);
      std::string line;
      const bool platform = file.parent_path().filename() == "platform";
      for (int number = 1; std::getline(in, line); ++number) {
        const std::string code = line.substr(0, line.find("//"));
        if ((!platform && std::regex_search(code, terminal)) || (!platform && std::regex_search(code, files)))
          found += file.string() + ":" + std::to_string(number) + ": " + line + "\n";
      }
    }
  CHECK(looked_at > 400);
  CHECK_MESSAGE(found.empty(), found);
}

}  // namespace
}  // namespace moltact::test
