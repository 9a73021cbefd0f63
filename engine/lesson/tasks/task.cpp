#include "engine/lesson/tasks/task.h"

#include <algorithm>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {

void Task::feed(const TouchSample& sample) {
  const double force_squared = glm::dot(sample.force.N, sample.force.N);
  if (done_ || !std::isfinite(sample.time_s) || !std::isfinite(force_squared) || !finite(sample.contact.scp.A) ||
      !finite(sample.contact.displacement_A))
    return;
  double dt = 0.0;
  if (started_) {
    dt = sample.time_s - last_time_s_;
    if (!(dt > 0.0)) return;
    if (dt > kLongestGap_s) dt = 0.0;
  }
  started_ = true;
  last_time_s_ = sample.time_s;
  inside_ = sample.contact.fault == Fault::StartedInside;
  body_ = sample.body.has_value();
  measureTouch(sample, dt);
  onSample(sample, dt);
}

void Task::measureTouch(const TouchSample& sample, double dt_s) {
  time_s_ += dt_s;
  if (sample.felt()) {
    const double force_N = glm::length(sample.force.N);
    felt_s_ += dt_s;
    impulse_Ns_ += force_N * dt_s;
    greatest_N_ = std::max(greatest_N_, force_N);
  }
  if (!sample.contact.touching()) {
    last_scp_A_.reset();
    return;
  }
  contact_s_ += dt_s;
  if (last_scp_A_ && dt_s > 0.0) path_A_ += glm::distance(*last_scp_A_, sample.contact.scp.A);
  last_scp_A_ = sample.contact.scp.A;
}

void Task::answer(const TaskAnswer& given) {
  if (done_) return;
  if (given.number) {
    const std::optional<TaskSlider> asked = slider();
    if (asked && *given.number >= asked->min && *given.number <= asked->max) onAnswer(given);
    return;
  }
  if (const TaskCurves* asked = curves();
      asked && asked->drawing && given.curve.size() == asked->drawn.size() && !given.curve.empty()) {
    if (std::all_of(given.curve.begin(), given.curve.end(), [](double v) { return std::isfinite(v) && v >= 0.0; }))
      onAnswer(given);
    return;
  }
  const std::vector<TaskButton> there = currentButtons();
  if (std::any_of(there.begin(), there.end(), [&](const TaskButton& b) { return b.word == given.word; }))
    onAnswer(given);
}

std::vector<TaskFigure> Task::figures() const {
  std::vector<TaskFigure> out{{N_("time"), time_s_, "s"}, {N_("contact time"), contact_s_, "s"}};
  if (felt_s_ > 0.0) out.push_back({N_("mean force"), impulse_Ns_ / felt_s_, "N"});
  out.push_back({N_("greatest force"), greatest_N_, "N"});
  out.push_back({"way", path_A_, "Å"});  // shown as figureTitle("way")
  measure(out);
  return out;
}

std::string Task::sentence() const {
  if (given_up_) {
    const std::string last = tr("That was the last try."), answer = solution();
    return answer.empty() ? last : last + " " + answer;
  }
  if (done_) {
    const std::string reported = afterwards(), praise = praise_.text();
    return reported.empty() ? praise : reported + " " + praise;
  }
  if (inside_)
    return body_ ? tr("What you hold began inside the molecule. Draw it back until it is outside, then touch again.")
                 : tr("The probe began inside the molecule. Draw it back until it is outside, then touch again.");
  return guidance();
}

void Task::reset() {
  progress_ = 0.0;
  time_s_ = contact_s_ = felt_s_ = impulse_Ns_ = greatest_N_ = path_A_ = 0.0;
  last_scp_A_.reset();
  done_ = given_up_ = started_ = inside_ = body_ = false;
  missed_ = 0;
}

bool Task::missedLast() {
  ++missed_;
  if (tries_ > 0 && missed_ >= tries_) done_ = given_up_ = true;
  return given_up_;
}

KeySpec attemptsKey(std::string_view meaning) {
  return {.name = "attempts", .type = ValueType::Count, .meaning = meaning, .min = 1, .max = 20};
}

KeySpec darkKey() {
  return {.name = "dark",
          .type = ValueType::Word,
          .meaning = "Whether the screen is dark meanwhile.",
          .fallback = "yes",
          .words = {"yes", "no"}};
}

