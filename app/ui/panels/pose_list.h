// The section "Poses" of the touch tab: the poses of lowest energy that the hand has reached, and the energy minimum below
// the present one (app/ui/extensions/held_poses.h). Nothing is shown where names could give an answer away. Window's
// thread.
#pragma once

namespace moltact {

class Application;
struct ViewScene;

/// Draws nothing without a held body in forces between atoms.
void drawPoses(Application& app);

/// Adds the outline of the selected pose, or of the minimum, to the picture.
void showPose(const Application& app, ViewScene& scene);

}  // namespace moltact
