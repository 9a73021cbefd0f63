// One option of a choice, as files, commands and the screen offer it. Plain data; any thread.
#pragma once

#include <string_view>

namespace moltact {

struct OfferedWord {
  std::string_view name;      ///< in files and options: "exact"
  std::string_view title;     ///< on the screen; untranslated (N_)
  std::string_view sentence;  ///< description; untranslated (N_)
};

}  // namespace moltact
