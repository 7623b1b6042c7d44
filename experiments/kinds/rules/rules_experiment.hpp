// Experiments on rules: the same games under several variants of the rules.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "game/settings/setting_value.hpp"

namespace autoref::experiments {

// The settings in which a variant of the rules differs from the base: of the match, of the field,
// and the teams' numbers of robots.
struct RuleVariant {
  std::string name;
  std::map<std::string, game::SettingValue> settings;  // by short path: "match.rule.dribbling_m"
};

// Every team plays every other under each variant, with the same seeds. A rule book in a variant
// also sets the field, the kickers and dribblers, the latency error and the length of a half,
// except those that the base sets, and the number of robots of each team that has the official
// number of the base's rule book.
struct RulesExperiment : NamedTeams, ExperimentOf<RulesExperiment> {
  static const Kind kKind;

  // Two or more; the others are compared with the first. If one of them has a rule book, all have:
  // the reader adds that of the base.
  std::vector<RuleVariant> variants;
  int pairs = 1;  // pairs of legs per variant and matchup, 1 to 9999

  std::vector<Key> keys() override;
  std::vector<Factor> varied_settings() const override;
  // Within a pair number, variants and matchups take turns. Ids look like
  // "official+cobalt~zone-p0007-2". A game depends only on its variant, teams, pair and leg.
  std::vector<ScheduledGame> games() const override;
  std::vector<std::string> value_columns() const override { return {"variant"}; }
  ExperimentResults results(const RowsById& rows) const override;
};

}  // namespace autoref::experiments
