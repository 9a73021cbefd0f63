#include "app/commands/print_json.h"

#include <cstdio>

#include "engine/platform/terminal.h"

namespace moltact {

void printDocument(const nlohmann::ordered_json& json) {
  std::string text;
  splitHarmful(
      json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace),
      [&](std::string_view piece) { text += piece; },
      [&](std::uint32_t code, bool) {
        char escaped[8];
        std::snprintf(escaped, sizeof escaped, "\\u%04x", code & 0xFFFFu);
        text += escaped;
      },
      [](std::uint32_t) { return false; });
  out() << Lines{text} << '\n';
}

}  // namespace moltact
