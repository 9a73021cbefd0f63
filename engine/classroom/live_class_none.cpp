// Where cpp-httplib is missing, as on Windows, there is no live class.
#include "engine/classroom/live_class.h"
#include "engine/language/catalogue.h"

namespace moltact {

bool classIsOpen(const std::filesystem::path&) { return false; }

std::optional<Problem> runLiveClass(const LiveClassOptions&, const std::function<void(const LiveClassNews&)>&,
                                    const std::function<bool()>&) {
  return Problem{
      {}, 0, 0, tr("this edition cannot serve a class"), tr("use the Linux edition on the teacher's computer")};
}

}  // namespace moltact
