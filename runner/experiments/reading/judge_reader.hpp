// Reads what a file of kind judge has beside its base. For scenario.cpp.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "runner/experiments/judge_plan.hpp"
#include "runner/settings/settings_reader.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {

class JudgeReader {
 public:
  // Both must outlive the reader.
  JudgeReader(const YamlFile& file, Places& places) : file_(file), places_(places) {}

  // Rules, cameras and matchups. Throws InputError.
  void read(const std::vector<YamlEntry>& top, JudgePlan& plan) const;

 private:
  std::vector<std::string> values(const YamlEntry& entry, const std::string& path) const;
  void read_matchups(const YamlEntry& entry, JudgePlan& plan) const;
  std::array<std::string, 2> matchup_in(const YAML::Node& value) const;

  const YamlFile& file_;
  Places& places_;
};

}  // namespace autoref::runner
