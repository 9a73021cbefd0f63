// What each task file offers to the registry.
#pragma once

#include "engine/lesson/tasks/registry.h"

namespace moltact {

TaskKind reachKind();
TaskKind holdKind();
TaskKind pressKind();
TaskKind feelKind();
TaskKind crossKind();
TaskKind avoidKind();
TaskKind compareKind();
TaskKind meetKind();
TaskKind traceKind();
TaskKind findKind();
TaskKind predictKind();
TaskKind sameKind();

}  // namespace moltact
