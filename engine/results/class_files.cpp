#include "engine/results/class_files.h"

#include <set>
#include <system_error>
#include <utility>

#include "engine/language/catalogue.h"

namespace moltact {

ClassFiles readClass(std::span<const std::filesystem::path> files_and_folders) {
  ClassFiles out;
  std::set<std::filesystem::path> met;
  for (const std::filesystem::path& named : files_and_folders) {
    const Expected<std::vector<std::filesystem::path>> files = attemptFiles(named, true);
    if (!files) {
      out.passed_over.push_back(files.problem());
      continue;
    }
    if (files->empty())
      out.passed_over.push_back({named.string(), 0, 0, tr("there are no .jsonl files in this folder"),
                                 tr("name the folder that holds the attempts")});
    for (const std::filesystem::path& file : *files) {
      std::error_code error;
      const std::filesystem::path whole = std::filesystem::weakly_canonical(file, error);
      if (!met.insert(error ? file : whole).second) continue;
      Expected<Attempt> attempt = readAttempt(file, ReadDepth::NoHipSamples);
      if (!attempt) {
        out.passed_over.push_back(attempt.problem());
        continue;
      }
      out.passed_over.insert(out.passed_over.end(), attempt->problems.begin(), attempt->problems.end());
      out.attempts.push_back(*std::move(attempt));
    }
  }
  return out;
}

}  // namespace moltact
