#include "engine/haptics/touch_setup.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <type_traits>

#include "engine/haptics/atom_chemistry.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/texture_choices.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

std::vector<OfferedWord> methodWords() {
  std::vector<OfferedWord> out;
  for (const Method& m : methods()) out.push_back({m.name, m.family.name, m.sentence});
  return out;
}

std::vector<OfferedWord> interactionWords() {
  std::vector<OfferedWord> out;
  for (const InteractionKind& k : interactionKinds()) out.push_back({k.name, k.title, k.sentence});
  return out;
}

std::vector<OfferedWord> chargeWords() {
  std::vector<OfferedWord> out;
  for (const ChargeSource& s : chargeSources()) out.push_back({s.name, s.name, s.sentence});
  return out;
}

std::vector<OfferedWord> forceWords() {
  std::vector<OfferedWord> out;
  for (const ForceChoice& f : forceChoices()) out.push_back({f.name, f.title, f.sentence});
  return out;
}

std::vector<OfferedWord> dielectricWords() {
  std::vector<OfferedWord> out;
  for (const DielectricChoice& d : dielectricChoices()) out.push_back({d.name, d.title, d.sentence});
  return out;
}

std::vector<OfferedWord> textureWords() { return {textureChoices().begin(), textureChoices().end()}; }

bool drags(const TouchSetup& touch, bool) { return touch.friction > 0.0; }

// The just noticeable difference of static friction with a force-feedback device: 0.056 at 0.2, 0.150 at 0.8 (W. R.
// Provancher and N. D. Sylvester, IEEE Trans. Haptics 2, 212, 2009); between them a straight line.
std::string noticeable(const TouchSetup& touch) {
  if (touch.friction < 0.2 || touch.friction > 0.8) return {};
  const double difference = 0.056 + (0.150 - 0.056) * (touch.friction - 0.2) / 0.6;
  return trf("The next value that feels different is {0}.", numberText(touch.friction + difference, decimals(2)));
}

bool holdsProbe(const TouchSetup&, bool body) { return !body; }
bool feelsCharges(const TouchSetup& touch, bool) { return forceChoice(touch.forces).feelsCharges(); }
bool feelsForces(const TouchSetup& touch, bool) { return forceChoice(touch.forces).any(); }
bool feelsProbeCharge(const TouchSetup& touch, bool body) { return !body && feelsCharges(touch, body); }

