// Writes samples to a sound file: RIFF WAVE, one channel, 16 bit. Not for the haptic thread.
#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "engine/core/problem.h"

namespace moltact {

/// Writes samples from -1 to 1 (others are clamped) at `samples_per_s`. Returns a Problem on failure.
std::optional<Problem> writeWav(const std::filesystem::path& file, std::span<const float> samples, int samples_per_s);

}  // namespace moltact
