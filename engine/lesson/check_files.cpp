// Checks links to files, and pictures.
#include <algorithm>
#include <map>
#include <optional>
#include <system_error>

#include "engine/dynamics/simulation_engines.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/checks.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/lesson/lesson_picture.h"
#include "engine/lesson/lesson_texts.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/suggestion.h"

namespace moltact::checks {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxNames = 300;  // of a folder, that are compared with a missing name

/// "did you mean 'ring.png'?", from the existing files.
std::string nearestFile(const fs::path& missing, std::map<fs::path, std::vector<std::string>>& names_in) {
  const fs::path folder = missing.has_parent_path() ? missing.parent_path() : fs::path(".");
  const auto [at, is_new] = names_in.try_emplace(folder);
  std::vector<std::string>& names = at->second;
  std::error_code error;
  if (is_new)
    for (fs::directory_iterator it(folder, error), end; !error && it != end && names.size() < kMaxNames;
         it.increment(error))
      names.push_back(it->path().filename().string());
  std::sort(names.begin(), names.end());
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string_view near = nearest(missing.filename().string(), known);
  return near.empty() ? tr("put it there, or mend its name; it is looked for in the lesson's folder")
                      : didYouMean(near);
}

bool leavesFolder(std::string_view written) {
  const fs::path path = fs::path(std::string(written)).lexically_normal();
  return !path.empty() && *path.begin() == "..";
}

class Files {
 public:
  Files(const fs::path& lesson_file, Findings& findings) : lesson_file_(lesson_file), findings_(findings) {}

  void link(std::string_view link, Place place) {
    if (findings_.enough()) return;
    const std::string_view scheme = linkScheme(link);
    if (scheme == "http" || scheme == "https" || scheme == "mailto") return;
    if (!scheme.empty())
      findings_.error(place, trf("the link '{0}' leads to nothing that a lesson can show", link),
                      tr("link to a step (#…), a file beside the lesson or a web address (https://…)"));
    else if (const auto to = fileLink(lesson_file_, link);
             to && isThere(What::Link, link, to->file, place) && !to->step.empty())
      stepOf(*to, place);
  }

  void picture(const Image& image) {
    if (image.path.empty() || findings_.enough()) return;
    const auto to = fileLink(lesson_file_, image.path);
    if (!to) {
      findings_.error(image.place, trf("the picture '{0}' is not beside the lesson", image.path),
                      tr("put the file beside the lesson and write its name"));
    } else if (isThere(What::Picture, image.path, to->file, image.place)) {
      if (const auto& fault = faultOf(to->file))
        findings_.error(image.place, trf("'{0}' cannot be shown: {1}", image.path, fault->message), fault->remedy);
    }
  }

  /// The window checks that the system fits the molecule.
  void simulation(const SceneSpec& scene) {
    if (scene.simulation.empty() || findings_.enough()) return;
    const Place place = scene.places.simulation;
    if (simulationAddress(scene.simulation))
      return findings_.warning(place, tr("a page in a browser has no TCP: it shows this molecule at rest"),
                               tr("have students use the desktop program"));
    const Expected<MoleculeKey> molecule = lessonMolecule(lesson_file_, scene.molecule);
    if (!molecule) return;  // reported with the molecules
    if (fs::path(scene.simulation).is_absolute() || leavesFolder(scene.simulation))
      findings_.error(place, trf("'{0}' lies outside of the lesson's folder, so no pack can hold it", scene.simulation),
                      tr("put the file beside the lesson and write its name"));
    else if (const auto file = simulationFile(lesson_file_, *molecule, scene.simulation); !file)
      findings_.error(place, file.problem().message, file.problem().remedy);
  }

  /// The window checks that the frames fit the molecule.
  void trajectory(const SceneSpec& scene) {
    const std::string& name = scene.trajectory.file;
    if (name.empty() || findings_.enough()) return;
    const Expected<MoleculeKey> molecule = lessonMolecule(lesson_file_, scene.molecule);
    if (!molecule) return;  // reported with the molecules
    if (fs::path(name).is_absolute() || leavesFolder(name))
      findings_.error(scene.places.trajectory,
                      trf("'{0}' lies outside of the lesson's folder, so no pack can hold it", name),
                      tr("put the file beside the lesson and write its name"));
    else if (const auto file = trajectoryFile(lesson_file_, *molecule, name); !file)
      findings_.error(scene.places.trajectory, file.problem().message, file.problem().remedy);
  }

