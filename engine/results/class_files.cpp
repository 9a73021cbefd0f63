#include "engine/results/class_files.h"

#include <algorithm>
#include <system_error>
#include <unordered_set>
#include <utility>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// The native string of a path needs a tenth of the path object's memory.
struct Begun {
  fs::path::string_type file;
  std::string began;  // empty if the file is not an attempt
};

// The files to read, each once, with the time at which its attempt began.
std::vector<Begun> attemptsIn(std::span<const fs::path> files_and_folders, std::vector<Problem>& passed_over) {
  std::vector<Begun> out;
  std::unordered_set<fs::path::string_type> met;
  for (const fs::path& named : files_and_folders) {
    const Expected<std::vector<fs::path>> files = attemptFiles(named, true);
    if (!files) {
      passed_over.push_back(files.problem());
      continue;
    }
    if (files->empty())
      passed_over.push_back({named.string(), 0, 0, tr("there are no .jsonl files in this folder"),
                             tr("name the folder that holds the attempts")});
    for (const fs::path& file : *files) {
      std::error_code error;
      const fs::path whole = fs::weakly_canonical(file, error);
      if (met.insert((error ? file : whole).native()).second) out.push_back({file.native(), attemptBegan(file)});
    }
  }
  return out;
}

}  // namespace

std::vector<Problem> forEachAttempt(std::span<const fs::path> files_and_folders,
                                    const std::function<void(const Attempt&)>& take) {
  std::vector<Problem> out;
  const std::vector<Begun> files = attemptsIn(files_and_folders, out);
  // Attempts are passed in the order in which they began; problems are listed in the order of the files.
  std::vector<std::size_t> order(files.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return files[a].began < files[b].began; });
  std::vector<std::pair<std::size_t, std::vector<Problem>>> passed_over;
  for (const std::size_t k : order) {
    Expected<Attempt> attempt = readAttempt(files[k].file, ReadDepth::NoHipSamples);
    if (!attempt)
      passed_over.push_back({k, {attempt.problem()}});
    else {
      take(*attempt);
      if (!attempt->problems.empty()) passed_over.emplace_back(k, std::move(attempt->problems));
    }
  }
  std::sort(passed_over.begin(), passed_over.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [file, problems] : passed_over)
    out.insert(out.end(), std::make_move_iterator(problems.begin()), std::make_move_iterator(problems.end()));
  return out;
}

ClassReading readClass(std::span<const fs::path> files_and_folders, const NamesShown& names) {
  ClassReading out;
  ClassCount count(names);
  out.passed_over = forEachAttempt(files_and_folders, [&](const Attempt& attempt) { count.add(attempt); });
  out.summary = count.finish();
  return out;
}

}  // namespace moltact
