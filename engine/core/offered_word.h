// One word of a choice that files, commands and the screen offer. Plain data; any thread.
#pragma once

#include <string_view>

namespace moltact {

struct OfferedWord {
  std::string_view name;      ///< in files and options: "exact"
  std::string_view title;     ///< on the screen, N_
  std::string_view sentence;  ///< what it is, N_
};

}  // namespace moltact
