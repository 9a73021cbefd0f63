#include "app/commands/touch_options.h"

#include <variant>

#include "app/commands/command.h"
#include "app/commands/number_range.h"
#include "engine/haptics/contact.h"
#include "engine/haptics/interactions.h"
#include "engine/language/catalogue.h"

namespace moltact {

const CLI::Option* addTouchOptions(CLI::App& command, TouchSetup& touch) {
  for (const TouchProperty& p : touchProperties()) {
    if (!(p.requires_rebuild || p.of_surface) || !isChoice(p)) continue;
    const std::string name = "--" + std::string(p.key);
    std::string help(p.meaning);
    std::vector<std::string> words;
    if (p.words)
      for (const OfferedWord& w : p.words()) {
        words.emplace_back(w.name);
        help += "\n  " + words.back() + ": " + std::string(w.sentence);
      }
    std::visit(
        [&](const auto member) {
          CLI::Option* option = command.add_option(name, touch.*member, help)->capture_default_str();
          if (!words.empty())
            option->check(CLI::IsMember(words));
          else if (std::holds_alternative<double TouchSetup::*>(p.member))
            option->check(numberFrom(p.in_scenes.min, p.in_scenes.max));
        },
        p.member);
  }
  return command.get_option("--hand");
}

void checkHand(const TouchSetup& touch, bool body, const CLI::Option* hand) {
  const InteractionKind* kind = findInteractionKind(touch.interaction);
  if (kind && kind->holds_body && !body)
    throw CommandError{Problem{"--hand", 0, 0, trf("the hand holds no body, which '{0}' needs", touch.interaction),
                               tr("name what the hand holds with --in-hand")}
                           .text()};
  if (kind && !kind->holds_body && body && hand->count() > 0)
    throw CommandError{Problem{"--hand", 0, 0,
                               trf("the hand holds a body, which '{0}' does not feel", touch.interaction),
                               trf("leave out --hand for '{0}', or write the name of another interaction with a body",
                                   resolveInteraction(touch, true).interaction)}
                           .text()};
}

void addProbeOption(CLI::App& command, TouchSetup& touch) {
  command.add_option("--probe", touch.probe_A, "Radius of the probe, added to every atom's radius (angstrom)")
      ->check(numberFrom(0.0, kMaxProbe_A))
      ->capture_default_str();
}

}  // namespace moltact
