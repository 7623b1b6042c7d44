#include "runner/experiments/reading/judge_reader.hpp"

#include <stdexcept>

#include "runner/experiments/reading/factor_reader.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {

void JudgeReader::read(const std::vector<YamlEntry>& top, JudgeSchedule& schedule) const {
  if (const YamlEntry* rules = find_entry(top, "rules")) {
    schedule.rules = values(*rules, "match.rules");
  }
  schedule.cameras = values(required_entry(file_, top, "cameras"), "sim.camera");
  if (const YamlEntry* matchups = find_entry(top, "matchups")) read_matchups(*matchups, schedule);
}

std::vector<std::string> JudgeReader::values(const YamlEntry& entry,
                                             const std::string& path) const {
  GameSettings any;
  return spelt(FactorReader(file_, locations_).values(entry, path, any));
}

void JudgeReader::read_matchups(const YamlEntry& entry, JudgeSchedule& schedule) const {
  if (!entry.value.IsSequence() || entry.value.size() == 0) {
    file_.refuse(value_location(entry), "matchups", "expected a list, such as [basic~dummy]");
  }
  for (const YAML::Node& value : entry.value) schedule.matchups.push_back(matchup_in(value));
}

std::array<std::string, 2> JudgeReader::matchup_in(const YAML::Node& value) const {
  const std::string text = value.IsScalar() ? value.Scalar() : "";
  const std::size_t tilde = text.find('~');
  if (tilde == std::string::npos) {
    file_.refuse(location_of(value), "matchups", "expected two strategies, such as basic~dummy");
  }
  std::array<std::string, 2> matchup = {text.substr(0, tilde), text.substr(tilde + 1)};
  try {
    GameSettings any;
    set_by_path(any, "a.strategy", matchup[0]);
    set_by_path(any, "b.strategy", matchup[1]);
  } catch (const std::invalid_argument& error) {
    file_.refuse(location_of(value), "matchups", error.what());
  }
  return matchup;
}

}  // namespace autoref::runner
