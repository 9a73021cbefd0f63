// `moltact devices`: lists the devices, and for each unusable one the reason.
#include <algorithm>

#include "app/commands/command.h"
#include "app/commands/print_json.h"
#include "engine/device/driver.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

void printJson(const std::vector<FoundDevice>& found) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const FoundDevice& one : found)
    all.push_back({{"name", one.name},
                   {"title", one.title},
                   {"place", one.place},
                   {"usable", one.usable},
                   {"why_not", one.why},
                   {"gives_force", one.gives_force},
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
