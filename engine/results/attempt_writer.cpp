#include "engine/results/attempt_writer.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/platform/append_file.h"
#include "engine/results/attempt_file.h"

namespace moltact {
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct AttemptWriter::Works {
  // Fixed before the thread begins:
  fs::path folder, wanted;
  std::string name;  // empty: `wanted` is taken up again

  // Shared, under `lock`:
  std::mutex lock;
  std::condition_variable woken, rested;
  std::string waiting;  // whole lines
  fs::path opened;
  std::optional<Problem> trouble;
  bool recovered = false, stop = false;
  std::uint64_t asked = 0, served = 0;  // rounds that flush() waits for

  // The thread's:
  std::optional<AppendFile> file;
  bool failing = false, unsynced = false;
  Clock::time_point synced{};
  std::thread thread;

  std::optional<Problem> open();
  std::optional<Problem> write(const std::string& lines);
  void tell(std::optional<Problem> problem);
  void run();
};

std::optional<Problem> AttemptWriter::Works::open() {
  if (name.empty()) {
    mendAttempt(wanted);
    Expected<AppendFile> again = AppendFile::open(wanted, AppendFile::Begin::Continue);
    if (!again) return again.problem();
    file.emplace(std::move(*again));
    // Whatever could not be mended stays a line of its own, which readers pass over and name.
    std::error_code error;
    if (fs::is_regular_file(wanted, error) && !endsWithLine(wanted))
      if (std::optional<Problem> problem = file->append("\n")) {
        file.reset();
        return problem;
      }
  } else {
    if (folder.empty()) return Problem{{}, 0, 0, "this computer tells no folder to keep results in", "set HOME or XDG_DATA_HOME"};
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return Problem{folder.string(), 0, 0, "the folder cannot be made (" + error.message() + ")", "allow writing there, or free some space"};
    for (int number = 1; !file; ++number) {
      wanted = folder / (name + (number > 1 ? "-" + std::to_string(number) : "") + ".jsonl");
      if (fs::exists(wanted, error)) continue;
      Expected<AppendFile> made = AppendFile::open(wanted, AppendFile::Begin::New);
      if (made) file.emplace(std::move(*made));
      else if (!fs::exists(wanted, error)) return made.problem();
    }
  }
  const std::lock_guard held(lock);
  opened = wanted;
  return std::nullopt;
}

std::optional<Problem> AttemptWriter::Works::write(const std::string& lines) {
  if (!file)
    if (std::optional<Problem> problem = open()) return problem;
  if (std::optional<Problem> problem = file->append(lines)) return problem;
  unsynced = true;
  return std::nullopt;
}

void AttemptWriter::Works::tell(std::optional<Problem> problem) {
  if (problem && !failing) trouble = std::move(problem);
  if (!problem && failing) recovered = true;
}

void AttemptWriter::Works::run() {
  std::unique_lock held(lock);
  for (;;) {
    const auto pause = failing ? kRetry_s : kSync_s;
    const auto wake = [&] { return stop || asked > served || (!waiting.empty() && !failing); };
    if (unsynced || failing) woken.wait_for(held, std::chrono::duration<double>(pause), wake);
    else woken.wait(held, wake);
    const bool last = stop;
    const std::uint64_t serving = asked;
    std::string lines = std::exchange(waiting, {});
    held.unlock();

    std::optional<Problem> problem;
    if (!lines.empty()) problem = write(lines);
    if (!problem && unsynced && (last || Clock::now() - synced >= std::chrono::duration<double>(kSync_s))) {
      // The lines are in the file already: a disk that fails now is told, and they are not written twice.
      problem = file->sync();
      lines.clear();
      unsynced = problem.has_value();
      synced = Clock::now();
    } else if (!problem) {
      lines.clear();
    }

    held.lock();
    if (!lines.empty()) waiting.insert(0, lines);
    const bool failed = problem.has_value();
    tell(std::move(problem));
    failing = failed;
    served = serving;
    rested.notify_all();
    if (last) return;
  }
}

AttemptWriter::AttemptWriter(std::unique_ptr<Works> works) : works_(std::move(works)) {
  works_->thread = std::thread([w = works_.get()] { w->run(); });
}
AttemptWriter::AttemptWriter(AttemptWriter&&) noexcept = default;
AttemptWriter& AttemptWriter::operator=(AttemptWriter&& other) noexcept {
  std::swap(works_, other.works_);
  return *this;
}

AttemptWriter AttemptWriter::startNew(fs::path folder, std::string name) {
  auto works = std::make_unique<Works>();
  works->folder = std::move(folder);
  works->name = std::move(name);
  return AttemptWriter(std::move(works));
}

AttemptWriter AttemptWriter::goOn(fs::path file) {
  auto works = std::make_unique<Works>();
  works->wanted = std::move(file);
  return AttemptWriter(std::move(works));
}

AttemptWriter::~AttemptWriter() {
  if (!works_) return;
  {
    const std::lock_guard held(works_->lock);
    works_->stop = true;
  }
  works_->woken.notify_one();
  works_->thread.join();
}

void AttemptWriter::append(std::string line) {
  {
    const std::lock_guard held(works_->lock);
    if (works_->waiting.size() + line.size() > kMostWaiting) return;
    works_->waiting += line;
  }
  works_->woken.notify_one();
}

std::optional<Problem> AttemptWriter::takeTrouble() {
  const std::lock_guard held(works_->lock);
  return std::exchange(works_->trouble, std::nullopt);
}

bool AttemptWriter::takeRecovered() {
  const std::lock_guard held(works_->lock);
  return std::exchange(works_->recovered, false);
}

bool AttemptWriter::flush() {
  std::unique_lock held(works_->lock);
  const std::uint64_t mine = ++works_->asked;
  works_->woken.notify_one();
  works_->rested.wait(held, [&] { return works_->served >= mine; });
  return works_->waiting.empty();
}

fs::path AttemptWriter::file() const {
  const std::lock_guard held(works_->lock);
  return works_->opened;
}

}  // namespace moltact