constexpr std::array kProperties{
    TouchProperty{.member = &TouchSetup::probe_A,
                  .key = "probe",
                  .field = "probe_A",
                  .in_old_files = true,
                  .requires_rebuild = false,
                  .dimension = Dimension::Length,
                  .in_scenes = {0.0, kMaxProbe_A},
                  .in_files = {0.0, kMaxProbe_A},
                  .control = {.title = N_("Probe radius"),
                              .tip = N_("The radius of the ball you touch with. {0} is a water molecule."),
                              .range = {0.0, 6.0},
                              .step = 0.1,
                              .decimals = 1,
                              .first = true,
                              .shown = &holdsProbe},
                  .fallback = "1.4 Å",
                  .meaning = "The radius of the probe, by which every atom is inflated.",
                  .compared = "The second thing has a probe of this radius."},
    TouchProperty{.member = &TouchSetup::stiffness_N_per_mm,
                  .key = "stiffness",
                  .field = "stiffness_N_per_mm",
                  .in_old_files = true,
                  .requires_rebuild = false,
                  .dimension = Dimension::Stiffness,
                  .in_scenes = {0.01, 5.0},
                  .in_files = {0.0, 1000.0},
                  .control = {.title = N_("Stiffness"),
                              .tip = N_("The spring between your hand and the surface: how hard the molecule feels."),
                              .range = {0.05, 2.0},
                              .step = 0.05},
                  .fallback = "500 N/m",
                  .meaning = "The force of the surface per depth of the push.",
                  .compared = "The second thing pushes back so hard."},
    TouchProperty{.member = &TouchSetup::friction,
                  .key = "friction",
                  .field = "friction",
                  .requires_rebuild = false,
                  .of_surface = true,
                  .in_scenes = {0.0, kMaxFriction},
                  .in_files = {0.0, kMaxFriction},
                  .control = {.title = N_("Friction"),
                              .tip = N_("The drag along the surface, divided by the force that presses on it."),
                              .range = {0.0, kMaxFriction},
                              .step = 0.05,
                              .decimals = 2,
                              .note = &noticeable},
                  .fallback = "0",
                  .meaning = "The coefficient of friction of the surface: the drag of what slides along it, divided by "
                             "the force that presses on it.",
                  .compared = "The second thing has this coefficient of friction."},
    TouchProperty{.member = &TouchSetup::stick_slip,
                  .key = "stick-slip",
                  .field = "stick_slip",
                  .requires_rebuild = false,
                  .of_surface = true,
                  .in_scenes = {0.0, 1.0},
                  .in_files = {0.0, 1.0},
                  .control = {.title = N_("Stick and slip"),
                              .tip = N_("How much more a contact at rest holds than one that slides. At 0 it slides "
                                        "evenly; above, a slow hand jerks along."),
                              .range = {0.0, 1.0},
                              .step = 0.1,
                              .decimals = 1,
                              .shown = &drags},
                  .fallback = "0",
                  .meaning = "By how much more a contact at rest holds than one that slides, as a fraction of "
                             "'friction'. Above 0 a slow hand sticks and slips in turn.",
                  .compared = "The second thing sticks this much more than it slides."},
    TouchProperty{.member = &TouchSetup::texture,
                  .key = "texture",
                  .field = "texture",
                  .label = "texture",
                  .words = &textureWords,
                  .control = {.title = N_("Friction by"),
                              .tip = N_("Which property of the atoms makes them rougher or smoother."),
                              .shown = &drags},
                  .fallback = "none",
                  .meaning = "Which property of the atoms makes them rougher or smoother; it multiplies 'friction'.",
                  .compared = "The second thing has this texture."},
    TouchProperty{.member = &TouchSetup::method,
                  .key = "method",
                  .field = "method",
                  .label = "method",
                  .in_old_files = true,
                  .words = &methodWords,
                  .fallback = "exact",
                  .meaning = "The haptic method that finds the contact point.",
                  .compared = "The second thing is felt with this haptic method."},
    TouchProperty{.member = &TouchSetup::force_on,
                  .key = "force",
                  .field = "force_on",
                  .in_old_files = true,
                  .requires_rebuild = false,
                  .control = {.title = N_("Force on"), .tip = N_("Off: contact is followed, but no force is given.")},
                  .fallback = "on",
                  .meaning = "Whether the hand feels the force."},
    TouchProperty{.member = &TouchSetup::interaction,
                  .key = "hand",
                  .field = "interaction",
                  .label = "interaction",
                  .words = &interactionWords,
                  .control = {.title = N_("In the hand")},
                  .fallback = "probe",
                  .meaning =
                      "How what is in the hand feels the molecule: 'probe' is a sphere; 'exact-body', the default with "
                      "'in-hand', is a rigid body on one spring that overlaps no atom. With 'springs' each atom of the "
                      "body has a spring of its own, and the body can overlap atoms."},
    TouchProperty{.member = &TouchSetup::charges,
                  .key = "charges",
                  .field = "charges",
                  .label = "charges",
                  .words = &chargeWords,
                  .fallback = "none",
                  .meaning =
                      "The source of the atoms' charges, for interactions with electrostatic forces: 'file' from the "
                      "molecule's file, 'formal' from the residues at pH 7. With 'forces', 'none' means the file's "
                      "charges or else "
                      "AMBER's; 'formal' leaves the formal charges alone, shared by the atoms that carry them, and no "
                      "hydrogen bonds."},
    TouchProperty{.member = &TouchSetup::forces,
                  .key = "forces",
                  .field = "forces",
                  .label = "forces",
                  .words = &forceWords,
                  .control = {.title = N_("Forces between atoms"),
                              .tip = N_("Attraction and repulsion beyond contact, as between real atoms.")},
                  .fallback = "none",
                  .meaning = "Which forces between atoms are felt besides contact.",
                  .compared = "The second thing is felt with these forces between atoms."},
    TouchProperty{.member = &TouchSetup::dielectric,
                  .key = "dielectric",
                  .field = "dielectric",
                  .label = "dielectric",
                  .words = &dielectricWords,
                  .control = {.title = N_("Medium"),
                              .tip = N_("What lies between the charges, and how much it weakens their forces."),
                              .shown = &feelsCharges},
                  .fallback = "water",
                  .meaning = "How the medium weakens the forces between charges.",
                  .compared = "The second thing is felt in this medium."},
    TouchProperty{.member = &TouchSetup::probe_charge_e,
                  .key = "probe-charge",
                  .field = "probe_charge_e",
                  .label = "probe_charge_e",
                  .in_scenes = {-kMaxProbeCharge_e, kMaxProbeCharge_e},
                  .in_files = {-kMaxProbeCharge_e, kMaxProbeCharge_e},
                  .control = {.title = N_("Charge of the probe"),
                              .tip = N_("In elementary charges. Opposite charges attract each other."),
                              .range = {-kMaxProbeCharge_e, kMaxProbeCharge_e},
                              .step = 0.5,
                              .decimals = 1,
                              .shown = &feelsProbeCharge},
                  .fallback = "0",
                  .meaning = "The charge of the probe in elementary charges, for the forces between atoms.",
                  .compared = "The second thing is felt with a probe of this charge."},
    TouchProperty{.member = &TouchSetup::coupling_N_per_mm,
                  .key = "coupling",
                  .field = "coupling_N_per_mm",
                  .label = "coupling_N_per_mm",
                  .dimension = Dimension::Stiffness,
                  .in_scenes = {0.0, kMaxCoupling_N_per_mm},
                  .in_files = {0.0, kMaxCoupling_N_per_mm},
                  .fallback = "0 N/m",
                  .meaning = "The stiffness of the spring that joins the hand to what it holds, in the molecule: the "
                             "softer, the more strongly the forces between atoms are felt. 0: 1.8 N/m for each of the "
                             "first 200 atoms held."},
    TouchProperty{.member = &TouchSetup::weak_gain,
                  .key = "weak-gain",
                  .field = "weak_gain",
                  .label = "weak_gain",
                  .in_scenes = {1.0, kMaxWeakGain},
                  .in_files = {1.0, kMaxWeakGain},
                  .control = {.title = N_("Gain of weak forces"),
                              .tip = N_("How many times as strong the weakest forces between atoms are felt. With the "
                                        "depth of an atom's well the gain falls."),
                              .range = {1.0, kMaxWeakGain},
                              .step = 0.5,
                              .decimals = 1,
                              .shown = &feelsForces},
                  .fallback = "1",
                  .meaning = "How many times as strong the weakest forces between atoms are felt. The gain falls with "
                             "the depth of an atom's well, so that 5 kcal/mol are felt as deep as without it.",
                  .compared = "The second thing is felt with this gain of weak forces."},
};

