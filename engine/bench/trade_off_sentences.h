// The results of the tables of speed, accuracy and size in sentences: generated with every run, so that they cannot
// disagree with the tables. Markdown.
#pragma once

#include <string>
#include <vector>

#include "engine/bench/cold_cache_ticks.h"
#include "engine/bench/tables.h"
#include "engine/bench/trade_off.h"

namespace moltact::bench {

/// Exactness, ratios of times, what is faster and at what price. Nothing without exact among the points.
std::string tradeOffSentences(const std::vector<TradeOff>& points);

/// Tick times with cold caches, beside the ticks in a row.
std::string coldCacheSentences(const std::vector<ColdCacheTimes>& cool);

/// Preparation, memory, and how exact's time grows with the scene.
std::string sizeSentences(const std::vector<SceneTimes>& times);

}  // namespace moltact::bench
