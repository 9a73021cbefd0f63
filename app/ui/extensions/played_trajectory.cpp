#include "app/ui/extensions/played_trajectory.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>

#include "app/ui/application/application_options.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/widgets/messages.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/lesson/second_state.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// The most frames that are read ahead, and the part of the file that is searched for further frames in one task.
constexpr std::size_t kMaxAhead = 6;
constexpr std::uint64_t kSearched_bytes = std::uint64_t{32} << 20;

// "not superposed", or the selection; then "; smoothed 2".
constexpr std::string_view kFluctuation = "fluctuation";  // a ColouringScheme
constexpr std::string_view kNotSuperposed = "not superposed", kSmoothed = "; smoothed ";

FrameFit fitOf(const TrajectorySpec& spec, const Molecule& molecule) {
  return {spec.superposed,
          spec.superposed_on.given() ? spec.superposed_on.select(molecule) : std::vector<std::uint32_t>()};
}

std::string fitText(const TrajectorySpec& spec) {
  return spec.superposed ? std::string(spec.superposed_on.text()) : std::string(kNotSuperposed);
}

}  // namespace

PlayedTrajectory::Reading PlayedTrajectory::readingOf(std::shared_ptr<FrameStore> store,
                                                      const std::vector<std::size_t>& frames, std::size_t smoothing,
                                                      bool find_more) {
  Reading out;
  out.store = store;
  try {
    if (find_more) store->file().findMore(kSearched_bytes);
    for (const std::size_t frame : frames) {
      if (frame >= store->file().frames()) continue;
      auto positions = store->at(frame, smoothing);
      if (!positions) {
        out.problem = positions.problem();
        out.failed = frame;
        break;
      }
      out.placed.push_back({frame, {*positions, store->time_ps(frame), store->leapLimit_A(frame)}});
    }
  } catch (const std::exception& e) {
    out.problem = Problem{{}, 0, 0, trf("the frames cannot be read: {0}", e.what()), {}};
  }
  out.frames = store->file().frames();
  out.complete = store->file().complete();
  out.warnings = store->file().warnings();
  return out;
}

void PlayedTrajectory::forget() {
  own_.release();
  opening_.drop();
  reading_.drop();
  surveying_.drop();
  store_.reset();
  survey_.reset();
  scene_.look.fluctuation_A.clear();
  painted_.reset();
  survey_begun_ = warned_ = false;
  molecule_.reset();
  file_.clear();
  format_.clear();
  frames_ = 0;
  complete_ = false;
  placed_.clear();
  failed_.clear();
  begins_.reset();
  running_ = started_ = false;
  direction_ = 1;
  at_ = 0.0;
  first_ = 0;
  last_ = ~std::size_t{0};
  seek_.reset();
  shown_.reset();
  smoothing_ = 0;
  leaps_ = {};
}

void PlayedTrajectory::sceneChanged() {
  const LessonSession* session = lesson_.session();
  if (!session || !lesson_.onStage()) {
    // What a lesson began ends with it, and a file's frames with its molecule.
    if (by_lesson_ || (molecule_ && scene_.stage().molecule != molecule_)) forget();
    by_lesson_ = false;
    if (store_) started_ = false;
    return;
  }
  const TrajectorySpec& spec = session->scene().trajectory;
  by_lesson_ = true;
  if (spec.file.empty() || !scene_.stage()) return forget();
  const Expected<fs::path> file = trajectoryFile(lesson_.file(), scene_.molecule(), spec.file);
  if (!file) {
    forget();
    return messages_.error(file.problem().text());
  }
  const FrameFit fit = fitOf(spec, *scene_.stage().molecule);
  if (!(store_ && scene_.stage().molecule == molecule_ && file_ == *file && fit_ == fit))
    begin(*file, fit, fitText(spec));
  first_ = spec.first - 1;
  last_ = spec.last ? spec.last - 1 : ~std::size_t{0};
  per_s_ = std::max(spec.frames_per_s, kSlowest_per_s);
  running_ = spec.frames_per_s > 0.0;
  at_ = double(first_);
  direction_ = 1;
  seek_.reset();
  started_ = false;
}

