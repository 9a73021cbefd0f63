// `moltact devices`: which devices there are, and why one that is there cannot be used.
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "engine/device/driver.h"

namespace moltact {
namespace {

void printJson(const std::vector<FoundDevice>& found) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const FoundDevice& one : found)
    all.push_back({{"name", one.name}, {"title", one.title}, {"place", one.place}, {"usable", one.usable}, {"why_not", one.why},
                   {"gives_force", one.gives_force}, {"default", &one == &defaultDevice(found)}});
  std::cout << all.dump(2) << '\n';
}

void printText(const std::vector<FoundDevice>& found) {
  std::size_t width = 0;
  for (const FoundDevice& one : found) width = std::max(width, one.name.size());
  for (const FoundDevice& one : found) {
    std::cout << one.name << std::string(width - one.name.size() + 2, ' ') << one.title;
    if (!one.place.empty()) std::cout << ", " << one.place;
    std::cout << (one.usable ? one.gives_force ? ": ready, gives force" : ": ready, gives no force" : ": not usable");
    if (&one == &defaultDevice(found)) std::cout << " (the default)";
    std::cout << '\n';
    if (!one.why.empty()) std::cout << std::string(width + 2, ' ') << one.why << '\n';
  }
}

}  // namespace

void addDevices(CLI::App& app) {
  CLI::App* command = app.add_subcommand("devices", "List the haptic devices there are, and why one cannot be used");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print JSON");
  command->callback([json] {
    const std::vector<FoundDevice> found = findDevices();
    *json ? printJson(found) : printText(found);
  });
}

}  // namespace moltact