std::string textOf(const TouchValue& value) {
  if (const auto* on = std::get_if<bool>(&value)) return *on ? "on" : "off";
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  char digits[40];
  return {digits, std::to_chars(digits, digits + sizeof digits, std::get<double>(value)).ptr};
}

void takeText(TouchSetup& setup, const TouchProperty& property, const std::string& text) {
  if (std::holds_alternative<std::string TouchSetup::*>(property.member)) return setTouchValue(setup, property, text);
  if (std::holds_alternative<bool TouchSetup::*>(property.member)) {
    if (text == "on" || text == "off") setTouchValue(setup, property, text == "on");
    return;
  }
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec == std::errc() && read.ptr == end && number >= property.in_files.min && number <= property.in_files.max)
    setTouchValue(setup, property, number);
}

}  // namespace

std::span<const TouchProperty> touchProperties() { return kProperties; }

TouchValue touchValue(const TouchSetup& setup, const TouchProperty& property) {
  return std::visit([&](const auto member) { return TouchValue(setup.*member); }, property.member);
}

void setTouchValue(TouchSetup& setup, const TouchProperty& property, const TouchValue& value) {
  std::visit(
      [&](const auto member) {
        using T = std::remove_reference_t<decltype(setup.*member)>;
        if (const T* of_its_type = std::get_if<T>(&value)) setup.*member = *of_its_type;
      },
      property.member);
}

bool isChoice(const TouchProperty& property) { return !property.words || property.words().size() > 1; }

bool sameConstruction(const TouchSetup& a, const TouchSetup& b) {
  return std::all_of(std::begin(kProperties), std::end(kProperties), [&](const TouchProperty& p) {
    return !p.requires_rebuild || touchValue(a, p) == touchValue(b, p);
  });
}

std::map<std::string, std::string> touchLabels(const TouchSetup& setup) {
  std::map<std::string, std::string> out;
  for (const TouchProperty& p : kProperties)
    if (!p.label.empty() && (p.in_old_files || touchValue(setup, p) != touchValue(TouchSetup(), p)))
      out.emplace(p.label, textOf(touchValue(setup, p)));
  return out;
}

TouchSetup labelledTouch(const std::map<std::string, std::string>& labels, const TouchSetup& otherwise) {
  TouchSetup out = otherwise;
  for (const TouchProperty& p : kProperties) {
    if (p.label.empty()) continue;
    setTouchValue(out, p, touchValue(TouchSetup(), p));
    const auto found = labels.find(std::string(p.label));
    if (found != labels.end() || p.in_old_files)
      takeText(out, p, found == labels.end() ? std::string() : found->second);
  }
  return out;
}

bool TouchChange::has(const TouchMember& member) const {
  return std::any_of(std::begin(kProperties), std::end(kProperties),
                     [&](const TouchProperty& p) { return p.member == member && values_.contains(p.field); });
}

TouchSetup TouchChange::over(TouchSetup scene) const {
  for (const TouchProperty& p : kProperties)
    if (const auto found = values_.find(p.field); found != values_.end()) setTouchValue(scene, p, found->second);
  return scene;
}

void TouchChange::replace(const TouchChange& before, const TouchSetup& scene, TouchSetup& now) const {
  const TouchSetup wanted = over(scene);
  for (const TouchProperty& p : kProperties) {
    const auto is = values_.find(p.field), was = before.values_.find(p.field);
    const bool said = is != values_.end(), said_before = was != before.values_.end();
    if (said != said_before || (said && is->second != was->second)) setTouchValue(now, p, touchValue(wanted, p));
  }
}

}  // namespace moltact
