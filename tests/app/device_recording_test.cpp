// `moltact device record` and `moltact device replay` as users call them.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>

#include "tests/app/command_place.h"

namespace {

namespace fs = std::filesystem;
using namespace moltact::test;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The bytes before the first block: magic, three lengths, what they count, checksum.
std::size_t headBytes(const std::string& file) {
  std::uint32_t lengths[3];
  std::memcpy(lengths, file.data() + 8, sizeof lengths);
  return 8 + sizeof lengths + lengths[0] + lengths[1] + lengths[2] + 4;
}

}  // namespace

TEST_CASE("a hand of 1 s recorded on ubiquitin replays to the last bit") {
  const CommandPlace place;
  const Run record = place.run("device record simulated 1ubq --seconds 1 --out a.recording");
  REQUIRE_MESSAGE(record.status == 0, record.err);
  CHECK(contains(record.out, "1000 ticks (1.00 s) in a.recording"));
  const Run replay = place.run("device replay a.recording");
  CHECK_MESSAGE(replay.status == 0, replay.err);
  CHECK(contains(replay.out, "1000 ticks: the same forces and torques to the last bit"));
}

TEST_CASE(
    "a recording stores how its molecule was read: with waters, another model or assembly, another "
    "folder; and reports a change of it") {
  const CommandPlace place;
  fs::create_directories(place.folder / "elsewhere");
  const auto write = [&](double x) {
    std::ofstream file(place.folder / "own.pdb");
    char line[100];
    // Assembly 1: the chain and the chain turned round z and put 9 A aside.
    file << "REMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n";
    for (int copy = 1; copy <= 2; ++copy)
      for (int row = 1; row <= 3; ++row) {
        const double turned = copy == 2 && row < 3 ? -1.0 : 1.0;
        std::snprintf(line, sizeof line, "REMARK 350   BIOMT%d %3d %9.6f %9.6f %9.6f %14.5f\n", row, copy,
                      row == 1 ? turned : 0.0, row == 2 ? turned : 0.0, row == 3 ? turned : 0.0,
                      copy == 2 && row == 2 ? 9.0 : 0.0);
        file << line;
      }
    for (int model = 1; model <= 2; ++model) {
      file << "MODEL        " << model << '\n';
      for (int k = 0; k < 3; ++k) {
        const char* const residue = k == 2 ? "HOH" : "GLY";
        std::snprintf(line, sizeof line, "%s%5d  %s  %s A%4d    %8.3f%8.3f%8.3f  1.00  0.00           %s\n",
                      k == 2 ? "HETATM" : "ATOM  ", k + 1, k == 2 ? "O " : "CA", residue, k + 1, x * model + 3.0 * k,
                      0.0, 0.0, k == 2 ? "O" : "C");
        file << line;
      }
      file << "ENDMDL\n";
    }
  };
  write(1.0);
  for (const char* how : {"", "--waters", "--model 2", "--model 2 --waters", "--assembly 1"}) {
    CAPTURE(how);
    const Run record = place.run(std::string("device record simulated own.pdb ") + how +
                                 " --seconds 0.3 --overwrite --out a.recording");
    REQUIRE_MESSAGE(record.status == 0, record.err);
    CHECK(contains(record.out, "300 ticks (0.30 s)"));
    const Run replay = place.run("device replay ../a.recording", "cd elsewhere;");
    CHECK_MESSAGE(replay.status == 0, replay.err);
  }
  const Run record = place.run("device record simulated 1hpv --waters --seconds 0.3 --overwrite --out a.recording");
  REQUIRE_MESSAGE(record.status == 0, record.err);
  CHECK(place.run("device replay a.recording").status == 0);
  CHECK(contains(contents(place.folder / "a.recording"), "molecule=1hpv\n"));

  CHECK(place.run("device record simulated own.pdb --seconds 0.3 --overwrite --out a.recording").status == 0);
  write(1.5);
  const Run other = place.run("device replay a.recording");
  CHECK(other.status == 1);
  CHECK(contains(other.err, "a.recording: the molecule"));
  CHECK(contains(other.err, "own.pdb\" is not the one any more that it was recorded on"));
}

