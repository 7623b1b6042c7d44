#include <gtest/gtest.h>

#include "logs/log_game.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::logs {
namespace {

Field field_of_book(const char* name) { return find_game_setup(name)->field; }

// Whether the goals' side walls reach the wall on a field of which vision reports this run-off.
bool sides_reach_wall(const char* book, double run_off_m) {
  league::LogSummary log;
  log.field = field_of_book(book);
  log.field->run_off_m = run_off_m;
  log.field->goal_sides_reach_wall = false;
  return field_in(log, field_of_book(book)).goal_sides_reach_wall;
}

TEST(FieldIn, HasTheBooksGoalsIfItHasItsWalls) {
  EXPECT_TRUE(sides_reach_wall("2026-b", 0.3));
  EXPECT_TRUE(sides_reach_wall("2026-a", 0.3));
  EXPECT_FALSE(sides_reach_wall("2026-b", 0.7)) << "as until 2025";
  EXPECT_FALSE(sides_reach_wall("2014", 0.675));
}

}  // namespace
}  // namespace autoref::logs
