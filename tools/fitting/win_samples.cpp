#include "tools/fitting/win_samples.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>

#include "game/loop/win_probability_observer.hpp"
#include "game/play_counts/play_statistics.hpp"
#include "soccer/random.hpp"

namespace autoref::tools {
namespace {

constexpr double kEvery_s = 10;  // between two samples of a game

// Written as numbers: the owner, +1 or -1 as goal_sign(); the chance of its shot, -1 without one;
// the features. The owner is 0 if it is not known.
std::string text_of(const std::optional<OwnedBall>& ball) {
  const OwnedBall one = ball.value_or(OwnedBall{});
  return fmt::format("{} {} {}", ball ? goal_sign(one.owner) : 0, one.shot_chance.value_or(-1),
                     fmt::join(one.features, " "));
}

std::optional<OwnedBall> owned_ball_in(std::istream& line) {
  double owner = 0;
  double chance = 0;
  OwnedBall ball;
  line >> owner >> chance;
  for (double& feature : ball.features) line >> feature;
  if (owner == 0) return std::nullopt;
  ball.owner = owner == goal_sign(Side::kWest) ? Side::kWest : Side::kEast;
  if (chance >= 0) ball.shot_chance = chance;
  return ball;
}

// A line per spell of play, "s SCORED CONCEDED BALL", and per other sample, "m QUARTER GOALS XG
// PLAYED LEFT ROBOTS BALL", with pairs of numbers of west and east; last, "r RESULT".
class SampleLines final : public GameText {
 public:
  explicit SampleLines(const game::GameConfiguration& game)
      : game_(game), random_(game.seed), frames_(std::lround(kEvery_s * game.sim.frame_rate_hz)) {}

  // Observers hear of a frame's decisions before its state of play.
  void on_decision(const referee::Decision& decision) override {
    const std::optional<Side> scorer = game::scorer_in(decision);
    const bool is_stop =
        decision.from == referee::State::kRun && decision.to != referee::State::kRun;
    if (!scorer && !is_stop) return;
    if (drawn_) {
      text_ += fmt::format("s {:d} {:d} {}\n", scorer == drawn_->owner,
                           scorer == opponent_of(drawn_->owner), text_of(drawn_));
    }
    drawn_.reset();
    frames_of_spell_ = 0;
  }

  void on_play(const game::StateOfPlay& play) override {
    const bool is_drawn = random_.uniform() * ++frames_of_spell_ < 1;
    const game::PlayingTime time = game::playing_time(play.signal, game_.match);
    const double share = time.played_s / (time.played_s + time.left_s);
    const bool is_on = time.left_s > 0;  // the game may have ended early
    const bool has_ended_quarter =
        is_on && quarter_ < kQuarters && share >= 1.0 * quarter_ / kQuarters;
    const bool is_next = is_on && play.now.frame % frames_ == 0;
    if (!is_drawn && !has_ended_quarter && !is_next) return;
    std::optional<OwnedBall> ball;
    if (const auto owner = play.statistics.ball_owner())
      ball = {owner->team, owner->shot_chance, game::value_features(*owner, play.now, game_.field)};
    if (is_drawn) drawn_ = ball;
    if (has_ended_quarter || is_next) add(play, ball, has_ended_quarter ? quarter_++ : 0);
  }

  std::string text(const game::GameRecord& record) const override {
    const int lead_of_a = record.goals_a - record.goals_b;
    const int lead = game_.match.a_plays == Side::kWest ? lead_of_a : -lead_of_a;
    return text_ + fmt::format("r {}\n", lead > 0 ? 1 : lead < 0 ? -1 : 0);
  }

 private:
  void add(const game::StateOfPlay& play, const std::optional<OwnedBall>& ball, int quarter) {
    const game::MatchState match = game::match_state(play, game_.match);
    const auto both = [](const auto& values) {
      return fmt::format("{} {}", values[Side::kWest], values[Side::kEast]);
    };
    text_ += fmt::format("m {} {} {} {} {} {} {}\n", quarter, both(match.goals), both(match.xg),
                         match.played_s, match.left_s, both(match.robots), text_of(ball));
  }

  const game::GameConfiguration& game_;
  RandomStream random_;
  std::int64_t frames_;
  int frames_of_spell_ = 0;
  std::optional<OwnedBall> drawn_;  // of this spell so far
  int quarter_ = 1;                 // the next one to end
  std::string text_;
};

PlayedSample played_sample_in(std::istream& line) {
  PlayedSample sample;
  game::MatchState& match = sample.match;
  line >> sample.quarter;
  for (const Side side : kSides) line >> match.goals[side];
  for (const Side side : kSides) line >> match.xg[side];
  line >> match.played_s >> match.left_s;
  for (const Side side : kSides) line >> match.robots[side];
  sample.ball = owned_ball_in(line);
  return sample;
}

void add_game(const std::string& text, FittedSamples& samples) {
  const std::size_t first = samples.played.size();
  std::istringstream lines(text);
  int result = 0;
  for (char kind = 0; lines >> kind;) {
    if (kind == 'm') samples.played.push_back(played_sample_in(lines));
    if (kind == 'r') lines >> result;
    if (kind != 's') continue;
    SpellSample spell;
    lines >> spell.has_scored >> spell.has_conceded;
    spell.ball = owned_ball_in(lines).value();
    samples.spells.push_back(spell);
  }
  if (!lines.eof()) throw std::logic_error("a line of a game cannot be read");
  for (PlayedSample& sample : std::span(samples.played).subspan(first)) sample.result = result;
}

}  // namespace

FittedSamples samples_of_games(const std::string& rules, Purpose purpose, std::size_t batches) {
  const auto make = [](const game::GameConfiguration& game) {
    return std::make_unique<SampleLines>(game);
  };
  FittedSamples samples;
  for (std::size_t batch = 0; batch < batches; ++batch) {
    for (const std::string& text : texts_of_batch(rules, purpose, batch, make))
      add_game(text, samples);
  }
  return samples;
}

}  // namespace autoref::tools
