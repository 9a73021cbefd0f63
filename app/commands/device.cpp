// `moltact device check | record | replay`: a device in the hand, without the window.
#include <cstdio>
#include <iostream>

#include "app/commands/command.h"
#include "app/commands/device_recording.h"
#include "app/commands/number_range.h"
#include "engine/device/driver.h"
#include "engine/servo/device_check.h"

namespace moltact {
namespace {

struct Options {
  std::string name;
  double seconds = 10.0;
  bool yes = false;
};

std::unique_ptr<Device> opened(const std::string& name) {
  auto device = openDevice(name);
  if (!device) throw CommandError{device.problem().text()};
  return std::move(*device);
}

void describe(const DeviceInfo& info) {
  char text[360], room[80] = "without an edge", force[200] = "it gives no force, which is only shown on the screen";
  if (finite(info.workspace_mm))
    std::snprintf(room, sizeof room, "%.0f x %.0f x %.0f mm", info.workspace_mm.x, info.workspace_mm.y, info.workspace_mm.z);
  if (info.gives_force)
    std::snprintf(force, sizeof force, "%.1f N for a moment, %.2f N for good;\nstiffness up to %.2f N/mm, damping up to %.1f N s/m, steps of %.3f mm, %.1f ms of delay",
                  info.max_force_N, info.continuous_force_N, info.max_stiffness_N_per_mm, info.max_damping_N_s_per_m, info.resolution_mm, 1e3 * info.delay_s);
  std::snprintf(text, sizeof text, "%s: %d degrees of freedom in, %d out; room %s; %s\n", info.name.c_str(), info.dof_in, info.dof_out, room, force);
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

}  // namespace

void addDevice(CLI::App& app) {
  CLI::App* command = app.add_subcommand("device", "Check a haptic device, record a hand, or replay a recording");
  command->require_subcommand(1);
  auto options = std::make_shared<Options>();

  CLI::App* checks = command->add_subcommand("check", "Try a device in your hand: its places, a gentle pull, a wall, the panic key");
  checks->add_option("NAME", options->name, "as `moltact devices` lists it")->required();
  checks->add_flag("--yes", options->yes, "do not ask before the device moves");
  checks->add_option("--seconds", options->seconds, "how long each part lasts")->check(numberFrom(0.2, 600.0))->capture_default_str();
  checks->callback([options] { check(*options); });

  addDeviceRecording(*command);
}

}  // namespace moltact
