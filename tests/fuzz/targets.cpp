#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

constexpr Target kTargets[] = {
    {"pdb", pdb},
    {"mmcif", mmcif},
    {"small-cif", smallCif},
    {"sdf", sdf},
    {"mol2", mol2},
    {"pqr", pqr},
    {"pdbqt", pdbqt},
    {"gro", gro},
    {"xyzr", xyzr},
    {"grid-map", gridMap},
    {"dcd", dcd},
    {"xtc", xtc},
    {"trr", trr},
    {"models", models},
    {"structure", structure},
    {"gzip", gzip},
    {"any-molecule", anyMolecule},
    {"lesson", lesson},
    {"selection", selection},
    {"answers", answers},
    {"glossary", glossary},
    {"lesson-picture", lessonPicture},
    {"formula", formula},
    {"attempt", attempt},
    {"attempt-lines", attemptLines},
    {"suspended", suspended},
    {"recording", recording},
    {"recording-state", recordingState},
    {"hand-path", handPath},
    {"hip-path", hipPath},
    {"gltf", gltf},
    {"catalogue", catalogue},
    {"settings", settings},
    {"translations", translations},
    {"pack", pack},
    {"class-requests", classRequests},
    {"report-stream", reportStream},
    {"body-path", bodyPath},
    {"imd", imd},
    {"simulation-message", simulationMessage},
    {"modes", modes},
};

}  // namespace

std::span<const Target> targets() { return kTargets; }

}  // namespace moltact::fuzz
