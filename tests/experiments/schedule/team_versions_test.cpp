// Dates of versions, and which teams are played.
#include "experiments/schedule/team_versions.hpp"

#include <gtest/gtest.h>

#include "game/settings/setting_value.hpp"
#include "tests/support/has_part.hpp"

namespace autoref::experiments {
namespace {

TEST(VersionDates, AreDaysOfTheCalendar) {
  for (const char* date : {"2026-09-01", "2024-02-29", "0001-01-01"}) EXPECT_TRUE(is_date(date));
  for (const char* text : {"", "2026-02-29", "2026-13-01", "2026-00-01", "2026-09-00", "2026-09-31",
                           "2026-9-1", "26-09-01", "2026/09/01", "2026--1-01", "2026-09-01 "})
    EXPECT_FALSE(is_date(text)) << text;
}

TEST(VersionDates, CountLeapDays) {
  EXPECT_EQ(days_between("2024-02-01", "2024-03-01"), 29);
  EXPECT_EQ(date_after("2024-02-01", 29), "2024-03-01");
  EXPECT_EQ(date_after("2026-01-01", -1), "2025-12-31");
}

TEST(PlayedTeams, AreAnchorsAndTeamsWithoutAnEarlierRating) {
  const Teams teams = {{"anchor", {}}, {"new", {}}, {"old", {}}};
  TeamVersions versions;
  versions.anchors = {"anchor"};
  EXPECT_EQ(played_teams(teams, versions).size(), 3U);
  versions.taken_over = TakenOver{"1.0", {{"anchor", {}}, {"old", {}}}};
  const Teams played = played_teams(teams, versions);
  EXPECT_EQ(played.size(), 2U);
  EXPECT_FALSE(played.contains("old"));
}

std::string mistake_in(const TeamVersions& versions) {
  try {
    check(versions, {{"mine", {}}, {"zone", {}}}, "challengers");
  } catch (const game::SettingError& error) {
    return error.what();
  }
  return "";
}

TEST(CheckVersions, NamesTheMistake) {
  TeamVersions versions;
  versions.of_teams["mine"] = {"2026-02-29", ""};
  EXPECT_TRUE(has(mistake_in(versions), "challengers.mine.version: expected a date"));
  versions.of_teams["mine"] = {"", "fast"};
  EXPECT_TRUE(has(mistake_in(versions), "challengers.mine.version_of: the team's date is missing"));
  versions.of_teams["mine"] = {"2026-02-28", "fast"};
  EXPECT_EQ(mistake_in(versions), "");
  versions.anchors = {"zone", "bold"};
  EXPECT_TRUE(has(mistake_in(versions), "anchors: 'bold' is not one of the challengers"));
  versions.anchors = {"zone", "zone"};
  EXPECT_TRUE(has(mistake_in(versions), "anchors: 'zone' is listed twice"));
}

}  // namespace
}  // namespace autoref::experiments
