#include "app/ui/application/application.h"

#include <algorithm>
#include <utility>

#include "app/ui/scene/view_picture.h"
#include "app/ui/widgets/theme.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/lesson_region.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/molecule/catalogue.h"
#include "engine/platform/use_language.h"
#include "engine/render/molecule_model.h"

namespace moltact {
namespace {

bool anyOf(std::span<Extension* const> all, bool (Extension::*says)() const) {
  return std::any_of(all.begin(), all.end(), [says](const Extension* e) { return (e->*says)(); });
}

}  // namespace

Application::Application(ApplicationOptions given, ApplicationParts parts)
    : scene(given.clock),
      options_(std::move(given)),
      picture_(std::make_unique<ViewPicture>(options_.clock == ServoClock::Frames)),
      extensions_(parts.extensions(*this)),
      keys_(parts.keys),
      panels_(parts.panels) {
  scene.look.shown = lesson.shownParts();
  std::string fault;
  if (!options_.settings_file.empty()) {
    LoadedSettings loaded = loadSettings(options_.settings_file);
    settings = std::move(loaded.settings);
    fault = std::move(loaded.fault);
  }
  useLanguageAndUnits();
  if (!fault.empty()) messages.warning(fault);
  for (Extension* e : extensions_->all()) e->atStart();
}

Application::~Application() { end(); }

void Application::useLanguageAndUnits() {
  setDecimalSign(settings.decimal_sign);
  UnitSet shown;
  for (const auto& [dimension, unit] : settings.units) shown.choose(dimension, unit);
  setShownUnits(shown);
  if (spoken_ == settings.language) return;
  // The language given at the start applies until the user chooses another.
  std::string wanted = settings.language;
  if (!spoken_ && !options_.language.empty()) wanted = options_.language;
  if (!spoken_ && options_.language.empty() && !languageOfEnvironment().empty()) wanted = {};
  spoken_ = settings.language;
  if (const auto problem = useLanguage(wanted)) messages.warning(problem->text());
}

void Application::end() {
  if (std::exchange(ended_, true)) return;
  scene.servo().endForce();
  for (Extension* e : extensions_->all()) e->atEnd();
}

void Application::open(const std::filesystem::path& file) {
  // A name without an extension may be a molecule of the library.
  const FileKind kind = fileKind(file).value_or(FileKind::Molecule);
  for (Extension* e : extensions_->all()) e->beforeOpening(kind);
  for (Extension* e : extensions_->all())
    if (e->open(kind, file)) return;
  if (kind == FileKind::Lesson) return openLesson(file);
  const Expected<std::filesystem::path> found = findMolecule(file.string(), MoleculeFolders::ofThisComputer());
  if (!found) {
    messages.error(found.problem().text());
    panels.pages.welcome = panels.pages.welcome || !hasWork();
    return;
  }
  openMolecule({*found});
}

void Application::openMolecule(const MoleculeKey& key) {
  step_scene_ = false;
  loader_.begin(key);
  if (options_.clock == ServoClock::Frames) finishLoading();
}

void Application::openLesson(const std::filesystem::path& file) {
  if (!lesson.open(file)) {
    for (Extension* e : extensions_->all()) e->lessonRefused(file);
    panels.pages.welcome = panels.pages.welcome || !hasWork();
    return;
  }
  messages.clearErrors();
  settings.remember(file);
  panels.lesson = panels.lesson_first = true;
  panels.pages.welcome = panels.lesson_memory.teacher_notes = false;
  panels.lesson_memory.goals.reset();
  enterScene();
}

void Application::drop(const std::vector<std::filesystem::path>& dropped) {
  if (dropped.empty()) return;
  open(dropped.front());
  if (dropped.size() > 1) messages.notice(trf("Of {0} files the first was opened.", dropped.size()));
}

void Application::showMolecule(const MoleculeKey& key) {
  step_scene_ = true;
  loader_.begin(key);
  if (options_.clock == ServoClock::Frames) finishLoading();
}

void Application::enterScene() {
  notifyStepChanged();
  const SceneSpec* spec = lesson.takeNewScene();
  if (!spec) return;
  scene.setTouch(spec->touch);
  scene.look.shown = lesson.shownParts();
  scene.look.colour_by = colourBy(*spec);
  panels.tabs.applyLesson(spec->panels);
  measureView();
  if (scene.stage()) lesson.setMolecule(scene.stage().molecule, scene.molecule());
  scene.look.atoms = lesson.looks();
  const Expected<MoleculeKey> molecule = lesson.molecule();
  if (!molecule) {
    messages.error(molecule.problem().text());
    return;
  }
  if (*molecule == scene.molecule() && scene.stage() && !loader_.busy()) {
    scene.view().fit.region = lesson.region();
    scene.view().fit.zoomed = lesson.zoomed();
    beginSceneAgain();
    return;
  }
  showMolecule(*molecule);
}

void Application::beginSceneAgain(std::optional<PointA> before, const std::optional<Quat>& turned,
                                  const std::vector<std::uint32_t>& removed,
                                  const std::vector<std::uint32_t>& in_hand) {
  // The interaction is rebuilt if other atoms are excluded from touch, or held.
  if (TouchableModel felt = withUntouchable(scene.atoms().resting(), atomsOfEither(lesson.untouchable(), removed),
                                            in_hand.empty() ? lesson.held() : in_hand);
      felt.spheres != scene.stage().spheres)
    scene.show(std::move(felt), scene.molecule(), facing());
  if (before)
    scene.view().beginAgainAt(*before);
  else if (turned)
    scene.view().beginAgain([&](Camera& camera, const Molecule&) { camera.orientation = *turned; });
  else
    scene.view().beginAgain(facing());
  if (!before && !turned) cutOpen();
  warnWithoutBody();
  for (Extension* e : extensions_->all()) e->sceneChanged();
}

// An unchecked lesson may require a body without atoms or with too many.
void Application::warnWithoutBody() {
  if (scene.stage().body || !lesson.session()) return;
  const SceneSpec& spec = lesson.session()->scene();
  if (!lesson.onStage() || !spec.in_hand.given()) return;
  if (lesson.held().empty()) {
    Problem why = spec.in_hand.whyEmpty(*scene.stage().molecule);
    const Place place = spec.places.in_hand;
    messages.warning(Problem{lesson.file().string(), place.line, place.column + why.column - 1,
                             trf("the hand holds nothing: {0}", why.message), std::move(why.remedy)}
                         .text());
    return;
  }
  messages.warning(
      Problem{lesson.file().string(), lesson.session()->scene().places.in_hand.line, 0,
              trf("{0} atoms are more than a hand can hold; {1} are the most", lesson.held().size(), kMaxHeldAtoms),
              tr("name fewer: a ligand, a side chain")}
          .text());
}

void Application::notifyStepChanged() {
  if (!lesson.session()) return;
  const bool opened = shown_opening_ != lesson.openings(), moved = shown_step_ != lesson.session()->stepIndex();
  shown_opening_ = lesson.openings();
  shown_step_ = lesson.session()->stepIndex();
  if (opened)
    for (Extension* e : extensions_->all()) e->lessonChanged();
  if (opened || moved)
    for (Extension* e : extensions_->all()) e->stepChanged();
}

void Application::finishLoading() {
  if (std::optional<Loaded> loaded = loader_.wait()) onLoaded(std::move(*loaded));
}

void Application::onLoaded(Loaded loaded) {
  const bool from_step = std::exchange(step_scene_, false);
  if (!loaded.stage) {
    messages.error(loaded.stage.problem().text());
    panels.pages.welcome = panels.pages.welcome || !hasWork();
    return;
  }
  messages.clearErrors();
  if (const std::string notice = residueSpheresNotice(loaded.stage->molecule->atoms.size()); !notice.empty())
    messages.notice(notice);
  // In a lesson's scene the author knows what the file omits, so no notice is shown.
  if (!from_step) {
    for (const std::string& warning : loaded.stage->molecule->warnings) messages.notice(warning);
    settings.remember(loaded.key.file);
    scene.look.colour_by = usualColourBy(*loaded.stage->molecule);
  }
  panels.pages.welcome = false;
  measureView();
  lesson.setMolecule(loaded.stage->molecule, loaded.key);
  scene.look.atoms = lesson.looks();
  scene.view().fit.region = lesson.region();
  scene.view().fit.zoomed = lesson.zoomed();
  scene.show(withUntouchable(*loaded.stage, lesson.untouchable(), lesson.held()), loaded.key, facing());
  cutOpen();
  warnWithoutBody();
  for (Extension* e : extensions_->all()) e->sceneChanged();
}

Facing Application::facing() const {
  return [this](Camera& camera, const Molecule& molecule) { lesson.face(camera, molecule); };
}

void Application::cutOpen() {
  if (!scene.stage()) return;
  lesson.cutFor(scene.camera, *scene.stage().molecule);
  scene.look.atoms.cut = lesson.looks().cut;
}

void Application::showView(const ViewSpec& view) {
  if (!scene.stage()) return;
  const Molecule& molecule = *scene.atoms().seen();
  const SceneSpec spec = lesson.session() && lesson.onStage() ? lesson.session()->scene() : SceneSpec();
  const Camera seen = scene.camera;
  scene.camera = scene.view().cameraFor([&](Camera& camera, const Molecule& m) { faceView(camera, m, view, spec); },
                                        zoomedRegion(view, spec, molecule, scene.servo_settings.probe_A));
  for (Extension* e : extensions_->all()) e->viewReset(seen);
}

void Application::zoomTo(std::span<const std::uint32_t> atoms) {
  const TouchableModel& stage = scene.stage();
  const auto part = stage ? regionAround(atoms, *scene.atoms().seen(), scene.servo_settings.probe_A) : std::nullopt;
  if (!part) return;
  const Camera seen = scene.camera;
  // From outside; for atoms inside, whatever is in front of them.
  scene.camera.target = stage.middle;
  scene.camera.face(part->centre);
  const glm::vec2 view = layout_.view.size();
  scene.camera.fit(part->centre, part->radius_A, view.y > 0 ? double(view.x) / double(view.y) : 1.0);
  for (Extension* e : extensions_->all()) e->viewReset(seen);
}

void Application::comeCloseTo(PointA place) {
  constexpr double kAround_A = 7.0;
  if (!scene.stage()) return;
  const glm::vec2 view = layout_.view.size();
  const Camera seen = scene.camera;
  scene.camera.fit(place, kAround_A, view.y > 0 ? double(view.x) / double(view.y) : 1.0);
  if (scene.camera.distance_A >= seen.distance_A) {
    scene.camera = seen;  // the view is already close
    return;
  }
  for (Extension* e : extensions_->all()) e->viewReset(seen);
}

void Application::resetView() { scene.view().reset(facing()); }

void Application::resetViewByHand() {
  const Camera seen = scene.camera;
  resetView();
  for (Extension* e : extensions_->all()) e->viewReset(seen);
}

void Application::askForPictureAs() {
  file_dialog.ask({.title = tr("Save the view as a picture"),
                   .name = freePictureName(options_.picture_folder).filename().string(),
                   .ending = ".png",
                   .chosen = [this](const std::filesystem::path& file) { askForPicture(file); }},
                  options_.picture_folder);
}

Layout Application::layoutNow() const {
  return layOut({.window = window_px_,
                 .scale = look().scale * look().text,
                 .lesson = panels.lesson && lesson.session() && !anyOf(extensions_->all(), &Extension::hidesLesson),
                 .touch = panels.tabs.shown(),
                 .page = panels.pages.welcome,
                 .lesson_width = float(settings.lesson_width),
                 .touch_width = float(settings.touch_width),
                 .strip_height = extensions_->stripHeight(),
                 .below_share = panels.window.below_share},
                panels.lesson_first);
}

// A scene that is entered within a frame opens and closes panels, which are laid out in the next frame. It is fitted to
// the view of that frame.
void Application::measureView() {
  if (!(window_px_.x > 0.0f)) return;
  const glm::vec2 view = layoutNow().view.size();
  scene.view().fit.view_aspect = view.y > 0 ? double(view.x) / double(view.y) : 1.0;
}

void Application::layPanelsOut(glm::vec2 window_px) {
  window_px_ = window_px;
  layout_ = layoutNow();
  if (panels.pages.welcome) return;
  measureView();
  // Refits the first picture of a scene once the real view is known.
  if (aspect_guessed_ && scene.stage()) {
    aspect_guessed_ = false;
    resetView();
  }
}

void Application::frame(double dt_s, glm::vec2 window_px) {
  time_ = {dt_s, time_.now_s + dt_s};
  if (std::optional<Loaded> loaded = loader_.take()) onLoaded(std::move(*loaded));
  loading_s_ = loader_.busy() ? loading_s_ + dt_s : 0.0;
  const std::span<Extension* const> extensions = extensions_->all();
  for (Extension* e : extensions) e->beforeTicks();
  scene.force().rest(panels.pages.welcome);
  const FeltTicks felt = scene.advance(dt_s, time_.now_s, panels.tabs.front() == "methods");
  // A recorded hand does no task.
  const bool mouse = &scene.servo().device() == &scene.servo().mouse().info();
  if (!anyOf(extensions, &Extension::leadsHand))
    for (const FeltTick& t : felt.ticks)
      lesson.feed(t.sample, felt.method.name, t.exact, mouse && !scene.controls.pressing());
  if (!felt.ticks.empty())
    for (Extension* e : extensions) e->ticks(felt);
  messages.age(dt_s);

  useLanguageAndUnits();
  keys_(*this);
  layPanelsOut(window_px);
  panels_(*this);
  enterScene();
  if (LessonSession* session = lesson.session())
    if (const std::vector<SessionEvent> events = session->takeEvents(); !events.empty())
      for (Extension* e : extensions) e->lessonEvents(events);
  for (Extension* e : extensions) e->afterPanels();
}

bool Application::live() const {
  return scene.live() || loader_.busy() || messages.anyTimed() || picture_->unfinished() ||
         anyOf(extensions_->all(), &Extension::live);
}

}  // namespace moltact