TEST_CASE(
    "half of a recording is replayed to its end, and its file is named as incomplete, with status 1; "
    "one without ticks and a text fail") {
  const CommandPlace place;
  REQUIRE(place.run("device record simulated 1ubq --seconds 1 --out a.recording").status == 0);
  const fs::path file = place.folder / "a.recording";
  fs::resize_file(file, fs::file_size(file) / 2);
  const Run half = place.run("device replay a.recording");
  CHECK(half.status == 1);
  CHECK(contains(half.out, " ticks: the same forces and torques to the last bit"));
  CHECK(contains(half.err, "a.recording: the recording is truncated after 0."));
  fs::resize_file(file, headBytes(contents(file)));
  const Run empty = place.run("device replay a.recording");
  CHECK(empty.status == 1);
  CHECK(empty.out.empty());
  CHECK(contains(empty.err, "a.recording: the recording holds no ticks; record it again"));
  std::ofstream(file) << "no recording";
  const Run text = place.run("device replay a.recording");
  CHECK(text.status == 1);
  CHECK(contains(text.err, "a.recording: this is no recording of a device"));
}

TEST_CASE(
    "a file that is there stays as it is without --overwrite; a folder that is not there is reported "
    "before the hand is asked") {
  const CommandPlace place;
  std::ofstream(place.folder / "a.recording") << "dear";
  const Run kept = place.run("device record simulated 1ubq --seconds 0.2 --out a.recording");
  CHECK(kept.status == 1);
  CHECK(
      contains(kept.err,
               "a.recording is there already and stays as it is; choose another name, or replace it with --overwrite"));
  CHECK_FALSE(contains(kept.out, "Recording"));
  CHECK(contents(place.folder / "a.recording") == "dear");
  CHECK(place.run("device record simulated 1ubq --seconds 0.2 --overwrite --out a.recording").status == 0);
  CHECK(place.run("device replay a.recording").status == 0);
  const Run nowhere = place.run("device record simulated 1ubq --seconds 0.2 --out nowhere/a.recording");
  CHECK(nowhere.status == 1);
  CHECK(contains(nowhere.err, "nowhere/a.recording: its folder is not there"));
  CHECK_FALSE(contains(nowhere.out, "Recording"));
}

TEST_CASE("a recording of an hour ends when the file cannot grow any more, says so, and what is kept replays") {
  const CommandPlace place;
  const Run full = place.run("device record simulated 1ubq --seconds 3600 --out a.recording", "ulimit -f 200;");
  CHECK(full.status == 1);
  CHECK(contains(full.err, "a.recording: it would grow larger than files may be here; raise that limit (ulimit -f)"));
  CHECK(contains(full.err, " s) are kept in the file"));
  const Run replay = place.run("device replay a.recording");
  CHECK(replay.status == 0);
  CHECK(contains(replay.out, " ticks: the same forces and torques to the last bit"));
}

TEST_CASE("a device that is silent for the whole recording: the time is reported, and the recording fails") {
  const CommandPlace place;
  // The stand-in's clock stands until a test lets it run.
  const Run silent = place.run("device record omni 1ubq --seconds 0.5 --out a.recording",
                               "env MOLTACT_LIBHD='" MOLTACT_STAND_IN_LIBHD "'");
  CHECK(silent.status == 1);
  CHECK(contains(silent.out, " s: The device was gone, and the mouse stood in for it."));
  CHECK(contains(silent.err, "the device led no tick of this recording"));
}

TEST_CASE(
    "a device that wants to be calibrated: the recording begins when it is, and where it is not in time nothing is "
    "recorded and no file is left") {
  const CommandPlace place;
  const std::string omni = "env MOLTACT_LIBHD='" MOLTACT_STAND_IN_LIBHD "' STAND_IN_LOG='" +
                           (place.folder / "log").string() + "' STAND_IN_STYLE=1";
  const std::string record = "device record omni 1ubq --seconds 0.5 --out a.recording";
  const Run never = place.run(record + " --wait 1", omni);
  CHECK(never.status == 1);
  CHECK(contains(never.out, "Then press Enter."));
  CHECK_FALSE(contains(never.out, "Recording"));
  CHECK(contains(never.err,
                 "omni: it was not ready within 1 s, and nothing was recorded; Hold the arm in its resting place"));
  CHECK_FALSE(fs::exists(place.folder / "a.recording"));
  const Run entered = place.run(record + " --wait 20", omni, "\n");
  CHECK_MESSAGE(entered.status == 0, entered.err);
  CHECK(contains(entered.out, "500 ticks (0.50 s) in a.recording"));
  CHECK(place.run("device replay a.recording").status == 0);
}