bool PlayedTrajectory::open(FileKind kind, const fs::path& file) {
  if (kind != FileKind::Trajectory) return false;
  if (lesson_.session() && lesson_.onStage()) {
    messages_.error(tr("A lesson is open. Close it, open the structure of the trajectory, and then the trajectory."));
    return true;
  }
  if (!scene_.stage()) {
    messages_.error(
        tr("A trajectory holds no description of its atoms. Open the structure first, and then the trajectory."));
    return true;
  }
  if (!start()) {
    messages_.error(unavailable());
    return true;
  }
  begin(file, {}, {});
  running_ = false;
  return true;
}

std::string PlayedTrajectory::unavailable() const {
  if (std::string why = AtomMover::unavailable(); !why.empty()) return why;
  if (forceChoice(scene_.touch().forces).any())
    return tr("Forces between atoms act in a molecule at rest. Switch them off to play a trajectory.");
  return {};
}

void PlayedTrajectory::begin(const fs::path& file, const FrameFit& fit, std::string fit_text) {
  forget();
  file_ = file;
  fit_ = fit;
  fit_text_ = std::move(fit_text);
  molecule_ = scene_.stage().molecule;
  const auto open = [](const fs::path& path, const std::shared_ptr<const Molecule>& molecule,
                       const FrameFit& how) -> Expected<Reading> {
    try {
      auto store = FrameStore::open(path, molecule, how);
      if (!store) return store.problem();
      return readingOf(std::shared_ptr<FrameStore>(*std::move(store)), {0, 1}, 0, true);
    } catch (const std::exception& e) {
      return Problem{path.string(), 0, 0, trf("it cannot be opened: {0}", e.what()), tr("check the file")};
    }
  };
  opening_.begin(inBackground(open, file_, molecule_, fit_));
  if (options_.clock == ServoClock::Frames) takeOpened(*opening_.wait());
}

void PlayedTrajectory::takeOpened(Expected<Reading> opened) {
  if (!opened) {
    // The atoms rest. The file's name stays, so that a playback does not open it again in each frame.
    return messages_.error(opened.problem().text());
  }
  store_ = opened->store;
  leaps_ = LeapGuard(store_->placer().partOf(), store_->placer().parts());
  format_ = store_->file().format();
  take(*std::move(opened));
  started_ = false;
}

void PlayedTrajectory::take(Reading reading) {
  if (reading.store != store_) return;
  frames_ = reading.frames;
  complete_ = reading.complete;
  for (auto& [frame, placed] : reading.placed) placed_[frame] = std::move(placed);
  if (reading.problem) {
    running_ = false;
    seek_.reset();
    if (reading.failed) failed_.insert(*reading.failed);
    messages_.error(reading.problem->text());
  }
  if (complete_ && !warned_ && !reading.warnings.empty()) {
    warned_ = true;
    messages_.warning(reading.warnings.front());
  }
}

int PlayedTrajectory::piece_ticks() const {
  return molecule_ && molecule_->atoms.size() > kLargeMolecule ? kLargePiece_ticks : kPiece_ticks;
}

std::size_t PlayedTrajectory::maxReady() const {
  const std::size_t frame_bytes = sizeof(Vec3) * std::max<std::size_t>(1, molecule_ ? molecule_->atoms.size() : 0);
  return std::clamp<std::size_t>(kMaxReady_bytes / frame_bytes, 1, 3 * kMaxAhead + 8);
}

std::vector<std::size_t> PlayedTrajectory::needed() const {
  std::vector<std::size_t> out;
  if (frames_ == 0) return out;
  const auto want = [&](double frame) {
    const auto k = std::size_t(std::clamp(frame, 0.0, double(frames_ - 1)));
    if (std::find(out.begin(), out.end(), k) == out.end()) out.push_back(k);
  };
  if (shown_) {
    want(std::floor(*shown_));
    want(std::ceil(*shown_));
  }
  if (seek_) {
    want(std::floor(*seek_));
    want(std::ceil(*seek_));
  }
  want(std::floor(at_));
  want(std::ceil(at_));
  if (at_end == AtEnd::Repeat || (shown_ && *shown_ > double(last()))) want(double(first()));
  // A step may pass several frames.
  const double stride = std::max(1.0, std::floor(per_s_ * piece_ticks() * kTick_s));
  // Each step ahead needs two frames; the present place, a jump and the first frame need up to seven.
  const std::size_t ahead = std::clamp<std::size_t>(maxReady() / 4, 1, kMaxAhead);
  for (std::size_t k = 1; running_ && k <= ahead; ++k) {
    double frame = std::floor(at_) + double(direction_) * stride * double(k) + (direction_ > 0 ? 1.0 : 0.0);
    want(std::clamp(frame, double(first()), double(last())));
    want(std::clamp(frame - double(direction_), double(first()), double(last())));
  }
  return out;
}

