// Every command that writes a file: on a full disk, beyond a file size limit, and with an existing file. Oracle: the
// bytes before, and a listing of the folder.
#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <filesystem>
#include <vector>

#include "tests/app/command_place.h"
#include "tests/results/sample_attempt.h"

namespace moltact::test {
namespace {

namespace fs = std::filesystem;

struct Case {
  std::string arguments;  ///< writes small/FILE
  std::string file;
  bool replaces = true;  ///< what is there is replaced; else refused
};

std::vector<Case> cases() {
  return {{"report a.jsonl --csv small/x.csv", "x.csv"},
          {"report a.jsonl --html small/x.html", "x.html"},
          {"export 1ubq small/x.glb", "x.glb"},
          {"replay 1ubq --path path.csv --out small/x.csv", "x.csv"},
          {"render 1ubq --size 400x300 --out small/x.png", "x.png"},
          {"new-lesson x --folder small", "x.md", false},
          {"bench feel --quick --methods penalty --json small/x.json", "x.json"},
          {"bench feel --quick --methods penalty --markdown small/x.md", "x.md"},
          {"device record simulated 1ubq --seconds 0.6 --out small/x.recording", "x.recording", false},
          {"device record simulated 1ubq --seconds 0.6 --overwrite --out small/x.recording", "x.recording"},
          {"fetch 5adh --again --url \"file://$PWD/5adh.pdb.gz\"", "moltact/molecules/5ADH.cif.gz"},
          {"1ubq --screenshot small/x.png", "x.png"}};
}

void prepare(const CommandPlace& place) {
  fs::create_directory(place.folder / "small");
  writeFile(place.folder / "a.jsonl", sampleFile());
  std::string path = "x,y,z\n";
  for (int k = 0; k < 400; ++k) path += "0,0," + std::to_string(40 - 0.1 * k) + "\n";
  writeFile(place.folder / "path.csv", path);
  fs::copy_file(MOLTACT_SOURCE_DIR "/molecules/1ubq.pdb", place.folder / "5adh.pdb.gz");
}

TEST_CASE(
    "on a full disk every command that writes fails with a message, and keeps what was there, with nothing beside it") {
  const CommandPlace place;
  prepare(place);
  // A disk of the test's own in a view of the system of its own; "$0" is the program.
  const std::string fill =
      "mkdir -p \"$(dirname small/$FILE)\"; [ -z \"$OLD\" ] || printf older >small/$FILE; head -c 100000 /dev/zero "
      ">small/fill 2>/dev/null; ";
  const std::string list =
      "; s=$?; cat small/$FILE >kept 2>/dev/null; find small -type f | sort >listing; umount small; exit $s";
  if (place.run("--version", "unshare -m sh -c 'mount -t tmpfs -o size=16k tmpfs small && \"$0\" \"$@\"'").status !=
      0) {
    MESSAGE("left out: no disk may be mounted here");
    return;
  }
  for (const Case& c : cases())
    for (const bool old : {false, true}) {
      CAPTURE(c.arguments);
      CAPTURE(old);
      fs::remove(place.folder / "kept");
      const std::string before =
          "export MOLTACT_HOME='" MOLTACT_SOURCE_DIR "' XDG_DATA_HOME=\"$PWD/small\" FILE=" + c.file +
          " OLD=" + (old ? "1" : "") + "; unshare -m sh -c 'mount -t tmpfs -o size=16k tmpfs small || exit 99; " +
          fill + "\"$0\" \"$@\"" + list + "'";
      const Run run = place.run(c.arguments, before);
      CHECK_MESSAGE(run.status == 1, run.status, run.out, run.err);
      const bool refused = old && !c.replaces;
      CHECK_MESSAGE((run.err + run.out).find(refused ? "already" : "the disk is full") != std::string::npos, run.err,
                    run.out);
      CHECK(contents(place.folder / "kept") == (old ? "older" : ""));
      CHECK(contents(place.folder / "listing") ==
            (old ? (c.file < "fill" ? "small/" + c.file + "\nsmall/fill\n" : "small/fill\nsmall/" + c.file + "\n")
                 : "small/fill\n"));
    }
}

TEST_CASE(
    "past a limit on the size of files every command that writes fails with a message, and keeps what was there") {
  for (const Case& c : cases()) {
    if (c.file.find('/') != std::string::npos) continue;  // a fetched entry has its own folder; the way is the same
    const CommandPlace place;
    prepare(place);
    CAPTURE(c.arguments);
    const bool refuse = !c.replaces;
    if (!refuse) writeFile(place.folder / "small" / c.file, "older");
    const Run run = place.run(c.arguments, "export MOLTACT_HOME='" MOLTACT_SOURCE_DIR "'; ulimit -f 1;");
    if (run.status == 0) {
      // Small enough: a table of one student.
      CHECK(fs::file_size(place.folder / "small" / c.file) <= 1024);
      continue;
    }
    CHECK_MESSAGE(run.status == 1, run.status, run.err);
    CHECK_MESSAGE((run.err + run.out).find("larger than files may be here") != std::string::npos, run.err, run.out);
    CHECK(contents(place.folder / "small" / c.file) == (refuse ? "" : "older"));
    CHECK(std::distance(fs::directory_iterator(place.folder / "small"), {}) == (refuse ? 0 : 1));
  }
}

TEST_CASE("a fetch that is broken off leaves nothing and ends with 130") {
  // A server that takes the connection and says nothing.
  const int server = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  REQUIRE(::bind(server, reinterpret_cast<sockaddr*>(&address), size) == 0);
  REQUIRE(::listen(server, 4) == 0);
  REQUIRE(::getsockname(server, reinterpret_cast<sockaddr*>(&address), &size) == 0);
  const CommandPlace place;
  const std::string url = "http://127.0.0.1:" + std::to_string(ntohs(address.sin_port)) + "/5ADH.cif.gz";
  // A shell's background jobs ignore SIGINT; SIGTERM is the same wish.
  place.run("fetch 5adh --url " + url +
                " 2>fetch.err & P=$!; sleep 2; kill -TERM $P; wait $P; echo $? >status; find data -type f",
            "export XDG_DATA_HOME=\"$PWD/data\"; ");
  ::close(server);
  CHECK(contents(place.folder / "status") == "130\n");
  CHECK(contents(place.folder / "run.out").empty());
  CHECK(contents(place.folder / "fetch.err") == "moltact: 5ADH: broken off; nothing was kept of it\n");
}

TEST_CASE("with a relative home nothing is made in the folder one stands in, and the message names the variables") {
  const CommandPlace place;
  prepare(place);
  const Run run = place.run("fetch 5adh --url \"file://$PWD/5adh.pdb.gz\"", "unset XDG_DATA_HOME; export HOME=here;");
  CHECK(run.status == 1);
  CHECK(run.err.find("set HOME or XDG_DATA_HOME") != std::string::npos);
  CHECK_FALSE(fs::exists(place.folder / "here"));
}

}  // namespace
}  // namespace moltact::test
