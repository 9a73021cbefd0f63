// Where cpp-httplib is missing, as on Windows, there is no live class.
#include "engine/classroom/live_class.h"
#include "engine/classroom/taught_class.h"
#include "engine/language/catalogue.h"

namespace moltact {

bool classIsOpen(const std::filesystem::path&) { return false; }

std::optional<Problem> runLiveClass(const LiveClassOptions&, const std::function<void(const LiveClassNews&)>&,
                                    const std::function<bool()>&) {
  return Problem{
      {}, 0, 0, tr("this edition cannot serve a class"), tr("use the Linux edition on the teacher's computer")};
}

bool canServeClass() noexcept { return false; }
std::filesystem::path newClassFolder() { return {}; }
bool openInBrowser(const std::string&) { return false; }

struct TaughtClass::Impl {};

TaughtClass::TaughtClass(LiveClassOptions) {}
TaughtClass::~TaughtClass() = default;
TaughtClass::State TaughtClass::state() const { return State::Over; }
TaughtClass::Facts TaughtClass::facts() const { return {}; }
std::optional<Problem> TaughtClass::problem() const { return runLiveClass({}, {}, {}); }
std::filesystem::path TaughtClass::report() const { return {}; }
std::optional<ClassView> TaughtClass::view() const { return std::nullopt; }
void TaughtClass::hold(const std::string&, std::size_t) {}
void TaughtClass::open(const std::string&) {}
void TaughtClass::askForScene(std::size_t) {}
void TaughtClass::endScene() {}
void TaughtClass::end() {}
void TaughtClass::stop() {}
Expected<std::filesystem::path> TaughtClass::writeReport() { return std::filesystem::path(); }

}  // namespace moltact
