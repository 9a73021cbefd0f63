// The contact of the probe in words: for the view, the status bar, those who cannot see it well, and the tests.
#pragma once

#include <string>

#include "engine/haptics/tracker.h"
#include "engine/molecule/molecule.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// "touching: oxygen O of Asp 52, crease with its carbon C, 1.2 N"; "not touching"; or why there is no force. Chains
/// are named where the molecule has several. Atoms out of the molecule's range are left out. `force_on` false says that
/// no force is given in place of how much.
std::string contactText(const Molecule* molecule, const Contact& contact, double force_N, bool force_on = true);

/// The same of a tick: a force of a field that is felt without touching is said too.
std::string feltText(const Molecule* molecule, const ServoSample& now, double force_N, bool force_on = true);

/// What an atom is called: "carbon CA of Ala 3", "zinc 201"; without its owner "carbon CA".
std::string atomText(const Molecule& molecule, std::size_t index, bool with_owner);
/// The sentence of a contact from the words for what is touched.
std::string touchingText(const std::string& touched, double force_N, bool force_on = true);

/// That there is contact and nothing more, where what is touched is the question: "touching", "not touching"; where
/// something is `felt` without touching, "a force is felt".
std::string unnamedContactText(const Contact& contact, bool felt = false);

/// The direction of the surface's push on the hand as the view shows it, from a unit vector in the camera's axes (x
/// right, y up, z toward the person): "pushed toward you", "pushed up and to the left".
std::string pushText(const Vec3& direction);

/// The touched atoms, without the force: "oxygen O of Asp 52, pit with its carbon C and nitrogen N of Tyr 53"; empty
/// when nothing is.
std::string touchedText(const Molecule& molecule, const Contact& contact);

}  // namespace moltact
