#include "app/game/continuations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <vector>

#include "app/game/play_one.hpp"
#include "app/shared_options.hpp"
#include "experiments/scenes/continuation.hpp"
#include "io/errors.hpp"
#include "io/json.hpp"
#include "io/processes/progress.hpp"
#include "io/processes/workers.hpp"
#include "io/table.hpp"
#include "io/terminal.hpp"

namespace autoref::app {
namespace {

using experiments::Continuation;

Continuation continuation_of(const game::GameConfiguration& game) {
  experiments::ContinuationObserver observer;
  game::GamePrograms programs = game::GamePrograms::live(game, {});
  const game::GameRecord record = play_game(game, &observer, programs).record;
  return observer.continuation(game, record);
}

// The games with the seeds from that of `game` on.
class ContinuationPlayer {
 public:
  ContinuationPlayer(const game::GameConfiguration& game, const ManyGames& many)
      : game_(game), many_(many), games_(static_cast<std::size_t>(many.games)) {}

  std::vector<Continuation> play() {
    io::Progress progress(stderr, {.total = many_.games});
    std::vector<std::size_t> jobs(games_.size());
    std::iota(jobs.begin(), jobs.end(), std::size_t{0});
    const io::Ending ending =
        io::do_jobs(jobs, {.workers = worker_count(many_.workers)},
                    {[this](const io::Job& job) {
                       return io::json_text(json_of(continuation_of(game_number(job.number))));
                     },
                     [&](const io::JobResult& result) {
                       add_result(result);
                       progress.game_done(!games_[result.job].void_reason.empty());
                     },
                     [&progress] { progress.tick(); }});
    if (ending == io::Ending::kInterrupted) throw io::Interrupted();
    return games_;
  }

 private:
  game::GameConfiguration game_number(std::size_t number) const {
    game::GameConfiguration game = game_;
    game.seed += number;
    return game;
  }

  void add_result(const io::JobResult& result) {
    Continuation& one = games_[result.job];
    if (!result.payload.empty()) {
      one = experiments::continuation_in(io::Json::parse(result.payload));
    } else {
      one.void_reason = result.failure;
    }
    one.seed = game_.seed + result.job;
  }

  const game::GameConfiguration& game_;
  const ManyGames& many_;
  std::vector<Continuation> games_;
};

// "cobalt (yellow)".
PerSide<std::string> names_with_colours(const game::GameConfiguration& game) {
  PerSide<std::string> names;
  for (const Side side : kSides) {
    const bool is_ghost = game.start && game.start->ghost && game.start->ghost->side == side;
    names[side] = fmt::format("{} ({})", is_ghost ? "ghost" : game::name_of(team_on(game, side)),
                              colour_of(side));
  }
  return names;
}

}  // namespace

std::string text_of(const RecordedSequel& sequel) {
  return fmt::format("in the log, play ended after {:.2f} s {}", sequel.lasts_s,
                     sequel.scorer ? fmt::format("with a goal by {}", colour_of(*sequel.scorer))
                                   : "without a goal");
}

io::Json json_of(const RecordedSequel& sequel) {
  return {{"lasts_s", io::rounded(sequel.lasts_s, 3)},
          {"scorer", sequel.scorer ? io::Json(colour_of(*sequel.scorer)) : io::Json()}};
}

int play_continuations(const game::GameConfiguration& game, const ManyGames& many,
                       const LogInstant& instant, const std::optional<RecordedSequel>& sequel) {
  const std::vector<Continuation> games = ContinuationPlayer(game, many).play();
  const PerSide<std::string> names = names_with_colours(game);
  const bool is_scene = game.scene.has_value();
  if (many.json) {
    io::Json json = experiments::continuations_json(games, names, is_scene);
    if (sequel) json["log"] = json_of(*sequel);
    fmt::print("{}\n", io::json_text(json));
  } else {
    const std::size_t width = io::text_width(stdout);
    fmt::print("{}\n",
               io::wrapped(fmt::format("{} games from {:g} s of {} on, {} against {}{}",
                                       games.size(), instant.at_s, instant.log, names[Side::kWest],
                                       names[Side::kEast], sequel ? "; " + text_of(*sequel) : ""),
                           width));
    fmt::print("\n{}",
               io::text_of(experiments::continuations_table(games, names, is_scene), width));
  }
  const auto voids = std::count_if(
      games.begin(), games.end(), [](const Continuation& one) { return !one.void_reason.empty(); });
  return static_cast<double>(voids) > io::kMostVoid * static_cast<double>(games.size())
             ? io::kTooManyVoid
             : io::kDone;
}

}  // namespace autoref::app
