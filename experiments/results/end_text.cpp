#include "experiments/results/end_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "soccer/colour.hpp"

namespace autoref::experiments {
namespace {

std::string scene_end_text(game::SceneEnd end) {
  switch (end) {
    case game::SceneEnd::kTime:
      return "the scene's time was over";
    case game::SceneEnd::kGoal:
      return "a goal was scored";
    case game::SceneEnd::kBallOut:
      return "the ball left the field";
    case game::SceneEnd::kFoul:
      return "a foul was called";
    case game::SceneEnd::kStop:
      return "another call stopped play";
  }
  throw std::logic_error("unknown end of a scene");
}

// "blue (b)".
std::string team_text(const game::GameConfiguration& game, bool is_a) {
  const Side side = is_a ? game.match.a_plays : opponent_of(game.match.a_plays);
  return fmt::format("{} ({})", colour_of(side), is_a ? 'a' : 'b');
}

std::string goals_text(const game::GameConfiguration& game, const game::GameRecord& record) {
  const auto [less, more] = std::minmax(record.goals_a, record.goals_b);
  const int lead = more - less;
  return fmt::format("{} leads by {} goal{}, and {} goals are enough to win",
                     team_text(game, record.goals_a > record.goals_b), lead, lead == 1 ? "" : "s",
                     game.match.rules.goals_to_win);
}

std::string shootout_text(const game::GameConfiguration& game, const game::GameRecord& record) {
  const std::array<int, 2> goals = record.shootout.value_or(std::array<int, 2>{});
  if (goals[0] == goals[1]) return "the shoot-out was over";
  return team_text(game, goals[0] > goals[1]) + " won the shoot-out";
}

// A game controller gives no reason; the record then keeps kTime.
std::string time_text(const game::GameConfiguration& game) {
  return game.match.control == referee::Control::kGameController
             ? "the game controller ended the game"
             : "the playing time was over";
}

}  // namespace

std::string end_text(const game::GameConfiguration& game, const game::GameRecord& record) {
  switch (record.end_reason) {
    case game::EndReason::kTime:
      return record.scene ? scene_end_text(record.scene->ended_by) : time_text(game);
    case game::EndReason::kGoals:
      return goals_text(game, record);
    case game::EndReason::kShootout:
      return shootout_text(game, record);
    case game::EndReason::kForfeitA:
    case game::EndReason::kForfeitB:
      return fmt::format("{} forfeited the game: {}",
                         team_text(game, record.end_reason == game::EndReason::kForfeitA),
                         record.void_reason);
    case game::EndReason::kVoid:
      return "the game is void: " + record.void_reason;
  }
  throw std::logic_error("unknown end of a game");
}

}  // namespace autoref::experiments
