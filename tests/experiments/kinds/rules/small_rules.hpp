// An experiment on rules for tests.
#pragma once

#include <string>

#include "experiments/kinds/rules/rules_experiment.hpp"
#include "experiments/kinds/scenario_reader.hpp"

namespace autoref::experiments {

inline const std::string kRulesTop =
    "schema: 1\nkind: rules\npairs: 2\nseed: 7\nbase: { match: { rules: 2026-b } }\n";
inline const std::string kRulesTeams = "teams: { bold: {}, zone: { robots: 5 } }\n";

inline Scenario small_rules() {
  return read_scenario_text(kRulesTop + kRulesTeams +
                                "variants:\n"
                                "  official: {}\n"
                                "  long: { match.rule.dribbling_m: 2 }\n",
                            "x.yaml");
}

}  // namespace autoref::experiments
