#include "tests/logs/refereed_log.hpp"

#include <cmath>

#include "game/settings/assignments.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"
#include "logs/log_game.hpp"
#include "logs/log_referee.hpp"
#include "logs/log_report.hpp"
#include "logs/recorded_teams.hpp"
#include "logs/user_log.hpp"

namespace autoref::logs {
namespace {

class FrameKeeper final : public league::LogVisitor {
 public:
  explicit FrameKeeper(std::vector<Frame>& frames) : frames_(frames) {}
  void on_frame(const Frame& frame) override { frames_.push_back(frame); }

 private:
  std::vector<Frame>& frames_;
};

game::GameSettings mutated_game_in(const std::string& log, const std::string& book,
                                   const RecordedFacts& facts, const RecordedGame& recorded) {
  game::GameSettings game = logged_game(book, facts, recorded);
  game::set_by_path(game, "sim.camera", "realistic");
  game::locate_errors(log, [&game] { check_judged(game); });
  return game;
}

std::string gaps_text(const RecordedFacts& facts, const game::GameSettings& game) {
  std::string text;
  for (const std::string& gap : gaps_of(facts, game, [](const std::string&) { return false; }))
    text += gap + "\n";
  return text;
}

}  // namespace

RefereedLog refereed(const std::filesystem::path& log) {
  const std::string name = log.string();
  RefereedLog result;
  RecordedFacts facts = facts_of(log);
  if (facts.log.frames == 0) throw io::InputError({name}, "", "contains no frame");
  const std::string book = guessed_rules(facts.log).book;
  std::vector<referee::Configuration> games;
  for (const RecordedGame& recorded : facts.games)
    games.push_back(
        game::referee_configuration(game::resolved(mutated_game_in(name, book, facts, recorded))));
  result.field = games.front().field;
  facts.teams = teams_in(log, result.field, games.front().rules.change_ends);
  const LogRefereeResult evaluation = referee_log(
      log, facts, games,
      [&result](const referee::Decision& decision) { result.decisions.push_back(decision); });
  FrameKeeper keeper(result.frames);
  league::read_log(log, keeper);
  result.report = damage_text(name, facts) +
                  gaps_text(facts, mutated_game_in(name, book, facts, facts.games.front())) +
                  io::text_of(referee_log_text(evaluation, facts)) +
                  referee_log_json(evaluation, facts) + info_text(facts, true) + info_json(facts) +
                  evaluation.events;
  return result;
}

bool is_finite(const referee::Decision& decision) {
  const referee::Finding& finding = decision.finding;
  const referee::LastTouch& touch = decision.last_touch;
  double sum = decision.time_s + finding.value + finding.threshold + touch.time_s + touch.gap_m +
               touch.speed_change_mps + finding.ball_to_m.sum();
  if (finding.position_m) sum += finding.position_m->sum();
  if (decision.clock) sum += decision.clock->played_s + decision.clock->left_s;
  return std::isfinite(sum);
}

}  // namespace autoref::logs
