#include "engine/pack/pack_lesson.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <system_error>

#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/check.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/lesson/lesson_texts.h"
#include "engine/lesson/second_state.h"
#include "engine/lesson/tasks/guided.h"
#include "engine/pack/pack_file.h"
#include "engine/pack/pack_name.h"
#include "engine/pack/write_pack.h"
#include "engine/platform/folders.h"
#include "engine/platform/read_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

bool isWithin(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path there = fs::weakly_canonical(file, error).lexically_relative(fs::weakly_canonical(folder, error));
  return !there.empty() && *there.begin() != "..";
}

class Gathering {
 public:
  explicit Gathering(const fs::path& lesson_file) : first_(lesson_file), top_(lesson_file.parent_path()) {}

  PackedLesson run() {
    take(first_.filename(), {first_.string()});
    while (!lessons_.empty() && out_.errors.size() < kEnough) {
      const fs::path next = std::move(lessons_.front());
      lessons_.pop_front();
      lesson(next);
    }
    if (out_.errors.empty()) pack();
    return std::move(out_);
  }

 private:
  static constexpr std::size_t kEnough = 500;
  struct At {
    std::string file;
    Place place = {};
  };

  void error(const At& at, std::string message, std::string remedy) {
    out_.errors.push_back({at.file, at.place.line, at.place.column, std::move(message), std::move(remedy)});
  }

  // Adds a file by its name relative to the first lesson's folder; `at` is where it is referenced. Lessons are examined
  // later.
  void take(const fs::path& named, const At& at) {
    const fs::path relative = named.lexically_normal();
    const std::string name = relative.generic_string();
    if (files_.contains(name)) return;
    if (const std::string fault = packNameFault(name); !fault.empty())
      return error(at, trf("'{0}' cannot be packed: its name {1}", name, fault),
                   tr("put the file into the lesson's folder, under another name where need be"));
    if (const auto [twin, is_new] = folded_.emplace(foldedPackName(name), name); !is_new)
      return error(at, trf("'{0}' and '{1}' would be one file on some computers", name, twin->second),
                   tr("rename one of them"));
    if (foldedPackName(name) == kPackManifest)
      return error(at, trf("'{0}' cannot be packed: a pack has a file of its own of this name", name), tr("rename it"));
    std::error_code ignored;
    if (fs::is_directory(top_ / relative, ignored))
      return error(at, trf("'{0}' cannot be packed: it is a folder", name), tr("name a file in it"));
    // The author has named the lesson itself; links of other files may lead anywhere.
    if (relative != first_.filename() && !isWithin(top_ / relative, top_.empty() ? fs::path(".") : top_))
      return error(at, trf("'{0}' cannot be packed: it is a link to a file outside of the lesson's folder", name),
                   tr("put a copy of the file in the place of the link"));
    Expected<std::string> bytes = readFile(top_ / relative, kMaxUnpacked, tr("pack smaller molecules"));
    if (!bytes) return out_.errors.push_back(bytes.problem());
    whole_ += bytes->size();
    if (whole_ > kMaxUnpacked || files_.size() >= kMaxPackEntries - 1)
      return error(at, trf("the files are more than {0} MiB, or more than {1}", kMaxUnpacked >> 20, kMaxPackEntries),
                   tr("pack fewer or smaller ones"));
    files_.emplace(name, *std::move(bytes));
    if (lower(relative.extension().string()) == ".md" &&
        (relative == first_.filename() || looksLikeLesson(top_ / relative)))
      lessons_.push_back(relative);
  }

  void lesson(const fs::path& relative) {
    const fs::path file = top_ / relative, folder = relative.parent_path();
    sameFolder(relative);
    LessonCheck check = checkLesson(file.string(), files_.at(relative.generic_string()),
                                    [&](const NamedMolecule& named) { return molecules_.find(file, named); });
    out_.warnings.insert(out_.warnings.end(), check.warnings.begin(), check.warnings.end());
    if (!check.errors.empty() || !check.lesson) {
      out_.errors.insert(out_.errors.end(), check.errors.begin(), check.errors.end());
      return;
    }
    // "name" relative to the lesson's folder, where the check has found it.
    const auto beside = [&](const std::string& link, Place place) {
      if (const auto to = fileLink("lesson.md", link)) take(folder / to->file, {file.string(), place});
    };
    forEachText(*check.lesson, [&](const RichText& text) {
      for (const TextRun& run : text)
        if (!run.link.empty() && !run.link.starts_with('#')) beside(run.link, run.link_place);
    });
    forEachImage(*check.lesson, [&](const Image& image) {
      if (!image.path.empty()) beside(image.path, image.place);
    });
    for (const Step& step : check.lesson->steps)
      for (const NamedMolecule& named : {step.scene.molecule, secondMolecule(step.scene), besideMolecule(step.scene)})
        if (!named.name.empty()) molecule(file, folder, named, step.scene.places.molecule);
    for (const Step& step : check.lesson->steps) {
      simulation(file, folder, step.scene);
      trajectory(file, folder, step.scene);
      for (const TaskSpec& task : step.tasks)
        if (const std::string hand = guideFile(task); !hand.empty())
          take(folder / hand, {file.string(), task.values["guide-path"].place});
    }
  }

