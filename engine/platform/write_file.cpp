// What is alike wherever files are written.
#include "engine/platform/write_file.h"

namespace moltact {

std::optional<Problem> writeWhole(const std::filesystem::path& file, std::string_view bytes, IfThere there) {
  Expected<Draft> draft = Draft::begin(file, there);
  if (!draft) return draft.problem();
  if (auto problem = draft->append(bytes)) return problem;
  return draft->commit();
}

}  // namespace moltact
