// `moltact device check | record | replay`: a device in the hand, without the window.
#include <chrono>
#include <cstdio>
#include <iostream>
#include <thread>

#include "app/commands/command.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/number_range.h"
#include "engine/device/driver.h"
#include "engine/device/mouse_device.h"
#include "engine/haptics/methods.h"
#include "engine/servo/device_check.h"
#include "engine/servo/fit_workspace.h"
#include "engine/servo/scale.h"
#include "engine/servo/servo_thread.h"
#include "engine/servo/trace.h"

namespace moltact {
namespace {

constexpr double kRoom_A_per_mm = 0.25;

struct Options {
  std::string name, file, method = "exact";
  MoleculeArgument molecule;
  double seconds = 10.0;
  bool yes = false;
};

std::unique_ptr<Device> opened(const std::string& name) {
  auto device = openDevice(name);
  if (!device) throw CommandError{device.problem().text()};
  return std::move(*device);
}

void describe(const DeviceInfo& info) {
  char text[320], room[80] = "without an edge";
  if (finite(info.workspace_mm))
    std::snprintf(room, sizeof room, "%.0f x %.0f x %.0f mm", info.workspace_mm.x, info.workspace_mm.y, info.workspace_mm.z);
  std::snprintf(text, sizeof text,
                "%s: %d degrees of freedom in, %d out; room %s; %.1f N for a moment, %.2f N for good;\n"
                "stiffness up to %.2f N/mm, damping up to %.1f N s/m, steps of %.3f mm, %.1f ms of delay\n",
                info.name.c_str(), info.dof_in, info.dof_out, room, info.max_force_N, info.continuous_force_N, info.max_stiffness_N_per_mm,
                info.max_damping_N_s_per_m, info.resolution_mm, 1e3 * info.delay_s);
  std::cout << text;
}

// No answer, as from a script without one, counts as no.
bool askOnTerminal(const std::string& question) {
  std::cout << question << " Go on? [y/N] " << std::flush;
  std::string answer;
  if (!std::getline(std::cin, answer)) std::cout << '\n';
  return answer == "y" || answer == "Y" || answer == "yes";
}

void check(const Options& options) {
  auto device = opened(options.name);
  describe(device->info());
  if (const std::string text = device->status().text; !text.empty()) std::cout << text << '\n';
  DeviceCheckOptions how;
  how.ask = options.yes ? [](const std::string& question) { return std::cout << question << '\n', true; } : askOnTerminal;
  how.tell = [](const std::string& what) { std::cout << what << '\n'; };
  how.part_s = options.seconds;
  bool failed = false;
  for (const CheckedPart& part : checkDevice(std::move(device), how)) {
    failed = failed || (part.done && !part.passed);
    std::cout << (part.done ? part.passed ? "passed   " : "FAILED   " : "left out ") << part.name << ": " << part.found << '\n';
  }
  if (failed) throw CommandError{"the device did not pass"};
}

std::shared_ptr<const BallScene> sceneOf(const Options& options) {
  return std::make_shared<const BallScene>(options.molecule.load().balls());
}

// The molecule before the hand, seen along its z-axis.
ServoSettings settingsFor(const BallScene& scene, const DeviceFigures& device) {
  ServoSettings settings;
  settings.workspace.A_per_mm = kRoom_A_per_mm;
  settings.workspace = beforeHand(settings.workspace, scene, settings.probe_A, {0.5 * (scene.low_A() + scene.high_A())}, glm::dmat3(1.0), device);
  return settings;
}

void record(const Options& options) {
  const auto scene = sceneOf(options);
  MouseDevice mouse;
  ServoThread servo(mouse);
  auto device = opened(options.name);
  const ServoSettings settings = settingsFor(*scene, device->info());
  const std::map<std::string, std::string> labels{{"molecule", options.molecule.name}, {"method", options.method}, {"device", device->info().name}};
  servo.setSettings(settings);
  const double felt_N_per_mm = steadyStiffness_N_per_mm(settings.stiffness_N_per_mm, device->info());
  servo.setDevice(std::move(device));
  servo.record(true);
  servo.setTracker(findMethod(options.method)->make(scene, settings.probe_A));
  std::cout << "Recording " << options.seconds << " s. " << scaleSentence(settings.workspace, felt_N_per_mm) << '\n' << std::flush;

  std::optional<TraceWriter> writer;
  ServoStep start;
  std::size_t ticks = 0, touching = 0;
  const auto wanted = static_cast<std::size_t>(options.seconds / kTick_s);
  while (ticks < wanted) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    servo.drainRecording(start, [&](const TraceTick& tick) {
      if (!writer) {
        auto made = TraceWriter::create(options.file, labels, start);
        if (!made) throw CommandError{made.problem().text()};
        writer.emplace(std::move(*made));
      }
      if (ticks++ < wanted) writer->add(tick);
    });
    servo.drain([&](const ServoSample& sample) { touching += sample.contact.touching(); });
  }
  if (auto problem = writer->finish()) throw CommandError{problem->text()};
  if (servo.lostOfRecording()) throw CommandError{"the disk was too slow: " + std::to_string(servo.lostOfRecording()) + " ticks are missing, so the recording cannot be replayed"};
  std::cout << wanted << " ticks in " << options.file << ", " << touching << " of them in contact\n";
}

void replayFile(const Options& options) {
  const auto trace = readTrace(options.file);
  if (!trace) throw CommandError{trace.problem().text()};
  if (!trace->torn.empty()) std::cerr << "moltact: " << trace->torn << '\n';
  const auto label = [&](const char* key) {
    const auto found = trace->labels.find(key);
    return found == trace->labels.end() ? std::string() : found->second;
  };
  Options with = options;
  if (with.molecule.name.empty()) with.molecule.name = label("molecule");
  const Method* method = findMethod(label("method"));
  if (!method) throw CommandError{Problem{options.file, 0, 0, "it was recorded with a method \"" + label("method") + "\" that is not known here", "record it anew"}.text()};
  const auto tracker = method->make(sceneOf(with), trace->ticks.empty() ? kWaterProbe_A : trace->ticks.front().settings.probe_A);
  const ReplayResult result = replay(*trace, tracker.get());
  if (!result.first_difference) {
    std::cout << result.ticks << " ticks: the same forces to the last bit\n";
    return;
  }
  char text[200];
  std::snprintf(text, sizeof text, "%llu ticks: the forces differ from tick %llu on, by at most %.3g N%s", static_cast<unsigned long long>(result.ticks),
                static_cast<unsigned long long>(*result.first_difference), result.greatest_difference_N,
                trace->start ? "" : "; another build made the recording");
  throw CommandError{text};
}

}  // namespace