// Reads the frames that are missing, and forgets those that are far away.
void PlayedTrajectory::request() {
  if (!store_ || reading_.busy()) return;
  const std::vector<std::size_t> wanted = needed();
  if (placed_smoothing_ != smoothing_) {
    placed_.clear();
    failed_.clear();
    placed_smoothing_ = smoothing_;
  }
  std::vector<std::size_t> missing;
  for (const std::size_t frame : wanted)
    if (!placed_.contains(frame) && !failed_.contains(frame)) missing.push_back(frame);
  if (missing.empty() && complete_) return;
  for (auto it = placed_.begin(); placed_.size() + missing.size() > maxReady() && it != placed_.end();)
    it = std::find(wanted.begin(), wanted.end(), it->first) == wanted.end() ? placed_.erase(it) : std::next(it);
  reading_.begin(inBackground(readingOf, store_, missing, smoothing_, !complete_));
  if (options_.clock == ServoClock::Frames) take(*reading_.wait());
}

std::optional<std::vector<Sphere>> PlayedTrajectory::spheresAt(double at) const {
  if (placed_smoothing_ != smoothing_) return std::nullopt;
  const auto low = std::size_t(std::floor(at)), high = std::size_t(std::ceil(at));
  // Past the last frame, the atoms are on the way to the first.
  const auto from = placed_.find(std::min(low, last())), to = placed_.find(high > last() ? first() : high);
  if (from == placed_.end() || to == placed_.end()) return std::nullopt;
  const FramePlacer& placer = store_->placer();
  const double share = at - double(low);
  std::vector<Vec3> places = between(*from->second.positions, *to->second.positions, share);
  // What leaps is in one of the two frames.
  if (const double limit_A = leapLimit_A(at); share != 0.0 && limit_A > 0.0) {
    const std::vector<bool> leaps =
        leapsBetween(*from->second.positions, *to->second.positions, placer.partOf(), placer.parts(), limit_A);
    const std::vector<Vec3>& one = share < 0.5 ? *from->second.positions : *to->second.positions;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (leaps[placer.partOf()[i]]) places[i] = one[i];
  }
  std::vector<Sphere> out = scene_.atoms().resting().spheres->spheres().copy();
  if (out.size() != places.size()) return std::nullopt;
  for (std::size_t i = 0; i < out.size(); ++i) out[i].centre_A = places[i];
  return out;
}

// The step above which a covalent molecule leaps, at a place between frames; 0: none does.
double PlayedTrajectory::leapLimit_A(double at) const {
  const auto low = std::min(std::size_t(std::floor(at)), last());
  const auto found = placed_.find(low);
  return found == placed_.end() ? 0.0 : found->second.leap_limit_A;
}

// Hands over a piece of the motion, in which no atom flies through the periodic cell.
bool PlayedTrajectory::move(std::vector<Sphere> to, double at, int ticks) {
  const double limit_A = leapLimit_A(at);
  if (!(limit_A > 0.0) && !leaps_.unsettled()) {
    if (!scene_.moveAtoms(own_, to, ticks)) return false;
    leaps_.place(to);
    return true;
  }
  const ServoSample& hand = scene_.log().latest();
  const HeldBody* body = scene_.stage().body.get();
  const PoseA pose = hand.shownBody();
  const double probe_A = scene_.servo_settings.probe_A;
  const auto occupied = [&](const Sphere& sphere, double room_A) {
    const auto near = [&](const Vec3& place, double radius_A) {
      return glm::distance(place, sphere.centre_A) < sphere.radius_A + radius_A + room_A;
    };
    if (!body) return near(hand.hip.A, probe_A) || near(hand.contact.scp.A, probe_A);
    if (!near(pose.place.A, body->reach_A)) return false;
    return std::any_of(body->spheres.begin(), body->spheres.end(),
                       [&](const Sphere& s) { return near(pose.place.A + pose.orientation * s.centre_A, s.radius_A); });
  };
  LeapGuard next = leaps_;
  next.step(to, limit_A, ticks * kTick_s, occupied);
  if (!scene_.moveAtoms(own_, to, ticks)) return false;
  leaps_ = std::move(next);
  return true;
}

