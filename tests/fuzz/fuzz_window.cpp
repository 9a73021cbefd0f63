// The off-screen window opens and plays attempts and recordings that the program never writes: mutated byte by byte, or
// generated from lines and ticks with extreme numbers. It may reject each, and must continue afterwards.
//   test_fuzz_window                       both kinds
//   test_fuzz_window attempt               one
//   test_fuzz_window attempt 12            only its run 12, in a fresh window; the file is kept as
//                                          fuzz-window.jsonl or .recording
//   MOLTACT_FUZZ_RUNS, MOLTACT_FUZZ_SEED: the number of runs of each kind (16), and the random seed
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "app/ui/extensions/extensions.h"
#include "app/ui/shell/scripted_user.h"
#include "tests/fuzz/attempt_maker.h"
#include "tests/fuzz/changed.h"
#include "tests/fuzz/crash_note.h"
#include "tests/fuzz/recording_maker.h"
#include "tests/results/sample_attempt.h"

namespace moltact::fuzz {
namespace {

constexpr unsigned kHang_s = 300;
constexpr std::size_t kTicks = 200;

std::unique_ptr<ScriptedUser> window() {
  ScriptedUser::Options options;
  options.draws = ScriptedUser::Draws::LastInRow;
  options.width = 900;
  options.height = 600;
  auto made = ScriptedUser::create(std::move(options));
  if (!made) {
    std::fprintf(stderr, "%s\n", made.problem().text().c_str());
    std::exit(1);
  }
  (*made)->app().open("1ubq");
  (*made)->app().finishLoading();
  (*made)->frames(3);
  return *std::move(made);
}

bool isNumber(const Camera& c) {
  return finite(c.target.A) && std::isfinite(c.distance_A) &&
         std::isfinite(c.orientation.w + c.orientation.x + c.orientation.y + c.orientation.z);
}

void lookAt(ScriptedUser& driver) {
  driver.frames(1);
  const ServoSample& now = driver.app().scene.log().latest();
  mustBe(finite(now.force.N), "a force that is a number");
  mustBe(isNumber(driver.app().scene.camera), "a camera that is somewhere");
}

// What a person might do meanwhile.
void doSomething(ScriptedUser& driver, Choices& choices) {
  constexpr const char* kKeys[] = {"Ctrl+D", "Ctrl+M", "Ctrl+T", "Ctrl+G", "Left",
                                   "Right",  "Space",  "Ctrl+L", "R",      "F9"};
  driver.tap(kKeys[choices.pick(std::size(kKeys))]);
  if (choices.pick(4) != 3) return;
  driver.point("view", 0.1 * double(choices.pick(10)), 0.1 * double(choices.pick(10)));
  driver.wheel(double(choices.pick(9)) - 4.0);
}

bool playAttempt(ScriptedUser& driver, const std::filesystem::path& file, Choices& choices) {
  Application& app = driver.app();
  app.open(file);
  app.finishLoading();
  lookAt(driver);
  Playback& playback = app.extensions().playback;
  if (!playback.on()) return false;
  constexpr double kSpeeds[] = {0.25, 1.0, 4.0, 64.0};
  playback.speed = kSpeeds[choices.pick(std::size(kSpeeds))];
  playback.skips_rests = choices.pick(2);
  for (std::size_t k = 1 + choices.pick(6); k > 0; --k) {
    const std::size_t how = choices.pick(8);
    if (how < 3)
      playback.seek(playback.timeline().length_s() * double(choices.pick(65)) / 64.0);
    else if (how == 3)
      playback.seekMark(1);
    else if (how == 4)
      playback.seek(3.0 + 0.01 * double(choices.pick(12)));  // where the sample touches
    else if (how == 5)
      playback.setRunning(!playback.running());
    else
      doSomething(driver, choices);
    app.finishLoading();
    lookAt(driver);
    driver.frames(int(choices.pick(6)));
  }
  if (choices.pick(2)) playback.close();
  lookAt(driver);
  return true;
}

bool playRecording(ScriptedUser& driver, const std::filesystem::path& file, Choices& choices) {
  Application& app = driver.app();
  app.open(file);
  app.finishLoading();
  driver.frames(2);
  const bool plays = app.extensions().hand_recorder.playing();
  for (std::size_t k = 1 + choices.pick(8); k > 0; --k) {
    driver.frames(1 + int(choices.pick(3)));
    app.finishLoading();
    lookAt(driver);
    if (choices.pick(4) == 3) doSomething(driver, choices);
  }
  if (choices.pick(2)) driver.frames(20);  // to its end
  lookAt(driver);
  return plays;
}

// `play` returns whether the file could be opened.
struct Kind {
  const char* name;
  const char* ending;
  std::string (*make)(Choices& choices, std::mt19937_64& random);
  bool (*play)(ScriptedUser& driver, const std::filesystem::path& file, Choices& choices);
};

std::string anAttempt(Choices& choices, std::mt19937_64& random) {
  if (choices.pick(4)) return madeAttempt(choices);
  static const std::vector<std::string> seeds = {sampleFile()};
  return changed(seeds, random, 16384);
}

std::string aRecording(Choices& choices, std::mt19937_64& random) {
  Workspace workspace;
  workspace.centre_A = {30.0, 29.0, 14.0};  // amid ubiquitin
  const std::string made = madeRecording(choices, kTicks, workspace);
  return choices.pick(4) ? made : changed({made}, random, 65536);
}

constexpr Kind kKinds[] = {{"attempt", ".jsonl", anAttempt, playAttempt},
                           {"recording", ".recording", aRecording, playRecording}};

}  // namespace
}  // namespace moltact::fuzz

