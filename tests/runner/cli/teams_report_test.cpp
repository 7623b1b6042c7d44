#include "runner/cli/teams_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace autoref::runner {
namespace {

using strategies::all_strategies;
using strategies::Entry;
using strategies::Parameter;

Entry team_of(std::vector<Parameter> params) {
  return {"bold", "Runs at the goal.", nullptr, std::move(params)};
}

const Entry kBold = team_of({{"line_m", "m", -0.5, -4, 4, "How far it stays back."},
                             {"share", "1", 0.25, 0, 1, "Of its passes."}});

TEST(TeamsReport, ListsEveryTeamWithItsDescription) {
  const std::string text = text_of(teams_text(), 200);
  for (const Entry& team : all_strategies()) {
    EXPECT_NE(text.find("\n" + std::string(team.name) + " "), std::string::npos) << team.name;
    EXPECT_NE(text.find(team.about), std::string::npos) << team.name;
    EXPECT_NE(teams_json().find("\"name\": \"" + std::string(team.name) + "\""), std::string::npos);
  }
}

TEST(TeamsReport, ShowsEachParametersUnitDefaultAndRange) {
  EXPECT_EQ(text_of(team_text(kBold)),
            "bold: Runs at the goal.\n"
            "\n"
            "parameter   unit   default   range\n"
            "line_m      m      -0.5      -4 to 4   How far it stays back.\n"
            "share       1      0.25      0 to 1    Of its passes.\n"
            "\n"
            "In a scenario: { strategy: bold, params: { line_m: -0.5 } }\n");
}

TEST(TeamsReport, PrintsTheSameAsJson) {
  EXPECT_EQ(team_json(team_of({{"line_m", "m", -0.5, -4, 4, "How far."}})),
            "{\"name\": \"bold\", \"about\": \"Runs at the goal.\", \"params\": [{\"name\": "
            "\"line_m\", \"unit\": \"m\", \"default\": -0.5, \"least\": -4, \"most\": 4, "
            "\"about\": \"How far.\"}]}\n");
}

TEST(TeamsReport, SaysIfATeamHasNoParameters) {
  EXPECT_EQ(text_of(team_text(team_of({}))),
            "bold: Runs at the goal.\n\nThis team has no parameters.\n");
}

TEST(AllStrategies, AreOrderedByName) {
  EXPECT_TRUE(std::is_sorted(all_strategies().begin(), all_strategies().end(),
                             [](const Entry& x, const Entry& y) { return x.name < y.name; }));
}

TEST(AllStrategies, HaveParameterDefaultsWithinTheirRanges) {
  for (const Entry& team : all_strategies()) {
    for (const Parameter& parameter : team.params) {
      EXPECT_GE(parameter.standard, parameter.least) << team.name << " " << parameter.name;
      EXPECT_LE(parameter.standard, parameter.most) << team.name << " " << parameter.name;
      EXPECT_FALSE(parameter.unit.empty()) << team.name << " " << parameter.name;
    }
  }
}

}  // namespace
}  // namespace autoref::runner
