// The JSON form of report tables, in a separate file because the JSON header is large.
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/bench/report_table.h"

namespace moltact::bench {

std::string toJson(const std::vector<ReportTable>& tables, const std::string& command) {
  nlohmann::ordered_json out;
  out["command"] = command;
  for (const ReportTable& table : tables) {
    nlohmann::ordered_json& one = out["tables"][table.name];
    one["title"] = table.title;
    if (!table.note.empty()) one["note"] = table.note;
    one["rows"] = nlohmann::ordered_json::array();
    for (const auto& row : table.rows) {
      nlohmann::ordered_json cells = nlohmann::ordered_json::object();
      for (std::size_t c = 0; c < row.size(); ++c) {
        if (const auto* text = std::get_if<std::string>(&row[c])) cells[table.columns[c].name] = *text;
        // JSON has no infinity; values that are not finite are omitted like missing ones.
        if (const auto* number = std::get_if<double>(&row[c]); number && std::isfinite(*number))
          cells[table.columns[c].name] = *number;
      }
      one["rows"].push_back(std::move(cells));
    }
  }
  return out.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

}  // namespace moltact::bench
