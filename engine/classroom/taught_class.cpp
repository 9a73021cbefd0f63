#include "engine/classroom/taught_class.h"

#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <nlohmann/json.hpp>

#include "engine/classroom/class_folder.h"
#include "engine/classroom/class_requests.h"
#include "engine/platform/background.h"
#include "engine/platform/folders.h"
#include "engine/platform/run_program.h"

namespace moltact {

bool canServeClass() noexcept { return true; }

std::filesystem::path newClassFolder() {
  if (userDataFolder().empty()) return {};
  return userDataFolder() / "classes" / classFolderName(std::chrono::system_clock::now());
}

bool openInBrowser(const std::string& address) {
  // The shell does not wait: xdg-open may be there until the browser is closed. It reads the address as a parameter.
  const Expected<ProgramRun> run = runProgram(
      {"sh", "-c", R"(command -v xdg-open >/dev/null || exit 1; xdg-open "$0" >/dev/null 2>&1 &)", address}, true);
  return run && run->status == 0;
}

struct TaughtClass::Impl {
  std::atomic<bool> stop{false};
  mutable std::mutex lock;  // of all below but `done`
  State state = State::Beginning;
  Facts facts;
  std::shared_ptr<ClassRequests> requests;
  std::chrono::steady_clock::time_point began;
  std::optional<Problem> problem;
  std::filesystem::path report;
  std::future<void> done;

  double now_s() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(); }

  void hear(const LiveClassNews& news) {
    const std::lock_guard held(lock);
    if (news.kind == LiveClassNews::Kind::Started) {
      facts = {news.address, news.teacher, news.others, news.shared ? qrCode(news.address) : QrCode(),
               news.shared,  news.alone};
      requests = news.requests;
      began = news.clock_began;
      state = State::Served;
    }
    if (news.kind == LiveClassNews::Kind::Stopped && !news.report.empty()) report = news.report;
  }
  void run(const LiveClassOptions& options) {
    auto problem_met = runLiveClass(
        options, [this](const LiveClassNews& news) { hear(news); }, [this] { return stop.load(); });
    const std::lock_guard held(lock);
    problem = std::move(problem_met);
    requests.reset();
    state = State::Over;
  }
  std::shared_ptr<ClassRequests> served() const {
    const std::lock_guard held(lock);
    return requests;
  }
  void steer(const nlohmann::json& act) const {
    if (const auto to = served()) (void)to->steerHere(act.dump(), now_s());
  }
};

TaughtClass::TaughtClass(LiveClassOptions options) : impl_(std::make_unique<Impl>()) {
  impl_->done = inBackground([impl = impl_.get()](const LiveClassOptions& of) { impl->run(of); }, std::move(options));
}

TaughtClass::~TaughtClass() {
  impl_->stop = true;
  if (impl_->done.valid()) impl_->done.wait();
}

TaughtClass::State TaughtClass::state() const {
  const std::lock_guard held(impl_->lock);
  return impl_->state;
}

TaughtClass::Facts TaughtClass::facts() const {
  const std::lock_guard held(impl_->lock);
  return impl_->facts;
}

std::optional<Problem> TaughtClass::problem() const {
  const std::lock_guard held(impl_->lock);
  return impl_->problem;
}

std::filesystem::path TaughtClass::report() const {
  const std::lock_guard held(impl_->lock);
  return impl_->report;
}

std::optional<ClassView> TaughtClass::view() const {
  const auto of = impl_->served();
  return of ? std::optional(of->shownView(impl_->now_s())) : std::nullopt;
}

void TaughtClass::hold(const std::string& lesson, std::size_t step) {
  impl_->steer({{"do", "hold"}, {"lesson", lesson}, {"step", step}});
}
void TaughtClass::open(const std::string& lesson) { impl_->steer({{"do", "open"}, {"lesson", lesson}}); }
void TaughtClass::askForScene(std::size_t student) { impl_->steer({{"do", "ask scene"}, {"student", student}}); }
void TaughtClass::endScene() { impl_->steer({{"do", "end scene"}}); }
void TaughtClass::end() { impl_->steer({{"do", "end"}}); }
void TaughtClass::stop() { impl_->stop = true; }

Expected<std::filesystem::path> TaughtClass::writeReport() {
  const auto of = impl_->served();
  if (!of) return report();
  const Expected<std::string> page = of->writeReport();
  if (!page) return page.problem();
  const std::lock_guard held(impl_->lock);
  if (!page->empty()) impl_->report = of->reportFile();
  return impl_->report;
}

}  // namespace moltact