int main(int argc, char** argv) {
  using namespace moltact;
  using namespace moltact::fuzz;
  ::setenv("MOLTACT_HOME", MOLTACT_SOURCE_DIR, 0);
  tellCrashes();
  const unsigned long runs = fromEnvironment("MOLTACT_FUZZ_RUNS", 16),
                      from = fromEnvironment("MOLTACT_FUZZ_SEED", 20'261'122);
  const bool one = argc > 2;
  const unsigned long wanted = one ? std::strtoul(argv[2], nullptr, 10) : 0;
  const ScratchFolder scratch;
  bool found = false;
  for (const Kind& kind : kKinds) {
    if (argc > 1 && std::strcmp(argv[1], kind.name) != 0) continue;
    found = true;
    const auto began = std::chrono::steady_clock::now();
    std::unique_ptr<ScriptedUser> driver = window();
    std::size_t played = 0;
    for (unsigned long k = one ? wanted : 0; k < (one ? wanted + 1 : runs); ++k) {
      beginRun(std::string("test_fuzz_window ") + kind.name + ' ' + std::to_string(k) +
                   " (MOLTACT_FUZZ_SEED=" + std::to_string(from) + ')',
               kHang_s);
      if (k % 32 == 31) {
        driver.reset();  // there is one at a time
        driver = window();
      }
      std::mt19937_64 random(from * 1'000'003 + k);
      std::string decisions(4096, '\0');
      for (char& c : decisions) c = char(random());
      Choices choices(decisions);
      const auto file =
          (one ? std::filesystem::path("fuzz-window") : scratch.path / "a").replace_extension(kind.ending);
      writeFile(file, kind.make(choices, random));
      played += kind.play(*driver, file, choices);
      driver->app().messages.clearErrors();
      endRun();
    }
    if (!one && runs >= 16) mustBe(played >= runs / 4, "a quarter of the files at least that can be played");
    std::printf("%-10s %lu runs from %lu, %zu played, %.1f s\n", kind.name, one ? 1 : runs, from, played,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
    std::fflush(stdout);
  }
  if (!found) std::fprintf(stderr, "there is no kind of that name\n");
  return found ? 0 : 1;
}
