// Describes the probe's contact in words, for the view, the status bar, speech output and tests.
#pragma once

#include <string>

#include "engine/haptics/tracker.h"
#include "engine/molecule/molecule.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// "touching: oxygen O of Asp 52, crease with its carbon C, 1.2 N"; "not touching"; or why there is no force. Names
/// chains if the molecule has several. Ignores atom indices outside the molecule. If `force_on` is false, the text says
/// that no force is applied instead of its magnitude.
/// `body`: the hand holds a body, whose contacts form no crease and no pit.
std::string contactText(const Molecule* molecule, const Contact& contact, double force_N, bool force_on = true,
                        bool body = false);

/// The same for a tick; also describes the force of a field without contact.
std::string feltText(const Molecule* molecule, const ServoSample& now, double force_N, bool force_on = true);

/// The name of an atom: "carbon CA of Ala 3", "zinc 201"; without its owner "carbon CA".
std::string atomText(const Molecule& molecule, std::size_t index, bool with_owner);
/// The sentence for a contact with `touched`, the words for the touched atoms.
std::string touchingText(const std::string& touched, double force_N, bool force_on = true);

/// The contact without its atoms, for tasks that ask what is touched: "touching", "not touching"; "a force is felt" if
/// only a field acts (`felt`).
std::string unnamedContactText(const Contact& contact, bool felt = false, bool body = false);

/// The direction of the reaction on the hand as seen in the view, from a unit vector in the camera's axes (x right, y
/// up, z toward the viewer): "pushed toward you", "pushed up and to the left".
std::string pushText(const Vec3& direction);

/// The touched atoms without the force: "oxygen O of Asp 52, pit with its carbon C and nitrogen N of Tyr 53"; empty
/// without contact. For a body the atoms that bear most of its force: "oxygen O of Asp 52 and nitrogen N of Tyr 53".
std::string touchedText(const Molecule& molecule, const Contact& contact, bool body = false);

}  // namespace moltact
