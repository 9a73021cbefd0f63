#include "engine/results/attempt_writer.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/platform/append_file.h"
#include "engine/platform/background.h"
#include "engine/results/attempt_file.h"
#include "engine/results/attempt_lines.h"

namespace moltact {
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct AttemptWriter::Impl {
  // Constant while the thread runs:
  fs::path folder, wanted;
  std::string name;  // empty: resume `wanted`

  // Shared, protected by `lock`:
  std::mutex lock;
  std::condition_variable woken, rested;
  std::string waiting;      // complete lines
  std::size_t dropped = 0;  // lines dropped since the last pending one
  fs::path opened;
  std::optional<Problem> fault;
  bool recovered = false, stop = false;
  std::uint64_t asked = 0, served = 0;  // counters of the rounds for which flush() waits

  // Owned by the thread, or by the caller without threads:
  std::optional<AppendFile> file;
  bool failing = false, unsynced = false;
  Clock::time_point synced{};
  std::thread thread;

  std::optional<Problem> open();
  std::optional<Problem> write(const std::string& lines);
  void tell(std::optional<Problem> problem);
  void serve(std::unique_lock<std::mutex>& held);
  void run();
  void nudge();

  // Without threads:
  Clock::time_point failed{};
};

std::optional<Problem> AttemptWriter::Impl::open() {
  if (name.empty()) {
    mendAttempt(wanted);
    Expected<AppendFile> again = AppendFile::open(wanted, AppendFile::Begin::Continue);
    if (!again) return again.problem();
    file.emplace(std::move(*again));
    // A damaged rest stays a line of its own, which readers skip and report.
    std::error_code error;
    if (fs::is_regular_file(wanted, error) && !endsWithLine(wanted))
      if (std::optional<Problem> problem = file->append("\n")) {
        file.reset();
        return problem;
      }
  } else {
    if (folder.empty())
      return Problem{{}, 0, 0, tr("this computer names no folder for results"), tr("set HOME or XDG_DATA_HOME")};
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      return Problem{folder.string(), 0, 0, trf("the folder cannot be made ({0})", error.message()),
                     tr("allow writing there, or free some space")};
    for (int number = 1; !file; ++number) {
      wanted = folder / (name + (number > 1 ? "-" + std::to_string(number) : "") + ".jsonl");
      if (fs::exists(wanted, error)) continue;
      Expected<AppendFile> made = AppendFile::open(wanted, AppendFile::Begin::New);
      if (made)
        file.emplace(std::move(*made));
      else if (!fs::exists(wanted, error))
        return made.problem();
    }
  }
  const std::lock_guard held(lock);
  opened = wanted;
  return std::nullopt;
}

std::optional<Problem> AttemptWriter::Impl::write(const std::string& lines) {
  if (!file)
    if (std::optional<Problem> problem = open()) return problem;
  if (std::optional<Problem> problem = file->append(lines)) return problem;
  unsynced = true;
  return std::nullopt;
}

void AttemptWriter::Impl::tell(std::optional<Problem> problem) {
  if (problem && !failing) fault = std::move(problem);
  if (!problem && failing) recovered = true;
}

// Writes the pending lines once. The lock is released during the write.
void AttemptWriter::Impl::serve(std::unique_lock<std::mutex>& held) {
  const bool last = stop;
  const std::uint64_t serving = asked;
  std::string lines = std::exchange(waiting, {});
  held.unlock();

  std::optional<Problem> problem;
  if (!lines.empty()) problem = write(lines);
  if (!problem && unsynced && (last || Clock::now() - synced >= std::chrono::duration<double>(kSync_s))) {
    // The lines are already in the file. If the sync fails, it is reported but they are not written twice.
    problem = file->sync();
    lines.clear();
    unsynced = problem.has_value();
    synced = Clock::now();
  } else if (!problem) {
    lines.clear();
  }

  held.lock();
  if (!lines.empty()) waiting.insert(0, lines);
  const bool has_failed = problem.has_value();
  tell(std::move(problem));
  failing = has_failed;
  served = serving;
  rested.notify_all();
}

void AttemptWriter::Impl::run() {
  std::unique_lock held(lock);
  for (;;) {
    const auto pause = failing ? kRetry_s : kSync_s;
    const auto wake = [&] { return stop || asked > served || (!waiting.empty() && !failing); };
    if (unsynced || failing)
      woken.wait_for(held, std::chrono::duration<double>(pause), wake);
    else
      woken.wait(held, wake);
    const bool last = stop;
    serve(held);
    if (last) return;
  }
}

// Wakes the thread, or writes immediately without threads.
void AttemptWriter::Impl::nudge() {
  if (thread.joinable()) return woken.notify_one();
  std::unique_lock held(lock);
  const bool retry = Clock::now() - failed >= std::chrono::duration<double>(kRetry_s);
  if (failing && !retry && !stop && asked == served) return;
  serve(held);
  if (failing) failed = Clock::now();
}

AttemptWriter::AttemptWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {
  if (threadsAvailable()) impl_->thread = std::thread([w = impl_.get()] { w->run(); });
}
AttemptWriter::AttemptWriter(AttemptWriter&&) noexcept = default;
AttemptWriter& AttemptWriter::operator=(AttemptWriter&& other) noexcept {
  std::swap(impl_, other.impl_);
  return *this;
}

AttemptWriter AttemptWriter::startNew(fs::path folder, std::string name) {
  auto impl = std::make_unique<Impl>();
  impl->folder = std::move(folder);
  impl->name = std::move(name);
  return AttemptWriter(std::move(impl));
}

AttemptWriter AttemptWriter::resume(fs::path file) {
  auto impl = std::make_unique<Impl>();
  impl->wanted = std::move(file);
  return AttemptWriter(std::move(impl));
}

AttemptWriter::~AttemptWriter() {
  if (!impl_) return;
  {
    const std::lock_guard held(impl_->lock);
    impl_->stop = true;
  }
  impl_->nudge();
  if (impl_->thread.joinable()) impl_->thread.join();
}

void AttemptWriter::append(std::string line) {
  {
    const std::lock_guard held(impl_->lock);
    std::string mark;
    if (impl_->dropped > 0) mark = gapLine(impl_->dropped);
    if (impl_->waiting.size() + mark.size() + line.size() > kMaxWaiting) {
      ++impl_->dropped;
      return;
    }
    impl_->dropped = 0;
    impl_->waiting += mark + line;
  }
  impl_->nudge();
}

std::optional<Problem> AttemptWriter::takeFault() {
  const std::lock_guard held(impl_->lock);
  return std::exchange(impl_->fault, std::nullopt);
}

bool AttemptWriter::takeRecovered() {
  const std::lock_guard held(impl_->lock);
  return std::exchange(impl_->recovered, false);
}

bool AttemptWriter::flush() {
  std::unique_lock held(impl_->lock);
  const std::uint64_t mine = ++impl_->asked;
  held.unlock();
  impl_->nudge();
  held.lock();
  impl_->rested.wait(held, [&] { return impl_->served >= mine; });
  return impl_->waiting.empty();
}

fs::path AttemptWriter::file() const {
  const std::lock_guard held(impl_->lock);
  return impl_->opened;
}

}  // namespace moltact