// The next piece of the motion.
void PlayedTrajectory::playOn() {
  // While further frames are being found, the present last one is no end.
  const FrameRange range{double(first()), double(last()), complete_ || last() + 1 < frames_};
  const FrameStep next = nextPlace({at_, direction_}, per_s_ * piece_ticks() * kTick_s, range, at_end);
  if (next.ends) running_ = false;
  if (!next.to) return;
  auto spheres = spheresAt(next.to->at);
  // A motion can only be queued after the previous one has begun.
  if (!spheres || !move(*std::move(spheres), next.to->at, piece_ticks())) return;
  at_ = next.to->at;
  direction_ = next.to->direction;
}

// Moves the atoms straight to the chosen frame, at a speed that the hand can follow.
bool PlayedTrajectory::seek() {
  const double to = std::clamp(*seek_, double(first()), double(last()));
  const auto spheres = spheresAt(to);
  if (!spheres) return false;
  const SharedArray<Sphere>& now = scene_.stage().spheres->spheres();
  double farthest_A = 0.0;
  const double limit_A = leapLimit_A(to);
  for (std::size_t i = 0; i < spheres->size(); ++i)
    if (const double way_A = glm::distance((*spheres)[i].centre_A, now[i].centre_A);
        !(limit_A > 0.0 && way_A > limit_A))
      farthest_A = std::max(farthest_A, way_A);
  const int ticks =
      std::clamp(int(std::ceil(farthest_A / kSeekSpeed_A_per_s / kTick_s)), piece_ticks(), kMaxSeek_ticks);
  if (!own_.claim() || !move(*spheres, to, ticks)) return false;
  at_ = to;
  seek_.reset();
  return true;
}

// Where the atoms have the colours of their fluctuation, these follow when the survey is done.
void PlayedTrajectory::paintFluctuation() {
  std::shared_ptr<const Colouring>& shown = scene_.look.atoms.colouring;
  if (!shown || shown->scheme != kFluctuation || shown == painted_ || !survey()) return;
  shown = painted_ = scene_.look.colouring(kFluctuation);
}

void PlayedTrajectory::beforeTicks() {
  if (std::optional<Expected<Reading>> opened = opening_.take()) takeOpened(*std::move(opened));
  if (std::optional<Reading> read = reading_.take()) take(*std::move(read));
  if (std::optional<Expected<TrajectorySurvey>> surveyed = surveying_.take()) {
    if (*surveyed) {
      survey_ = **std::move(surveyed);
      scene_.look.fluctuation_A = survey_->fluctuation_A;
    } else {
      messages_.error(surveyed->problem().text());
    }
  }
  if (!store_ || !scene_.stage() || scene_.stage().molecule != molecule_) return;
  if (forceChoice(scene_.touch().forces).any()) {
    close();
    return messages_.notice(tr("Forces between atoms act in a molecule at rest. The trajectory has been closed."));
  }
  if (at_end != AtEnd::Return) direction_ = 1;  // the user may have chosen another end on the way back
  request();
  paintFluctuation();
  if (shown_ && !scene_.playedHand().on()) shown_.reset();
  if (shown_) return;  // a playback moves the atoms
  if (!started_) {
    if (!complete_ && first_ >= frames_) return;  // it is still being searched
    at_ = std::clamp(at_, double(first()), double(last()));
    const auto spheres = spheresAt(at_);
    if (!spheres || !own_.claim() || !scene_.placeAtoms(own_, *spheres)) return;
    leaps_.place(*spheres);
    started_ = true;
    if (by_lesson_ && lesson_.session()) {
      // The same object each time the scene restarts, so that its tasks are kept.
      if (!begins_) begins_ = std::make_shared<const Molecule>(molecule_->movedTo(*spheres));
      lesson_.beginFrom(begins_);
    }
    return;
  }
  if (seek_) {
    seek();
    return;
  }
  if (!running_ && leaps_.unsettled() && own_.claim())
    if (auto spheres = spheresAt(at_)) move(*std::move(spheres), at_, piece_ticks());
  if (running_ && own_.claim()) playOn();
}

