// Generates sentences from the tables of speed, accuracy and size in every run, so that they cannot disagree with the
// tables. Markdown.
#pragma once

#include <string>
#include <vector>

#include "engine/bench/cold_cache_ticks.h"
#include "engine/bench/tables.h"
#include "engine/bench/trade_off.h"

namespace moltact::bench {

/// Exactness, ratios of times, faster methods and their cost. Empty if exact is not among the points.
std::string tradeOffSentences(const std::vector<TradeOff>& points);

/// Tick times with cold caches, compared with consecutive ticks.
std::string coldCacheSentences(const std::vector<ColdCacheTimes>& cool);

/// Preparation, memory, and the growth of exact's time with the scene.
std::string sizeSentences(const std::vector<SceneTimes>& times);

}  // namespace moltact::bench
