#include "app/ui/extensions/reveal_policy.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "app/ui/extensions/task_stager.h"
#include "app/ui/files/settings.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/scene/contact_text.h"
#include "app/ui/scene/view_picture.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {

void RevealPolicy::beforeTicks() {
  veil_s_ = std::min(kFade_s, veil_s_ + time_.dt_s);
  followScene();
  const bool dark = stager_.dark();
  if (std::exchange(dark_, dark) && !dark) show(true);
  unseen_ = dark || (lesson_.session() && lesson_.onStage() && scene_.look.drawsNothing());
}

void RevealPolicy::stepChanged() {
  dark_ = false;
  veil_s_ = kFade_s;
  hidden_ = revealed_ = nullptr;
}

// Showing the molecule would answer questions about what was felt. Predictions and free answers have no right answer
// and do not count.
bool RevealPolicy::dependsOnUnseen() const {
  const LessonSession& session = *lesson_.session();
  for (std::size_t k = 0; k < session.step().tasks.size(); ++k)
    if (!session.taskDone(session.stepIndex(), k)) return true;
  for (std::size_t k = 0; k < session.step().questions.size(); ++k) {
    const Question& asked = session.step().questions[k];
    if (!asked.prediction && !asked.free() && !session.question(k).done()) return true;
  }
  return false;
}

// A scene that draws nothing is shown at the end, and hidden again when a task of it restarts.
void RevealPolicy::followScene() {
  const LessonSession* session = lesson_.session();
  if (!session || !lesson_.onStage() || !scene_.stage() || session->step().tasks.empty()) return;
  if (session->lesson().condition == Condition::Blind) return;
  const AtomList hidden = lesson_.looks().hidden;
  const bool depends = dependsOnUnseen();
  if (!depends && hidden && hidden->size() == scene_.stage().molecule->atoms.size()) {
    // Hidden atoms that are not touchable either stay hidden.
    const std::vector<std::uint32_t> unfelt = scene_.stage().spheres->untouchable();
    std::vector<std::uint32_t> still;
    std::set_intersection(hidden->begin(), hidden->end(), unfelt.begin(), unfelt.end(), std::back_inserter(still));
    if (still.size() == hidden->size()) return;
    hidden_ = hidden;
    revealed_ = still.empty() ? nullptr : std::make_shared<const std::vector<std::uint32_t>>(std::move(still));
    show(false);
    hide(hidden_, revealed_);
  } else if (depends && hidden_ && hidden == revealed_) {
    hide(revealed_, std::exchange(hidden_, nullptr));
  }
}

void RevealPolicy::hide(const AtomList& before, const AtomList& now) {
  lesson_.hide(now);
  if (scene_.look.atoms.hidden == before) scene_.look.atoms.hidden = now;
}

void RevealPolicy::show(bool dark_before) {
  if (settings_.reduced_motion) return;
  dark_veil_ = dark_before;
  if (!dark_before) picture_.keepForFade();
  veil_s_ = 0.0;
}

bool RevealPolicy::names(const Contact& contact) const {
  return !stager_.dark() && !stager_.asksWhat() && !scene_.look.touchesUnseen(contact);
}

bool RevealPolicy::hidesTouch() const {
  const LessonSession* session = lesson_.session();
  if (!session || !stager_.asksWhat() || session->currentTask() >= session->step().tasks.size()) return false;
  return forceChoice(session->scene().touch.forces).any() ||
         session->step().tasks[session->currentTask()].values["forces"].place.line > 0;
}

bool RevealPolicy::tellsEnergy() const {
  if (stager_.asksWhat()) return false;
  if (stager_.dark()) return stager_.showsForce();
  return !unseen_ || scene_.look.shown.has(ViewPart::Force);
}

const char* RevealPolicy::touchWord() const {
  if (hidesTouch()) return tr("feel for a force");
  const TouchLog& log = scene_.log();
  return log.touching() ? tr("touching") : log.felt() ? tr("a force is felt") : tr("not touching");
}

std::string RevealPolicy::unnamedText(bool spoken) const {
  const ServoSample& now = scene_.log().latest();
  std::string out =
      hidesTouch() ? std::string(touchWord()) : unnamedContactText(now.contact, now.felt(), now.holds_body);
  const Vec3 push = pushInView(scene_);
  const bool shows_force = stager_.dark() ? stager_.showsForce() : scene_.look.shown.has(ViewPart::Force);
  if (!now.felt() || !shows_force || push == Vec3(0.0)) return out;
  if (!spoken) out += ", " + quantityText(scene_.log().shownForce_N(), Dimension::Force, decimals(1));
  return out + ", " + pushText(push);
}

TouchMoment RevealPolicy::heard(const ServoSample& sample, double slide_A_per_s) const {
  TouchMoment out{.force_N = glm::length(sample.force.N),
                  .slide_A_per_s = slide_A_per_s,
                  .field = sample.inField() && sample.felt()};
  if (sample.molecular_energy && tellsEnergy()) out.energy_kcal_mol = sample.molecular_energy->total_kcal_mol();
  if (hidesTouch()) {
    out.field = sample.felt();  // the tone of a force, whatever exerts it
    return out;
  }
  if (names(sample.contact)) {
    out.feature = sample.contact.feature;
    out.atoms = sample.contact.atoms;
    if (sample.holds_body) out.contacts = scene_.bodyContacts().count;
  } else if (sample.contact.touching()) {  // always the sound of the same single atom
    out.feature = Feature::Sphere;
    out.atoms = {0, -1, -1};
  }
  return out;
}

ViewPartSet RevealPolicy::shownParts() const {
  ViewPartSet out = scene_.look.shown;
  if (names(scene_.log().latest().contact)) return out;
  for (const ViewPart part :
       {ViewPart::Spheres, ViewPart::Circles, ViewPart::Points, ViewPart::Cones, ViewPart::Facets})
    out.set(part, false);
  return out;
}

}  // namespace moltact
