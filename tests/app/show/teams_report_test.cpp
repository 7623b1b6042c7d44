#include "app/show/teams_verb.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

namespace autoref::app {
namespace {

using strategies::all_strategies;
using strategies::Entry;
using strategies::Tunable;

Entry team_of(std::vector<Tunable> params) {
  return {"bold", "Runs at the goal.", nullptr, std::move(params)};
}

const Entry kBold = team_of({{{"line_m", {-4, 4}, "How far it stays back."}, -0.5},
                             {{"share", {0, 1}, "Of its passes."}, 0.25}});

TEST(TeamsReport, ListsEveryTeamWithItsDescription) {
  const std::string text = io::text_of(teams_text(), 200);
  for (const Entry& team : all_strategies()) {
    EXPECT_NE(text.find("\n" + std::string(team.name) + " "), std::string::npos) << team.name;
    EXPECT_NE(text.find(team.about), std::string::npos) << team.name;
    EXPECT_NE(teams_json().find("\"name\": \"" + std::string(team.name) + "\""), std::string::npos);
  }
}

TEST(TeamsReport, ShowsEachParametersUnitDefaultAndRange) {
  EXPECT_EQ(io::text_of(team_text(kBold)),
            "bold: Runs at the goal.\n"
            "\n"
            "parameter   unit   default   range\n"
            "line_m      m      -0.5      -4 to 4   How far it stays back.\n"
            "share       1      0.25      0 to 1    Of its passes.\n"
            "\n"
            "In a scenario: { strategy: bold, params: { line_m: -0.5 } }\n");
}

TEST(TeamsReport, PrintsTheSameAsJson) {
  EXPECT_EQ(team_json(team_of({{{"line_m", {-4, 4}, "How far."}, -0.5}})),
            "{\"name\": \"bold\", \"about\": \"Runs at the goal.\", \"params\": [{\"name\": "
            "\"line_m\", \"unit\": \"m\", \"default\": -0.5, \"least\": -4, \"most\": 4, "
            "\"about\": \"How far.\"}]}\n");
}

TEST(TeamsReport, SaysIfATeamHasNoParameters) {
  EXPECT_EQ(io::text_of(team_text(team_of({}))),
            "bold: Runs at the goal.\n\nThis team has no parameters.\n");
}

TEST(AllStrategies, AreOrderedByName) {
  EXPECT_TRUE(std::is_sorted(all_strategies().begin(), all_strategies().end(),
                             [](const Entry& x, const Entry& y) { return x.name < y.name; }));
}

TEST(AllStrategies, HaveParameterDefaultsWithinTheirRanges) {
  for (const Entry& team : all_strategies()) {
    for (const Tunable& tunable : team.params) {
      EXPECT_TRUE(tunable.range.contains(tunable.standard)) << team.name << " " << tunable.name;
      EXPECT_FALSE(tunable.about.empty()) << team.name << " " << tunable.name;
    }
  }
}

TEST(AllStrategies, HaveParametersWithDifferentNamesInSnakeCase) {
  for (const Entry& team : all_strategies()) {
    std::set<std::string_view> names;
    for (const Tunable& tunable : team.params) {
      EXPECT_TRUE(names.insert(tunable.name).second) << team.name << " " << tunable.name;
      EXPECT_TRUE(std::regex_match(std::string(tunable.name), std::regex("[a-z0-9]+(_[a-z0-9]+)*")))
          << team.name << " " << tunable.name;
    }
  }
}

// A flag's range is that of its two values.
TEST(AllStrategies, HaveFlagsFromZeroToOne) {
  for (const Entry& team : all_strategies()) {
    for (const Tunable& tunable : team.params) {
      if (!tunable.is_flag) continue;
      EXPECT_EQ(tunable.range.low, 0) << team.name << " " << tunable.name;
      EXPECT_EQ(tunable.range.high, 1) << team.name << " " << tunable.name;
    }
  }
}

}  // namespace
}  // namespace autoref::app
