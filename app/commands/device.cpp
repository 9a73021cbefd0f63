// `moltact device check | record | replay`: uses a device without the window.
#include <cmath>
#include <cstdio>

#include "app/commands/command.h"
#include "app/commands/device_path.h"
#include "app/commands/device_recording.h"
#include "app/commands/number_range.h"
#include "engine/device/driver.h"
#include "engine/platform/interrupt.h"
#include "engine/platform/terminal.h"
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
  char text[480], room[80] = "without an edge", force[320] = "it gives no force, which is only shown on the screen",
                  limits[120] = "";
  if (std::isfinite(info.speed_limit_m_per_s) || std::isfinite(info.slew_limit_N_per_s))
    std::snprintf(limits, sizeof limits, ";\nits driver gives no force beyond %.2f m/s or %.0f N/s",
                  info.speed_limit_m_per_s, info.slew_limit_N_per_s);
  if (finite(info.workspace_mm))
    std::snprintf(room, sizeof room, "%.0f x %.0f x %.0f mm", info.workspace_mm.x, info.workspace_mm.y,
                  info.workspace_mm.z);
  if (info.gives_force)
    std::snprintf(force, sizeof force,
                  "%.1f N for a moment, %.2f N for good;\n"
                  "stiffness up to %.2f N/mm, damping up to %.1f N s/m, steps of %.3f mm, %.1f ms of delay%s",
                  info.max_force_N, info.continuous_force_N, info.max_stiffness_N_per_mm, info.max_damping_N_s_per_m,
                  info.resolution_mm, 1e3 * info.delay_s, limits);
  std::snprintf(text, sizeof text, ": %d degrees of freedom in, %d out; room %s; %s\n", info.dof_in, info.dof_out, room,
                force);
  out() << info.name << Lines{text};
}

constexpr int kNothingChecked = 3, kInterrupted = 130;  // exit statuses
constexpr double kWaitReady_s = 120.0, kWaitPlug_s = 60.0;

// Prints without buffering, because a person follows the output.
void tell(const std::string& line) {
  out() << line << '\n';
  out().flush();
}

// A missing answer, for example in a script, counts as no.
bool askOnTerminal(const std::string& question, const InterruptWatch& interrupt) {
  out() << question << " Go on? [y/N] ";
  out().flush();
  std::string answer;
  while (!interrupt.seen()) {
    const Typed typed = typedLine(answer, 100);
    if (typed == Typed::Line) return answer == "y" || answer == "Y" || answer == "yes";
    if (typed == Typed::End) break;
  }
  out() << '\n';
  return false;
}

// Prints what the user must do with the device whenever this changes. Enter confirms it.
class GuideOnTerminal {
 public:
  bool operator()(const DeviceStatus& status) {
    if (status.text != reported_) {
      reported_ = status.text;
      tell(reported_ + (status.asks_calibrate ? " Then press Enter." : ""));
    }
    std::string line;
    return typedLine(line, 0) == Typed::Line && status.asks_calibrate;
  }

 private:
  std::string reported_;
};

void check(const Options& options) {
  const InterruptWatch interrupt;
  auto device = opened(options.name);
  const bool gives_force = device->info().gives_force;
  if (const auto found = findDevice(options.name); found && !found->note.empty()) out() << found->note << '\n';
  describe(device->info());
  DeviceCheckOptions how;
  if (options.yes)
    how.ask = [](const std::string& question) { return tell(question), true; };
  else
    how.ask = [&](const std::string& question) { return askOnTerminal(question, interrupt); };
  how.tell = tell;
  how.guide = GuideOnTerminal();
  how.interrupted = [&] { return interrupt.seen(); };
  how.part_s = options.seconds;
  how.ready_s = kWaitReady_s;
  how.unplug_s = options.yes ? 0.0 : kWaitPlug_s;  // with --yes, nobody may be present
  how.checked = [](const CheckedPart& part) {
    tell((part.done ? part.passed ? "passed   " : "FAILED   " : "left out ") + part.name + ": " + part.found);
  };
  bool failed = false, anything = false, force = false;
  for (const CheckedPart& part : checkDevice(std::move(device), how)) {
    failed = failed || (part.done && !part.passed);
    anything = anything || part.done;
    force = force || (part.done && part.forces);
  }
  if (interrupt.seen()) throw CommandError{"broken off; the device was closed without force", kInterrupted};
  if (failed) throw CommandError{"the device did not pass"};
  if (!anything) throw CommandError{"nothing was checked", kNothingChecked};
  if (gives_force && !force) throw CommandError{"the device's force was not checked", kNothingChecked};
}

}  // namespace

void addDevice(CLI::App& app) {
  CLI::App* command = app.add_subcommand("device", "Check a haptic device, record a hand, or replay a recording");
  command->require_subcommand(1);
  auto options = std::make_shared<Options>();

  CLI::App* checks = command->add_subcommand(
      "check", "Test a device in your hand: its positions, its force, and every way in which the force must end");
  checks
      ->add_option("NAME", options->name,
                   "A name that `moltact devices` lists, or a driver with an address, such as open-tcp:7010")
      ->required();
  checks->add_flag("--yes", options->yes, "Do not ask before the device moves");
  checks->add_option("--seconds", options->seconds, "Duration of each part")
      ->check(numberFrom(0.2, 600.0))
      ->capture_default_str();
  checks->callback([options] { check(*options); });

  addDeviceRecording(*command);
  addDevicePath(*command);
}

}  // namespace moltact