 private:
  /// Each file is decoded once, even if it is shown repeatedly or by several paths.
  const std::optional<Problem>& faultOf(const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(file, error);
    const auto [at, is_new] = faults_of_.try_emplace(error ? file : whole);
    if (is_new)
      if (const auto picture = readLessonPicture(file); !picture) at->second = picture.problem();
    return at->second;
  }

  enum class What { Link, Picture };

  bool isThere(What what, std::string_view written, const fs::path& file, Place place) {
    std::error_code error;
    if (written.starts_with('/'))
      findings_.error(place,
                      what == What::Link ? trf("the link '{0}' leads to a place of this computer only", written)
                                         : trf("the picture '{0}' leads to a place of this computer only", written),
                      tr("put the file beside the lesson and write its name"));
    else if (what == What::Picture && leavesFolder(written))
      findings_.error(place, trf("'{0}' lies outside of the lesson's folder, so no pack can hold it", written),
                      tr("put the file beside the lesson and write its name"));
    else if (!fs::exists(file, error))
      findings_.error(place,
                      what == What::Link ? trf("the link '{0}' leads to no file", written)
                                         : trf("the picture '{0}' leads to no file", written),
                      nearestFile(file, names_in_));
    else
      return true;
    return false;
  }

  /// Checks that the step of a link to another lesson exists. Other Markdown files have their own rules for headings.
  void stepOf(const FileLink& link, Place place) {
    if (link.file.extension() != ".md") return;
    const auto [at, is_new] = steps_of_.try_emplace(link.file);
    std::vector<std::string>& steps = at->second;
    if (is_new) {
      const LessonReading other = readLesson(link.file);
      const Lesson* lesson = other.lesson ? &*other.lesson : other.partial ? &*other.partial : nullptr;
      if (lesson && !lesson->title.empty())
        for (const Step& s : lesson->steps) steps.push_back(s.id);
    }
    if (steps.empty() || std::find(steps.begin(), steps.end(), link.step) != steps.end()) return;
    const std::vector<std::string_view> ids(steps.begin(), steps.end());
    findings_.error(place, trf("there is no step '#{0}' in {1}", link.step, link.file.filename().string()),
                    suggest(link.step, ids, tr("steps")));
  }

  const fs::path& lesson_file_;
  Findings& findings_;
  std::map<fs::path, std::vector<std::string>> names_in_;  // folders listed so far
  std::map<fs::path, std::optional<Problem>> faults_of_;   // pictures decoded so far
  std::map<fs::path, std::vector<std::string>> steps_of_;  // lessons read so far, with the ids of their steps
};

}  // namespace

void words(const Lesson& lesson, const fs::path& lesson_file, Findings& findings) {
  std::optional<Lesson> with_shared;  // only if a link refers to a word
  forEachText(lesson, [&](const RichText& text) {
    for (const TextRun& run : text) {
      const std::optional<std::string> to = wordLink(run.link);
      if (!to || findings.enough()) continue;
      if (!with_shared) {
        with_shared.emplace();
        with_shared->glossary = lesson.glossary;
        linkWords(*with_shared, glossaryBeside(lesson_file, lesson.language));
      }
      if (findWord(*with_shared, *to)) continue;
      std::vector<std::string> ids;
      for (const GlossaryWord& word : with_shared->glossary) ids.push_back(slug(word.word));
      const std::vector<std::string_view> known(ids.begin(), ids.end());
      findings.error(run.link_place, trf("the glossary has no word '{0}'", *to),
                     known.empty() ? tr("write it below '## Glossary', or into the file glossary.md beside the lesson")
                                   : suggest(*to, known, tr("words")));
    }
  });
}

void files(const Lesson& lesson, const fs::path& lesson_file, Findings& findings) {
  Files check(lesson_file, findings);
  forEachText(lesson, [&](const RichText& text) {
    for (const TextRun& run : text)
      if (!run.link.empty() && !run.link.starts_with('#')) check.link(run.link, run.link_place);
  });
  forEachImage(lesson, [&](const Image& image) { check.picture(image); });
  for (const Step& step : lesson.steps)
    if (step.states_scene) {
      check.simulation(step.scene);
      check.trajectory(step.scene);
    }
}

}  // namespace moltact::checks
