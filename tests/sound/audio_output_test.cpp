// The real audio output, each case in a process of its own, because OpenAL reads its drivers once: without a driver,
// and with one that writes a file at a sound card's rate.
#include "engine/platform/audio_output.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <thread>

using namespace moltact;
namespace fs = std::filesystem;

namespace {

constexpr int kRate = 48000;

// What `child` returned, and what it wrote on stderr.
template <class Child>
std::pair<int, std::string> inChild(const char* drivers, const fs::path& config, Child child) {
  const fs::path errors = fs::temp_directory_path() / ("moltact_audio_" + std::to_string(getpid()) + ".err");
  const pid_t pid = fork();
  if (pid == 0) {
    setenv("ALSOFT_DRIVERS", drivers, 1);
    setenv("ALSOFT_CONF", config.c_str(), 1);
    if (!std::freopen(errors.c_str(), "w", stderr)) _exit(99);
    _exit(child());
  }
  int status = 0;
  waitpid(pid, &status, 0);
  std::ifstream in(errors);
  std::stringstream text;
  text << in.rdbuf();
  fs::remove(errors);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 100, text.str()};
}

AudioOutput::State settled(const AudioOutput& output) {
  for (int k = 0; k < 500 && output.state() == AudioOutput::State::Opening; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return output.state();
}

}  // namespace

TEST_CASE(
    "without any sound card the output is silent, says so in one sentence, asks for no sample and writes nothing on "
    "stderr") {
  for (const char* drivers : {"none", "alsa"}) {
    // The second is the real search for a card, where the computer that runs this has none.
    if (std::string(drivers) == "alsa" && fs::exists("/proc/asound/card0")) continue;
    const auto [status, errors] = inChild(drivers, "/dev/null", [] {
      int asked = 0;
      const AudioOutput output(kRate, [&](std::span<float>) { ++asked; });
      if (settled(output) != AudioOutput::State::Silent) return 1;
      if (output.fault().find("There is no sound: ") != 0) return 2;
      return asked == 0 ? 0 : 3;
    });
    CAPTURE(drivers);
    CHECK(status == 0);
    CHECK(errors == "");
  }
}

TEST_CASE(
    "a tone of 440 Hz comes out of the sound card's end at 440 Hz, and the program leaves it within the blocks in "
    "hand") {
  const fs::path folder = fs::temp_directory_path() / ("moltact_audio_" + std::to_string(getpid()));
  fs::create_directories(folder);
  const fs::path wav = folder / "out.wav", config = folder / "alsoft.conf";
  std::ofstream(config) << "[general]\nchannels = mono\nsample-type = int16\nfrequency = 48000\n[wave]\nfile = "
                        << wav.string() << "\n";
  const auto [status, errors] = inChild("wave", config, [] {
    std::atomic<int> asked{0};
    {
      const AudioOutput output(kRate, [&, phase = 0.0](std::span<float> out) mutable {
        for (float& s : out) {
          s = 0.5f * float(std::sin(2 * std::numbers::pi * phase));
          phase += 440.0 / kRate;
        }
        asked += int(out.size());
      });
      if (settled(output) != AudioOutput::State::Playing) return 1;
      // A second of sound, however long this computer takes for it.
      for (int k = 0; k < 1000 && asked < kRate; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return asked >= kRate ? 0 : 2;
  });
  CHECK(status == 0);
  CHECK(errors == "");
  std::ifstream in(wav, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  const std::string bytes = text.str();
  fs::remove_all(folder);
  const std::size_t data = bytes.find("data");
  REQUIRE(data != std::string::npos);
  std::vector<int> s;
  for (std::size_t k = data + 8; k + 1 < bytes.size(); k += 2)
    s.push_back(std::int16_t(std::uint16_t(std::uint8_t(bytes[k])) | std::uint16_t(std::uint8_t(bytes[k + 1])) << 8));
  // From one rising crossing to the next, the most frequent of them: where the computer stutters others are longer.
  std::vector<std::size_t> rises, periods;
  for (std::size_t k = 1; k < s.size(); ++k)
    if (s[k - 1] < 0 && s[k] >= 0) rises.push_back(k);
  REQUIRE(rises.size() > 220);
  for (std::size_t k = 1; k < rises.size(); ++k) periods.push_back(rises[k] - rises[k - 1]);
  std::map<std::size_t, int> often;
  for (const std::size_t p : periods) ++often[p];
  const double period = double(std::max_element(often.begin(), often.end(), [](const auto& a, const auto& b) {
                                 return a.second < b.second;
                               })->first);
  CHECK(std::abs(period - kRate / 440.0) < 1.0);
}
