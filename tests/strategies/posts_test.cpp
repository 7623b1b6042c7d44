#include "strategies/plays/posts.hpp"

#include <gtest/gtest.h>

#include "tests/strategies/staged_play.hpp"

namespace autoref::strategies {
namespace {

Post post(int key, const Vec2& place_m) { return {key, {place_m, Vec2(1, 0)}}; }

// Which robot the cast sends to the place, by index; -1: none.
int who_goes_to(const StagedPlay& stage, const Cast& cast, const Vec2& place_m) {
  for (int i = 0; i < stage.outlook.robots(); ++i) {
    const Task& task = cast.task(i);
    if (task.part == Part::kStands && task.place.position_m == place_m) return i;
  }
  return -1;
}

const Vec2 kNorth_m(0, 1);
const Vec2 kSouth_m(0, -1);
const Posts kNorthAndSouth = {post(1, kNorth_m), post(2, kSouth_m)};

// Robots at the two posts, and the ball far from both.
struct TwoRobots : StagedPlay {
  TwoRobots() : StagedPlay(Play::kRunning) {
    world.own(3, {0, 0.9}).own(5, {0, -0.9}).ball({-2, 0});
    look();
  }
  void move(std::size_t index, const Vec2& place_m) {
    world.view.own[index].position_m = place_m;
    look();
  }
  Cast man(const Posts& posts = kNorthAndSouth) {
    Cast cast(outlook);
    man_posts(book, cast, posts);
    return cast;
  }
};

TEST(ManPosts, SendsTheNearestRobotToEachPost) {
  TwoRobots stage;
  const Cast cast = stage.man();
  EXPECT_EQ(who_goes_to(stage, cast, kNorth_m), 0);
  EXPECT_EQ(who_goes_to(stage, cast, kSouth_m), 1);
}

TEST(ManPosts, FillsTheMostImportantPostsFirst) {
  TwoRobots stage;
  const Cast cast = stage.man({post(1, {2, 0}), post(2, {1, 0}), post(3, kNorth_m)});
  EXPECT_NE(who_goes_to(stage, cast, {2, 0}), -1);
  EXPECT_NE(who_goes_to(stage, cast, {1, 0}), -1);
  EXPECT_EQ(who_goes_to(stage, cast, kNorth_m), -1);
}

TEST(ManPosts, LeavesRobotsAtTheirPostsWhereAChangeWouldSaveLittle) {
  TwoRobots stage;
  stage.man();
  stage.move(0, {0, -0.1});
  stage.move(1, {0, 0.1});  // 0.4 m less for both together
  EXPECT_EQ(who_goes_to(stage, stage.man(), kNorth_m), 0);
}

TEST(ManPosts, ChangesRobotsWhereThatSavesALongWay) {
  TwoRobots stage;
  stage.man();
  stage.move(0, kSouth_m);
  stage.move(1, kNorth_m);
  EXPECT_EQ(who_goes_to(stage, stage.man(), kNorth_m), 1);
}

TEST(ManPosts, LetsARobotFollowItsPostPastTheOthers) {
  TwoRobots stage;
  stage.man();
  const Vec2 moved_m(0.2, -1.2);  // nearer to the other robot
  const Cast cast = stage.man({post(1, moved_m), post(2, {0.2, -0.6})});
  EXPECT_EQ(who_goes_to(stage, cast, moved_m), 0);
}

TEST(ManPosts, TakesThePostFromWhoHasAnotherPartAndGivesItToWhoIsFree) {
  TwoRobots stage;
  stage.world.own(7, {0, 1.8});
  stage.man();
  Cast cast(stage.look());
  cast.give(0, Part::kBall);
  man_posts(stage.book, cast, kNorthAndSouth);
  EXPECT_EQ(who_goes_to(stage, cast, kNorth_m), 2);
  EXPECT_EQ(who_goes_to(stage, stage.man(), kNorth_m), 2);  // also when the other is free again
}

TEST(ManOwnPosts, KeepsThePostOfTheRobotAtTheBallAndLeavesItEmpty) {
  TwoRobots stage;
  stage.world.own(7, {0, 1.8});
  Cast before(stage.look());
  man_own_posts(stage.book, before, kNorthAndSouth);
  ASSERT_EQ(who_goes_to(stage, before, kNorth_m), 0);
  Cast cast(stage.look());
  cast.give(0, Part::kBall);
  man_own_posts(stage.book, cast, kNorthAndSouth);
  EXPECT_EQ(who_goes_to(stage, cast, kNorth_m), -1);
  EXPECT_TRUE(cast.is_free(2));
}

TEST(ManOwnPosts, HasTheRobotFromTheBallBackAtItsOwnPost) {
  TwoRobots stage;
  const Posts posts = {post(1, kNorth_m), post(2, kSouth_m), post(3, {1, 0})};
  Cast before(stage.look());
  man_own_posts(stage.book, before, posts);
  stage.move(0, {0.9, 0});
  Cast meanwhile(stage.outlook);
  meanwhile.give(0, Part::kBall);
  man_own_posts(stage.book, meanwhile, posts);
  Cast after(stage.look());
  man_own_posts(stage.book, after, posts);
  EXPECT_EQ(who_goes_to(stage, after, kNorth_m), 0);
}

TEST(ManOwnPosts, GivesTheRobotAtTheBallThePostNearestToItFromTheStart) {
  TwoRobots stage;
  stage.world.own(7, {0, -1.8});
  Cast first(stage.look());
  first.give(1, Part::kBall);
  man_own_posts(stage.book, first, kNorthAndSouth);
  EXPECT_EQ(who_goes_to(stage, first, kNorth_m), 0);
  EXPECT_EQ(who_goes_to(stage, first, kSouth_m), -1);
  EXPECT_TRUE(first.is_free(2));
}

TEST(ManOwnPosts, LeavesTheRobotsOfTheLastPostsFree) {
  TwoRobots stage;
  Cast cast(stage.look());
  man_own_posts(stage.book, cast, kNorthAndSouth, 1);
  EXPECT_EQ(who_goes_to(stage, cast, kNorth_m), 0);
  EXPECT_TRUE(cast.is_free(1));
}

TEST(SendAhead, LetsThoseRunForPassesWhoAreFarthestAhead) {
  StagedPlay stage(Play::kRunning);
  stage.world.own(1, {-1, 1}).own(2, {1, 1}).own(3, {-2, 0}).own(4, {0.5, -1}).ball({-1.5, 0});
  stage.watch();
  Cast cast(stage.outlook);
  send_ahead(stage.book, cast, 2);
  EXPECT_EQ(cast.task(1).part, Part::kReceiver);
  EXPECT_EQ(cast.task(3).part, Part::kReceiver);
  EXPECT_EQ(cast.free_robots(), 2);
}

TEST(SendAhead, SendsAllFreeRobotsWhereThereAreFewerThanWanted) {
  StagedPlay stage(Play::kRunning);
  stage.world.own(1, {-1, 1}).own(2, {1, 1}).ball({-1.5, 0});
  stage.watch();
  Cast cast(stage.outlook);
  cast.give(0, Part::kBall);
  send_ahead(stage.book, cast, 5);
  EXPECT_EQ(cast.task(0).part, Part::kBall);
  EXPECT_EQ(cast.task(1).part, Part::kReceiver);
}

TEST(OffTheirArea, KeepsAPlaceSoFarOffTheAreaWithMoreWhereThatIsAskedFor) {
  for (const char* rules : {"paper", "2026-b"}) {
    StagedOutlook stage(Play::kRunning, false, briefing_of(rules));
    const Outlook& outlook = stage.look();
    const Vec2 place_m = outlook.field().goal_centre_m(Side::kEast) - Vec2(0.5, 0.3);
    const double least_m = outlook.rules().attacker_to_area_m + kRobotRadius_m;
    for (const double more_m : {0.0, 0.25}) {
      const Vec2 p = off_their_area(outlook, place_m, more_m).position_m;
      const double off_m = distance_to_defence_area(outlook.field(), Side::kEast, p);
      EXPECT_NEAR(off_m, least_m + more_m + 30_mm, 30_mm) << rules;
    }
  }
}

}  // namespace
}  // namespace autoref::strategies