KeySpec meterKey() {
  return {.name = "meter",
          .type = ValueType::Word,
          .meaning = "Whether magnitude and direction of the force are displayed in the dark.",
          .fallback = "on",
          .words = {"on", "off"}};
}

void Task::setProgress(double progress) { progress_ = std::clamp(progress, 0.0, 1.0); }

AtomSet::AtomSet(const Selection& selection, const Molecule& molecule) : all_(!selection.given()) {
  if (all_) {
    count_ = molecule.atoms.size();
    return;
  }
  in_.assign(molecule.atoms.size(), 0);
  for (const std::uint32_t i : selection.select(molecule)) {
    in_[i] = 1;
    ++count_;
  }
}

std::vector<std::uint32_t> AtomSet::atoms() const {
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i < (all_ ? count_ : in_.size()); ++i)
    if (all_ || in_[i]) out.push_back(static_cast<std::uint32_t>(i));
  return out;
}

std::vector<SurfacePlace> placesToTouch(const HandPlanInput& view, const AtomSet& atoms, std::string_view feature) {
  if (feature == "crease") return openPlaces(view, atoms.atoms(), Feature::Circle);
  if (feature == "pit") return openPlaces(view, atoms.atoms(), Feature::Point);
  std::vector<SurfacePlace> places = openPlaces(view, atoms.atoms(), Feature::Sphere);
  if (!places.empty() || feature == "sphere") return places;
  // Atoms without an exposed face may still be touched at their creases.
  const auto touched = [&](const SurfacePlace& p) {
    return std::any_of(p.atoms.begin(), p.atoms.end(), [&](std::int32_t a) { return atoms.has(a); });
  };
  std::vector<char> near(view.spheres.size(), 0);
  for (const std::uint32_t a : atoms.atoms())
    view.spheres.visitNear(view.spheres[a].centre_A, view.spheres[a].radius_A + 2.0 * view.probe_A,
                           [&](std::uint32_t b, const Sphere&) { near[b] = 1; });
  std::vector<std::uint32_t> around;
  for (std::uint32_t a = 0; a < near.size(); ++a)
    if (near[a]) around.push_back(a);
  for (const Feature f : {Feature::Circle, Feature::Point})
    for (const SurfacePlace& p : openPlaces(view, around, f, 40, touched)) places.push_back(p);
  return places;
}

AtSurface::AtSurface(const Selection& selection, const Molecule& molecule)
    : atoms_([&] {
        std::vector<Sphere> spheres;
        for (const std::uint32_t a : AtomSet(selection, molecule).atoms()) spheres.push_back(molecule.spheres[a]);
        return spheres;
      }()) {}

bool AtSurface::near(const Vec3& probe, double probe_A) const {
  bool found = false;
  atoms_.visitNear(probe, probe_A + kNear_A, [&](std::uint32_t, const Sphere& s) {
    found = glm::distance(probe, s.centre_A) <= s.radius_A + probe_A + kNear_A;
    return !found;
  });
  return found;
}

bool AtomSet::touchedBy(const Contact& contact) const {
  return contact.touching() &&
         std::any_of(contact.atoms.begin(), contact.atoms.end(), [&](std::int32_t a) { return has(a); });
}

bool AtomSet::holds(const Contact& contact) const {
  return touchedBy(contact) &&
         std::all_of(contact.atoms.begin(), contact.atoms.end(), [&](std::int32_t a) { return a < 0 || has(a); });
}

bool Stopwatch::tick(bool lasting, double dt_s, double slip_s) {
  if (lasting) {
    elapsed_s_ += dt_s;
    away_s_ = 0.0;
    return false;
  }
  away_s_ += dt_s;
  if (away_s_ <= slip_s || elapsed_s_ == 0.0) return false;
  restart();
  return true;
}

bool Slide::tick(const Contact& contact, double dt_s) {
  if (!contact.touching()) {
    away_s_ += dt_s;
    return false;
  }
  const double step_A = last_A_ ? glm::distance(*last_A_, contact.scp.A) : 0.0;
  const bool anew = !last_A_ || (away_s_ > 0.0 && (away_s_ > kSlip_s || step_A > kHop_A));
  path_A_ = anew ? 0.0 : path_A_ + step_A;
  last_A_ = contact.scp.A;
  away_s_ = 0.0;
  return anew;
}

