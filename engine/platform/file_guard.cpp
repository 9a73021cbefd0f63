#include "engine/platform/file_guard.h"

#include <atomic>
#include <mutex>
#include <system_error>
#include <unordered_set>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

std::atomic<bool> guarded{false};
std::mutex mutex;
// Names as strings: a path takes ten times their memory, and there may be a hundred thousand inputs.
using Names = std::unordered_set<fs::path::string_type>;
Names inputs, outputs_written;

void note(Names& files, const fs::path& file) {
  if (!guarded.load()) return;
  const std::lock_guard lock(mutex);
  files.insert(file.native());
}

// The name behind all links, also if the last one leads to a file that does not exist.
fs::path behindAllLinks(fs::path file) {
  constexpr int kMaxLinks = 40;  // as in Linux
  std::error_code error;
  for (int k = 0; k < kMaxLinks && fs::is_symlink(fs::symlink_status(file, error)); ++k) {
    const fs::path to = fs::read_symlink(file, error);
    if (error) break;
    file = file.parent_path() / to;  // `to` alone if it is absolute
  }
  const fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? file : whole;
}

bool isOrdinaryOrMissing(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  return !fs::exists(status) || fs::is_regular_file(status);
}

bool among(const Names& files, const fs::path& file) {
  std::error_code error;
  const bool exists = fs::exists(file, error);
  for (const fs::path::string_type& other : files) {
    // Existing files are compared by the system alone, which is fast.
    if (exists ? fs::equivalent(file, other, error) : sameFile(file, other)) return true;
  }
  return false;
}

}  // namespace

FileGuard::FileGuard() { guarded.store(true); }

FileGuard::~FileGuard() {
  guarded.store(false);
  const std::lock_guard lock(mutex);
  inputs.clear();
  outputs_written.clear();
}

bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  return behindAllLinks(a) == behindAllLinks(b);
}

void noteRead(const fs::path& file) { note(inputs, file); }
void noteWritten(const fs::path& file) { note(outputs_written, file); }

std::optional<Problem> overwriteProblem(const fs::path& file) {
  if (!guarded.load() || !isOrdinaryOrMissing(file)) return std::nullopt;
  const std::lock_guard lock(mutex);
  std::error_code error;
  // A file that does not exist cannot be an input.
  if (fs::exists(file, error) && among(inputs, file))
    return Problem{file.string(), 0, 0, tr("this command reads the file, so it is not overwritten"),
                   tr("name another file to write")};
  if (among(outputs_written, file))
    return Problem{file.string(), 0, 0, tr("this command has written the file already"),
                   tr("name a file of its own for each output")};
  return std::nullopt;
}

std::optional<Problem> overwriteProblem(const std::vector<NamedOutput>& outputs) {
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const NamedOutput& one = outputs[k];
    if (one.file.empty()) continue;
    if (auto problem = overwriteProblem(one.file)) return problem;
    if (!isOrdinaryOrMissing(one.file)) continue;
    for (std::size_t j = 0; j < k; ++j)
      if (!outputs[j].file.empty() && sameFile(outputs[j].file, one.file))
        return Problem{one.file.string(), 0, 0,
                       trf("{0} and {1} would be written to this one file", outputs[j].option, one.option),
                       tr("name a file of its own for each output")};
  }
  return std::nullopt;
}

}  // namespace moltact
