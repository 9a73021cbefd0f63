// The table and the sentences of a matrix that runs methods through scenes and judges each run by criteria with a letter.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/bench/report_table.h"

namespace moltact::bench {

/// A criterion, its name in sentences and its value.
template <class Result>
struct FailureCriterion {
  char letter;
  const char* fails;
  double (*value)(const Result&);
};

/// The runs of a matrix. `Result` has the members `scene` and `draw`; both functions belong to a run.
template <class Result>
class FailureMatrix {
 public:
  FailureMatrix(const std::vector<Result>& results, std::span<const FailureCriterion<Result>> criteria,
                std::function<std::string_view(const Result&)> method_name,
                std::function<std::string(const Result&)> failures)
      : results_(results), criteria_(criteria), method_of_(std::move(method_name)), failures_(std::move(failures)) {
    const auto note = [](std::vector<std::string>& all, std::string_view name) {
      if (std::find(all.begin(), all.end(), name) == all.end()) all.emplace_back(name);
    };
    for (const Result& r : results) note(scenes_, r.scene), note(methods_, method_of_(r));
  }

  /// In the order of the results.
  const std::vector<std::string>& scenes() const { return scenes_; }
  const std::vector<std::string>& methods() const { return methods_; }
  std::size_t draws() const {
    std::size_t out = 0;
    for (const Result& r : results_) out = std::max(out, r.draw + 1);
    return out;
  }
  /// The greatest value of all draws.
  double greatest(std::string_view scene, std::string_view method, double (*value)(const Result&)) const {
    double out = 0;
    eachRun(scene, method, [&](const Result& r) { out = std::max(out, value(r)); });
    return out;
  }

  /// Adds a column per method and a row per scene: the failures, their greatest value and the number of draws.
  void addTo(ReportTable& table) const {
    for (const std::string& m : methods_) table.columns.push_back({m, m});
    for (const std::string& scene : scenes_) {
      std::vector<Cell> row{scene};
      for (const std::string& m : methods_) row.push_back(cell(scene, m));
      table.rows.push_back(std::move(row));
    }
  }

  /// A Markdown item per method: in how many scenes it is sound, and in which (in quotation marks) it fails how.
  std::string sentences() const {
    std::string out;
    for (const std::string& m : methods_) {
      std::size_t sound = 0;
      std::map<char, std::vector<std::string>> failing;
      for (const std::string& scene : scenes_) {
        std::string letters;
        eachRun(scene, m, [&](const Result& r) { letters += failures_(r); });
        sound += letters.empty();
        for (const auto& c : criteria_)
          if (letters.find(c.letter) != std::string::npos) failing[c.letter].push_back('"' + scene + '"');
      }
      out +=
          "* `" + m + "` is sound in " + std::to_string(sound) + " of " + std::to_string(scenes_.size()) + " scenes.";
      for (const auto& c : criteria_)
        if (const auto found = failing.find(c.letter); found != failing.end())
          out += std::string(" It ") + c.fails + " in " +
                 (found->second.size() == scenes_.size() ? "all of them." : listedApart(found->second) + ".");
      out += '\n';
    }
    return out;
  }

 private:
  template <class Visit>
  void eachRun(std::string_view scene, std::string_view method, Visit&& visit) const {
    for (const Result& r : results_)
      if (r.scene == scene && method_of_(r) == method) visit(r);
  }
  std::string cell(std::string_view scene, std::string_view method) const {
    std::string out;
    for (const auto& c : criteria_) {
      std::size_t failed = 0;
      eachRun(scene, method, [&](const Result& r) { failed += failures_(r).find(c.letter) != std::string::npos; });
      if (failed)
        out += (out.empty() ? "" : ", ") + std::string(1, c.letter) + ' ' + readable(greatest(scene, method, c.value)) +
               " (" + std::to_string(failed) + ')';
    }
    return out.empty() ? "sound" : out;
  }

  const std::vector<Result>& results_;
  std::span<const FailureCriterion<Result>> criteria_;
  std::function<std::string_view(const Result&)> method_of_;
  std::function<std::string(const Result&)> failures_;
  std::vector<std::string> scenes_, methods_;
};

}  // namespace moltact::bench