  // Adds the translations, and the glossary shared by the lessons of its folder.
  void sameFolder(const fs::path& relative) {
    std::error_code error;
    std::vector<fs::path> same;
    const std::string id = lessonName(relative).id;
    const fs::path folder = (top_ / relative).has_parent_path() ? (top_ / relative).parent_path() : fs::path(".");
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
      if ((it->path().extension() == ".md" && lessonName(it->path()).id == id) || isGlossaryFile(it->path()))
        same.push_back(it->path().filename());
    std::sort(same.begin(), same.end());
    for (const fs::path& name : same) take(relative.parent_path() / name, {(top_ / relative).string()});
  }

  void molecule(const fs::path& lesson_file, const fs::path& folder, const NamedMolecule& named, Place place) {
    const Expected<MoleculeKey> key = lessonMolecule(lesson_file, named);
    if (!key) return;  // already reported by the check
    const At at{lesson_file.string(), place};
    if (isWithin(key->file, moleculesFolder())) {
      library_.insert(named.name);
    } else if (isWithin(key->file, userMoleculesFolder())) {
      fetched(key->file, folder, at);
    } else {
      const fs::path beside = lesson_file.has_parent_path() ? lesson_file.parent_path() : fs::path(".");
      take(folder / key->file.lexically_proximate(beside), at);
    }
  }

  // A system beside a molecule of the library stays there.
  void simulation(const fs::path& lesson_file, const fs::path& folder, const SceneSpec& scene) {
    if (scene.simulation.empty()) return;
    const Expected<MoleculeKey> key = lessonMolecule(lesson_file, scene.molecule);
    if (!key) return;
    const auto system = simulationFile(lesson_file, *key, scene.simulation);
    if (system && !isWithin(*system, moleculesFolder()))
      take(folder / scene.simulation, {lesson_file.string(), scene.places.simulation});
  }

  // So does a trajectory.
  void trajectory(const fs::path& lesson_file, const fs::path& folder, const SceneSpec& scene) {
    if (scene.trajectory.file.empty()) return;
    const Expected<MoleculeKey> key = lessonMolecule(lesson_file, scene.molecule);
    if (!key) return;
    const auto file = trajectoryFile(lesson_file, *key, scene.trajectory.file);
    if (file && !isWithin(*file, moleculesFolder()))
      take(folder / scene.trajectory.file, {lesson_file.string(), scene.places.trajectory});
  }

  // Adds a downloaded file beside the lesson, where its name is searched.
  void fetched(const fs::path& file, const fs::path& folder, const At& at) {
    const std::string name = (folder / file.filename()).generic_string();
    if (files_.contains(name)) return;
    if (const std::string fault = packNameFault(name); !fault.empty())
      return error(at, trf("'{0}' cannot be packed: its name {1}", name, fault), tr("put the file beside the lesson"));
    Expected<std::string> bytes = readFile(file, kMaxUnpacked, tr("pack smaller molecules"));
    if (!bytes) return out_.errors.push_back(bytes.problem());
    whole_ += bytes->size();
    folded_.emplace(foldedPackName(name), name);
    files_.emplace(name, *std::move(bytes));
  }

  void pack() {
    Expected<std::string> bytes = writePack(first_.filename().string(), files_);
    if (!bytes) return out_.errors.push_back({first_.string(), 0, 0, bytes.problem().message, bytes.problem().remedy});
    Packed packed{*std::move(bytes), {}, {library_.begin(), library_.end()}};
    for (const auto& [name, content] : files_) packed.files.push_back(name);
    // Verifies that a recipient can open the pack.
    if (const auto opened = PackFile::ofBytes(first_.filename().replace_extension(kPackEnding).string(), packed.bytes);
        !opened)
      return out_.errors.push_back(opened.problem());
    out_.pack = std::move(packed);
  }

  const fs::path first_, top_;
  PackedLesson out_;
  std::map<std::string, std::string> files_, folded_;
  std::set<std::string> library_;
  std::deque<fs::path> lessons_;  // still to be examined
  std::size_t whole_ = 0;
  LessonMolecules molecules_;
};

}  // namespace

PackedLesson packLesson(const fs::path& lesson_file) { return Gathering(lesson_file).run(); }

}  // namespace moltact
