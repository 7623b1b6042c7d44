#include "logs/compare/distance_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "io/words.hpp"

namespace autoref::logs {
namespace {

std::string time_text(const MeasuredTime& time) {
  return fmt::format("{} log{}, {:.1f} min of running play", time.logs, time.logs == 1 ? "" : "s",
                     time.running_s / 60);
}

std::string value_text(const MeasuredValue& value) {
  if (!value.typical) return "-";
  return fmt::format("{:.3g} ({})", *value.typical, value.values);
}

io::Json json_of(const MeasuredTime& time) {
  return {{"logs", time.logs}, {"running_s", time.running_s}};
}

io::Json json_of(const MeasuredValue& value) {
  return {{"values", value.values}, {"typical", io::json_number(value.typical)}};
}

void add_distance(io::Json& json, const std::optional<Distance>& distance) {
  const auto number = [&](double Distance::*member) {
    return distance ? io::Json((*distance).*member) : io::Json(nullptr);
  };
  json["distance"] = number(&Distance::value);
  json["low"] = number(&Distance::low);
  json["high"] = number(&Distance::high);
}

}  // namespace

std::string compared_text(const ComparedTimes& times) {
  return fmt::format("Recorded: {}. Simulated: {}.", time_text(times.recorded),
                     time_text(times.simulated));
}

std::vector<std::vector<std::string>> comparison_rows(const GameComparison& comparison) {
  std::vector<std::vector<std::string>> rows{
      {"measure", "unit", "recorded", "simulated", "distance", "95 % interval"}};
  for (const MeasureComparison& compared : comparison.measures) {
    const MeasureEntry& entry = entry_of(compared.measure);
    std::vector<std::string>& row = rows.emplace_back();
    row = {std::string(entry.name), std::string(entry.unit), value_text(compared.recorded),
           value_text(compared.simulated)};
    if (const auto& distance = compared.distance) {
      row.insert(row.end(), {fmt::format("{:.2f}", distance->value),
                             fmt::format("{:.2f} to {:.2f}", distance->low, distance->high)});
    } else {
      row.insert(row.end(), {"not enough", ""});
    }
  }
  return rows;
}

std::string mean_text(const GameComparison& comparison) {
  if (!comparison.mean) return "The logs show too little to compare them.";
  const Distance& mean = *comparison.mean;
  return fmt::format(
      "Distance from the recorded games, mean of {} measures: {:.2f}, 95 % interval {:.2f} to "
      "{:.2f} (0: alike, at most 1).",
      comparison.compared, mean.value, mean.low, mean.high);
}

io::TextBlocks comparison_text(const GameComparison& comparison, const ComparedTimes& times) {
  io::TextTable table{comparison_rows(comparison), {io::Align::kLeft, io::Align::kLeft}};
  table.columns.resize(table.rows.front().size(), io::Align::kRight);
  return {compared_text(times) + "\n", table, mean_text(comparison)};
}

std::string comparison_json(const GameComparison& comparison, const ComparedTimes& times) {
  io::Json json{{"recorded", json_of(times.recorded)}, {"simulated", json_of(times.simulated)}};
  io::Json& measures = json["measures"] = io::Json::array();
  for (const MeasureComparison& compared : comparison.measures) {
    const MeasureEntry& entry = entry_of(compared.measure);
    io::Json& measure = measures.emplace_back(io::Json{{"measure", std::string(entry.name)},
                                                       {"unit", std::string(entry.unit)},
                                                       {"recorded", json_of(compared.recorded)},
                                                       {"simulated", json_of(compared.simulated)}});
    add_distance(measure, compared.distance);
  }
  json["compared"] = comparison.compared;
  add_distance(json, comparison.mean);
  return io::json_text(json);
}

}  // namespace autoref::logs
