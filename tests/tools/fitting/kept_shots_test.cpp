// Shots are read from the files in which they were kept.
#include "tools/fitting/kept_shots.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/support/has_part.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::tools {
namespace {

const std::string kHeader =
    "team,opponent,has_scored,distance_m,opening_rad,time_s,keeper_m,keeper_out_m,keeper_mps,"
    "opponent_m,is_chip,is_on_target,path_s,keeper_to_path_m,others_to_path_m\n";
const std::string kByBasic = "basic,cobalt,0,2.5,0.25,0.5,0.1,0.2,1.5,0.3,1,1,0.6,0.4,0.05\n";
const std::string kByCobalt = "cobalt,zone,1,1.5,0.25,0.5,0.1,0.2,1.5,0.3,0,1,0.6,0.4,0.05\n";

std::string error_for(const TemporaryFolder& folder) {
  try {
    shots_under("paper", Purpose::kFit, 1, folder.path());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(KeptShots, AreReadAgain) {
  const TemporaryFolder folder;
  write_content(folder / "paper-fit.csv", kHeader + kByBasic + kByCobalt);
  const std::vector<KeptShot> shots = shots_under("paper", Purpose::kFit, 2, folder.path());
  ASSERT_EQ(shots.size(), 2U);
  EXPECT_EQ(shots[0].team, "basic");
  EXPECT_EQ(shots[0].opponent, "cobalt");
  EXPECT_FALSE(shots[0].has_scored);
  EXPECT_TRUE(shots[1].has_scored);
  const game::ShotSituation& shot = shots[0].situation;
  EXPECT_EQ(shot.distance_m, 2.5);
  EXPECT_EQ(shot.opening_rad, 0.25);
  EXPECT_EQ(shot.time_s, 0.5);
  EXPECT_EQ(shot.keeper_m, 0.1);
  EXPECT_EQ(shot.keeper_out_m, 0.2);
  EXPECT_EQ(shot.keeper_mps, 1.5);
  EXPECT_EQ(shot.opponent_m, 0.3);
  EXPECT_TRUE(shot.is_chip);
  EXPECT_TRUE(shot.path.is_on_target);
  EXPECT_EQ(shot.path.time_s, 0.6);
  EXPECT_EQ(shot.keeper_to_path_m, 0.4);
  EXPECT_EQ(shot.others_to_path_m, 0.05);
}

TEST(KeptShots, OfTheTeamLeftOutAreTheTest) {
  const TemporaryFolder folder;
  write_content(folder / "paper-test.csv", kHeader + kByBasic + kByCobalt + kByBasic);
  const std::vector<KeptShot> shots = shots_under("paper", Purpose::kTest, 1, folder.path());
  ASSERT_EQ(shots.size(), 1U);
  EXPECT_EQ(shots[0].team, kLeftOut);
}

TEST(KeptShots, AreNotReadFromOtherColumns) {
  const TemporaryFolder folder;
  write_content(folder / "paper-fit.csv", "team,opponent\nbasic,zone\n");
  EXPECT_TRUE(has(error_for(folder), "paper-fit.csv has different columns")) << error_for(folder);
}

TEST(KeptShots, AreNotReadFromDamagedRows) {
  for (const char* row : {"basic,cobalt,0,2.5\n", "\"basic\n",
                          "basic,cobalt,0,x,0.25,0.5,0.1,0.2,1.5,0.3,1,1,0.6,0.4,0.05\n",
                          "basic,cobalt,0,1,0.25,0.5,0.1,0.2,1.5,0.3,1,1,0.6,0.4,0.05,7\n",
                          "basic,cobalt,0,2m,0.25,0.5,0.1,0.2,1.5,0.3,1,1,0.6,0.4,0.05\n"}) {
    const TemporaryFolder folder;
    write_content(folder / "paper-fit.csv", kHeader + row);
    EXPECT_TRUE(has(error_for(folder), "paper-fit.csv: row 1 is not a shot")) << row;
  }
}

}  // namespace
}  // namespace autoref::tools
