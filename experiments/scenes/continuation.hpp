// What follows one state of a game, in many games that start from it: how the first play ends, who
// scores next, and who wins.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/loop/game_configuration.hpp"
#include "game/loop/game_record.hpp"
#include "game/loop/observer.hpp"
#include "game/loop/start_scene.hpp"
#include "io/json.hpp"
#include "io/table.hpp"
#include "referee/decision.hpp"
#include "soccer/side.hpp"

namespace autoref::experiments {

// The end of the first play, or the next goal.
struct FollowingEvent {
  double after_s = 0;  // since the start of the game
  game::SceneEnd end = game::SceneEnd::kGoal;
  std::optional<Side> scorer = {};  // only for a goal
};

// What followed in one game.
struct Continuation {
  std::uint64_t seed = 0;
  // Why the game is void; empty if it is not. The members below have no meaning for a void game.
  std::string void_reason = {};
  std::optional<FollowingEvent> first_end = {};  // nullopt if the game ended first
  std::optional<FollowingEvent> next_goal = {};  // nullopt if there was no goal
  PerSide<int> goals = {};  // the final score, including goals before the start
  // The winner according to lead_of_a() (game_row.hpp); nullopt for a draw.
  std::optional<Side> winner = {};
};

// Observes what follows in one game. Ignores shoot-outs, except for the winner.
class ContinuationObserver final : public game::Observer {
 public:
  void on_decision(const referee::Decision& decision) override;

  // What followed in the game, given its configuration and the record of the finished game.
  Continuation continuation(const game::GameConfiguration& game,
                            const game::GameRecord& record) const;

 private:
  std::optional<FollowingEvent> first_end_;
  std::optional<FollowingEvent> next_goal_;
};

// {"seed": 43, "void_reason": "", "first_end": {"after_s": 1.5, "end": "goal", "scorer": "blue"},
//  "next_goal": null, "goals": {"yellow": 2, "blue": 1}, "winner": "yellow"}. A missing event,
// scorer or winner is null.
io::Json json_of(const Continuation& continuation);

// The inverse of json_of(). Throws a std::exception if `json` is not such an object.
Continuation continuation_in(const io::Json& json);

// Tables of how the first play ends and, unless `is_scene`, of the next goal and the result. Each
// row shows the number of games with that outcome, their share with its 95 % interval, the median
// time of the event, and the seed of the first such game, so that it can be played again. Void
// games are left out; a line below the tables reports them. `names` are the names of the sides'
// teams, such as "basic (yellow)".
io::TextBlocks continuations_table(const std::vector<Continuation>& games,
                                   const PerSide<std::string>& names, bool is_scene);

// {"teams": {"yellow": "bold (yellow)", "blue": "zone (blue)"}, "games": 100, "void_games": 0,
//  "play_ends": [{"end": "goal", "scorer": "yellow", "games": 12, "share": 0.12, "low": 0.07,
//                 "high": 0.198, "median_s": 2.5, "seed": 43}, ...],
//  "next_goal": [{"scorer": "yellow", ...}, ...], "results": [{"result": "yellow_wins", ...}, ...],
//  "mean_goals": {"yellow": 2.31, "blue": 1.02}, "each": [...]}, with the rows of the tables, and
// with json_of() of each game in "each". "games" counts all games, including the void ones. The
// rows of "results" do not have the member "median_s". The "end" of games in
// which the first play did not end is "time" in scenes and otherwise "game_over". Scenes do not
// have "next_goal", "results" and "mean_goals".
io::Json continuations_json(const std::vector<Continuation>& games,
                            const PerSide<std::string>& names, bool is_scene);

}  // namespace autoref::experiments
