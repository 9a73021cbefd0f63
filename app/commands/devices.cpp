// `moltact devices`: lists the devices, and for each unusable one the reason.
#include <algorithm>

#include "app/commands/command.h"
#include "app/commands/print_json.h"
#include "engine/device/driver.h"
#include "engine/language/quantity_text.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

// Null: not known.
nlohmann::ordered_json dampingOf(const FoundDevice& one) {
  return one.rotational_damping_N_mm_s > 0.0 ? nlohmann::ordered_json(one.rotational_damping_N_mm_s) : nullptr;
}

// Of a device with force: "torque up to 170 N mm, rotational damping not known".
std::string turning(const FoundDevice& one) {
  return (one.max_torque_N_mm > 0.0 ? "torque up to " + numberText(one.max_torque_N_mm) + " N mm" : "no torque") +
         ", rotational damping " +
         (one.rotational_damping_N_mm_s > 0.0 ? numberText(one.rotational_damping_N_mm_s) + " N mm s/rad"
                                              : "not known");
}

void printJson(const std::vector<FoundDevice>& found) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const FoundDevice& one : found)
    all.push_back({{"name", one.name},
                   {"title", one.title},
                   {"place", one.place},
                   {"usable", one.usable},
                   {"why_not", one.why},
                   {"gives_force", one.gives_force},
                   {"max_torque_N_mm", one.max_torque_N_mm},
                   {"rotational_damping_N_mm_s", dampingOf(one)},
                   {"default", &one == &defaultDevice(found)}});
  printDocument(all);
}

void printText(const std::vector<FoundDevice>& found) {
  std::size_t width = 0;
  for (const FoundDevice& one : found) width = std::max(width, one.name.size());
  for (const FoundDevice& one : found) {
    out() << one.name << std::string(width - one.name.size() + 2, ' ') << one.title;
    if (!one.place.empty()) out() << ", " << one.place;
    out() << (one.usable ? one.gives_force ? ": ready, gives force" : ": ready, gives no force" : ": not usable");
    if (&one == &defaultDevice(found)) out() << " (the default)";
    out() << '\n';
    if (one.gives_force) out() << std::string(width + 2, ' ') << turning(one) << '\n';
    if (!one.why.empty()) out() << std::string(width + 2, ' ') << one.why << '\n';
  }
}

}  // namespace

void addDevices(CLI::App& app) {
  CLI::App* command = app.add_subcommand("devices", "List haptic devices, and why one cannot be used");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print JSON");
  command->callback([json] {
    const std::vector<FoundDevice> found = findDevices();
    *json ? printJson(found) : printText(found);
  });
}

}  // namespace moltact