std::optional<AtomsMoved> PlayedTrajectory::position() const {
  if (!store_ || !started_) return std::nullopt;
  std::string how = fit_text_;
  if (smoothing_ > 0) how += std::string(kSmoothed) + std::to_string(smoothing_);
  return AtomsMoved{{}, file_.filename().string(), how, at_ + 1.0};
}

void PlayedTrajectory::show(const MotionSource& source, const AtomsMoved& position, const MoleculeKey& file) {
  std::string_view how = position.detail;
  std::size_t smoothing = 0;
  if (const std::size_t at = how.find(kSmoothed); at != std::string_view::npos) {
    const std::string_view number = how.substr(at + kSmoothed.size());
    std::from_chars(number.data(), number.data() + number.size(), smoothing);
    how = how.substr(0, at);
  }
  const std::shared_ptr<const Molecule>& molecule = scene_.stage().molecule;
  TrajectorySpec spec;
  spec.superposed = how != kNotSuperposed;
  if (spec.superposed && !how.empty())
    if (auto atoms = parseSelection(how)) spec.superposed_on = *std::move(atoms);
  const FrameFit fit = fitOf(spec, *molecule);
  if (!(molecule == molecule_ && file_ == file.file && fit_ == fit)) begin(file.file, fit, std::string(how));
  if (!store_) return;
  smoothing_ = std::min(smoothing, kMaxSmoothing);
  const double wanted =
      std::isfinite(position.position) ? std::clamp(position.position - 1.0, 0.0, double(frames_)) : 0.0;
  const bool there = started_ && at_ == wanted && !shown_ && !leaps_.unsettled();
  if (there) return;
  shown_ = wanted;
  running_ = false;
  request();
  const auto spheres = spheresAt(wanted);
  if (!spheres || !scene_.placeAtoms(source, *spheres)) return;
  leaps_.place(*spheres);
  at_ = wanted;
  started_ = true;
  shown_.reset();
}

std::optional<double> PlayedTrajectory::time_ps() const {
  const auto found = placed_.find(std::min(std::size_t(std::lround(at_)), last()));
  return found == placed_.end() ? std::nullopt : found->second.time_ps;
}

void PlayedTrajectory::run(bool on) {
  running_ = on && frames_ > 1;
  seek_.reset();
  // From the end, it begins again.
  if (running_ && at_end == AtEnd::Stop && at_ >= double(last())) seek_ = double(first());
}

void PlayedTrajectory::goTo(double frame) {
  if (!store_ || !std::isfinite(frame)) return;
  running_ = false;
  seek_ = std::clamp(frame, double(first()), double(last()));
}

void PlayedTrajectory::setFramesPerSecond(double per_s) {
  if (std::isfinite(per_s)) per_s_ = std::clamp(per_s, kSlowest_per_s, kFastest_per_s);
}

void PlayedTrajectory::setSmoothing(std::size_t frames) {
  smoothing_ = std::min(frames, kMaxSmoothing);
  // The atoms move to the smoothed place.
  if (store_ && !running_) seek_ = std::min(at_, double(last()));
}

const TrajectorySurvey* PlayedTrajectory::survey() {
  if (survey_) return &*survey_;
  if (!complete_ || survey_begun_) return nullptr;
  survey_begun_ = true;
  // A file of its own, so that the frames are read meanwhile.
  const auto look = [](const fs::path& path, const std::shared_ptr<const Molecule>& molecule, const FrameFit& fit,
                       std::size_t first, std::size_t last) -> Expected<TrajectorySurvey> {
    try {
      auto store = FrameStore::open(path, molecule, fit);
      if (!store) return store.problem();
      (*store)->file().findMore(~std::uint64_t{0} >> 1);
      return surveyTrajectory(**store, first, last + 1, kMaxSurveyed);
    } catch (const std::exception& e) {
      return Problem{path.string(), 0, 0, trf("it cannot be opened: {0}", e.what()), tr("check the file")};
    }
  };
  surveying_.begin(inBackground(look, file_, molecule_, fit_, first(), last()));
  return nullptr;
}

void PlayedTrajectory::close() {
  if (store_ && own_.owns()) scene_.placeAtoms(own_, scene_.atoms().resting().spheres->spheres());
  forget();
}

}  // namespace moltact
