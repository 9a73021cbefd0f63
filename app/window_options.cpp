#include "app/window_options.h"

#include <algorithm>
#include <cstdio>

#include "app/commands/language_option.h"
#include "app/commands/outputs.h"
#include "app/commands/value_types.h"
#include "engine/device/driver.h"
#include "engine/dynamics/simulation_engines.h"
#include "engine/platform/tcp.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {
constexpr double kMinScale = 0.5, kMaxScale = 8.0;  // of the monitor
}

void addWindowArguments(CLI::App& app, WindowArguments& into) {
  app.add_option("file", into.file, "A molecule, a lesson (.md) or a pack (.moltact) to open in the window")
      ->type_name(kMoleculeType);
  addLanguageOption(app, into.language);
  app.add_option("--device", into.device,
                 "The device that leads: a name that `moltact devices` lists, or a driver with an address, such as "
                 "open-tcp:127.0.0.1:7010. The device chosen last stays stored");
  app.add_option(
         "--state-text", into.state_text,
         "Also write contacts and the lesson's instructions as lines of text to this file, or to the terminal for -; "
         "for speech: moltact --state-text - | spd-say -e")
      ->type_name(kFileType);
  // For the makers of the program and its documentation: not in the help.
  app.add_option("--screenshot", into.screenshot)->group("");
  app.add_option("--script", into.script)->group("");
  app.add_option("--size", into.size)->group("");
  app.add_option("--content-scale", into.scale)->group("");
  app.add_option("--attempts", into.attempts)->group("");
  app.add_flag("--frame-stats", into.frame_stats)->group("");
}

void addSimulations(CLI::App& app, WindowArguments& into) {
  for (const SimulationEngine& engine : simulationEngines()) {
    if (engine.scheme.empty()) continue;
    CLI::App* command = app.add_subcommand(
        std::string(engine.scheme), "Touch a molecule that another program simulates: " + std::string(engine.programs));
    command
        ->add_option_function<std::string>(
            "address",
            [&into, &engine](const std::string& text) {
              into.simulation = SimulationAddress{&engine, *parseTcpAddress(text)}.text();
            },
            "Where it listens: PORT on this computer, or HOST:PORT with a numeric host")
        ->type_name("HOST:PORT")
        ->required()
        ->check([](const std::string& text) {
          const auto address = parseTcpAddress(text);
          return address ? std::string() : address.problem().text();
        });
    const std::string order = engine.atom_order.empty() ? "" : " (" + std::string(engine.atom_order) + ")";
    command->add_option("molecule", into.file, "The structure of the atoms that it sends, in the same order" + order)
        ->type_name(kMoleculeType)
        ->required();
    addLanguageOption(*command, into.language);
    // The window's own options may follow.
    command->fallthrough();
  }
}

bool opensWindow(const CLI::App& app) {
  const auto engines = simulationEngines();
  return app.get_subcommands().empty() || std::any_of(engines.begin(), engines.end(), [&](const SimulationEngine& e) {
           return !e.scheme.empty() && app.got_subcommand(std::string(e.scheme));
         });
}

int runWindowArguments(const WindowArguments& a) {
  {
    const FileGuard named;
    noteRead(a.file);
    noteRead(a.script);
    checkOutputs({{"--screenshot", a.screenshot}, {"--state-text", a.state_text == "-" ? "" : a.state_text}});
  }
  if (!a.device.empty() && !findDriver(a.device)) {
    std::string names;
    for (const DeviceDriver& driver : deviceDrivers()) names += (names.empty() ? "" : ", ") + std::string(driver.name);
    err() << "moltact: --device " << oneLine(a.device) << ": no driver has this name; these exist: " << names << '\n';
    return 2;
  }
  if (a.screenshot.empty() && a.script.empty()) {
    hideOwnTerminal();
    return runWindow({.file = a.file,
                      .frame_stats = a.frame_stats,
                      .language = a.language,
                      .device = a.device,
                      .simulation = a.simulation,
                      .state_text = a.state_text});
  }
  OffscreenOptions options{.file = a.file,
                           .screenshot = a.screenshot,
                           .script = a.script,
                           .content_scale = a.scale,
                           .frame_stats = a.frame_stats,
                           .language = a.language,
                           .device = a.device,
                           .simulation = a.simulation,
                           .state_text = a.state_text,
                           .attempts = a.attempts};
  if (!(a.scale >= kMinScale && a.scale <= kMaxScale)) {  // false for what is not a number, too
    err() << "moltact: --content-scale " << a.scale << " is out of range; give 0.5 to 8\n";
    return 2;
  }
  char end = 0;
  if (!a.size.empty() && (std::sscanf(a.size.c_str(), "%dx%d%c", &options.width, &options.height, &end) != 2 ||
                          options.width < 64 || options.height < 64 || options.width > 8192 || options.height > 8192)) {
    err() << "moltact: --size " << a.size << " is no size; write it as 1280x800 (64 to 8192 each)\n";
    return 2;
  }
  return runOffscreen(options);
}

}  // namespace moltact