PlaceKind::PlaceKind(std::string_view word, const AtomSet& atoms, const Molecule& molecule) : word_(word) {
  constexpr std::size_t kMax = 200;
  if (word_ != "pit" || atoms.count() > kMax) return;
  for (const std::uint32_t a : atoms.atoms()) spheres_.push_back(molecule.spheres[a]);
}

bool PlaceKind::at(const Contact& contact, const AtomSet& atoms, double probe_A) const {
  if (!atoms.holds(contact)) return false;
  return isFeature(word_, contact.feature) ||
         std::count_if(spheres_.begin(), spheres_.end(), [&](const Sphere& b) {
           return std::abs(glm::distance(contact.scp.A, b.centre_A) - b.radius_A - probe_A) <= kAlike_A;
         }) >= 3;
}

std::vector<PathPlace> pathPlaces(const std::vector<Selection>& path, const Molecule& molecule) {
  std::vector<PathPlace> out;
  for (const Selection& part : path) {
    const std::vector<std::uint32_t> atoms = part.select(molecule);
    if (path.size() == 1) {
      for (const std::uint32_t a : atoms)
        out.push_back({molecule.spheres[a].centre_A, molecule.spheres[a].radius_A, {a}});
      return out;
    }
    if (atoms.empty()) continue;
    PathPlace place{Vec3(0.0), 0.0, atoms};
    for (const std::uint32_t a : atoms) place.centre_A += molecule.spheres[a].centre_A / double(atoms.size());
    for (const std::uint32_t a : atoms)
      place.reach_A = std::max(
          place.reach_A, glm::distance(place.centre_A, molecule.spheres[a].centre_A) + molecule.spheres[a].radius_A);
    out.push_back(std::move(place));
  }
  return out;
}

TargetName::TargetName(const TaskSpec& spec, std::string_view key, std::string_view called)
    : called_(spec.values[called].text), selection_(spec.values[key].selection) {
  if (const Value& target = spec.values[key]; !target.words.empty()) word_ = target.words[0];
}

TargetName::TargetName(Selection selection, const Molecule& molecule) : selection_(std::move(selection)) {
  const std::vector<std::uint32_t> atoms = selection_.select(molecule);
  if (atoms.empty() || molecule.atoms[atoms[0]].residue == kNoResidue) return;
  const auto elsewhere = [&](std::uint32_t a) { return molecule.atoms[a].residue != molecule.atoms[atoms[0]].residue; };
  if (std::any_of(atoms.begin(), atoms.end(), elsewhere)) return;
  const AtomWords words = molecule.words(atoms[0]);
  if (words.residue.empty()) return;
  const bool one_chain = molecule.chains.size() == 1 || words.chain.empty();
  called_ = one_chain ? words.residue : trf("{0} (chain {1})", words.residue, words.chain);
}

std::string TargetName::text() const {
  if (!called_.empty()) return called_;
  return selection_.given() ? selection_.noun() : placeName(word_);
}

// Translators: these name what is to be touched or found; use the accusative if the language has one.
const char* placeName(std::string_view word) {
  if (word == "sphere") return tr("the round face of one atom");
  if (word == "crease") return tr("a crease between two atoms");
  if (word == "pit") return tr("a pit between three atoms");
  if (word == "lowest-energy") return tr("the place of the strongest pull");
  return tr("the surface");
}

bool isKindOfPlace(const Value& target) { return !target.words.empty() && target.words[0] != "anywhere"; }

bool isFeature(std::string_view word, Feature feature) {
  switch (feature) {
    case Feature::Sphere:
      return word == "sphere";
    case Feature::Circle:
      return word == "crease";
    case Feature::Point:
      return word == "pit";
    case Feature::Free:
      break;
  }
  return false;
}

std::string forceText(double force_N) { return quantityText(std::clamp(force_N, 0.0, 9999.0), Dimension::Force); }

std::string timeText(double time_s) { return quantityText(std::clamp(time_s, 0.0, 9999.0), Dimension::Time); }

std::string percentText(double share) { return quantityText(share, Dimension::Share); }

}  // namespace moltact