void addDevice(CLI::App& app) {
  CLI::App* command = app.add_subcommand("device", "Check a haptic device, record a hand, or replay a recording");
  command->require_subcommand(1);
  auto options = std::make_shared<Options>();
  std::vector<std::string> names;
  for (const Method& m : methods()) names.emplace_back(m.name);

  CLI::App* checks = command->add_subcommand("check", "Try a device in your hand: its places, a gentle pull, a wall, the panic key");
  checks->add_option("NAME", options->name, "as `moltact devices` lists it")->required();
  checks->add_flag("--yes", options->yes, "do not ask before the device moves");
  checks->add_option("--seconds", options->seconds, "how long each part lasts")->check(numberFrom(0.2, 600.0))->capture_default_str();
  checks->callback([options] { check(*options); });

  CLI::App* records = command->add_subcommand("record", "Record a hand on a molecule: every place and every force");
  records->add_option("NAME", options->name, "as `moltact devices` lists it")->required();
  options->molecule.addTo(*records);
  records->add_option("--out", options->file, "the file to write")->required();
  records->add_option("--method", options->method, "haptic method")->check(CLI::IsMember(names))->capture_default_str();
  records->add_option("--seconds", options->seconds, "how long")->check(numberFrom(0.1, 36000.0))->capture_default_str();
  records->callback([options] { record(*options); });

  CLI::App* replays = command->add_subcommand("replay", "Step a recording again and compare the forces to the last bit");
  replays->add_option("FILE", options->file, "a recording")->required();
  replays->callback([options] { replayFile(*options); });
}

}  // namespace moltact
