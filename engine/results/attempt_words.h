// Words and characters that both the writer and the reader of attempts use.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "engine/results/attempt.h"

namespace moltact {

/// The value of "kind" in a line of each AttemptFact, in the variant's order.
inline constexpr std::array<std::string_view, std::variant_size_v<AttemptFact>> kFactKinds{
    "step",  "answer", "hint",    "task",     "done",       "curve", "touch",    "released", "input", "stage", "view",
    "trace", "lesson", "resumed", "progress", "prediction", "left",  "touching", "still",    "moved", "way"};

/// The value of "kind" in former versions for atoms moved between two structures.
inline constexpr std::string_view kFormerStateKind = "state";

/// Of a question, in the order of AnswerKind.
inline constexpr std::array<std::string_view, 3> kAnswerKinds{"marked", "prediction", "free"};

/// One character per HIP sample, in the order of Feature: free, sphere, circle, point.
inline constexpr std::string_view kFeatureSigns = ".SCP";

}  // namespace moltact
