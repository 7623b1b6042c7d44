#include "experiments/run/played_part.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "game/loop/game.hpp"

namespace autoref::experiments {
namespace {

using WallClock = std::chrono::steady_clock;

constexpr double kShortest_s = 1;  // minimum simulated time if the game's clock does not run

double since_s(WallClock::time_point began) {
  return std::chrono::duration<double>(WallClock::now() - began).count();
}

// Adds the time until its destruction to a sum.
class Measured {
 public:
  explicit Measured(double& sum_s) : sum_s_(sum_s) {}
  ~Measured() { sum_s_ += since_s(began_); }
  Measured(const Measured&) = delete;
  Measured& operator=(const Measured&) = delete;

 private:
  double& sum_s_;
  const WallClock::time_point began_ = WallClock::now();
};

// Measures how long another team takes.
class MeasuredTeam final : public strategies::Strategy {
 public:
  MeasuredTeam(std::unique_ptr<strategies::Strategy> team, double& sum_s)
      : team_(std::move(team)), sum_s_(sum_s) {}

  bool has_sensors() const override { return team_->has_sensors(); }
  void sense(const strategies::SensorReadings& readings) override {
    const Measured measured(sum_s_);
    team_->sense(readings);
  }
  void prepare(const TeamView& view) override {
    const Measured measured(sum_s_);
    team_->prepare(view);
  }
  void decide(const TeamView& view, TeamCommands& commands) override {
    const Measured measured(sum_s_);
    team_->decide(view, commands);
  }
  TeamRequests requests() const override { return team_->requests(); }
  void end(const strategies::GameEnd& end) override { team_->end(end); }

 private:
  std::unique_ptr<strategies::Strategy> team_;
  double& sum_s_;
};

game::TeamMaker measuring(const game::GameConfiguration& game, const game::TeamMaker& make_team,
                          std::array<double, 2>& team_s) {
  return [&game, &make_team, &team_s](
             const game::TeamConfiguration& team,
             const strategies::TeamContext& context) -> std::unique_ptr<strategies::Strategy> {
    double& sum_s = team_s[context.side == game.match.a_plays ? 0 : 1];
    const Measured measured(sum_s);
    return std::make_unique<MeasuredTeam>(make_team(team, context), sum_s);
  };
}

// How much of the halves has been played; 0 before the first kick-off.
double played_clock_s(const referee::Match& match, const RefereeSignal& signal) {
  switch (signal.stage) {
    case Stage::kFirstHalfPre:
      return 0;
    case Stage::kFirstHalf:
      return match.half_s - signal.stage_time_left_s;
    case Stage::kHalfTime:
    case Stage::kSecondHalfPre:
      return match.half_s;
    case Stage::kSecondHalf:
      return 2 * match.half_s - signal.stage_time_left_s;
    default:  // extra time and after
      return match.halves * match.half_s;
  }
}

double played_share(const game::Game& game, double played_s) {
  const game::GameConfiguration& configuration = game.configuration();
  if (configuration.scene) return std::min(1.0, played_s / configuration.scene->lasts_s);
  const referee::Match& match = configuration.match;
  const double clock_s = played_clock_s(match, game.signal());
  return std::min(1.0, (clock_s > 0 ? clock_s : played_s) / (match.halves * match.half_s));
}

bool is_measurable(const game::Game& game) {
  return game.frame().time_s >= kShortest_s ||
         played_clock_s(game.configuration().match, game.signal()) > 0;
}

}  // namespace

PlayedPart play_part(const game::GameConfiguration& configuration, double most_wall_s,
                     const game::TeamMaker& make_team) {
  const WallClock::time_point began = WallClock::now();
  PlayedPart part;
  game::Game game(configuration, nullptr, measuring(configuration, make_team, part.team_s));
  part.start_s = since_s(began);
  while (game.step()) {
    if (since_s(began) < most_wall_s || !is_measurable(game)) continue;
    part.share = played_share(game, game.record().sim_s);
    return part;
  }
  part.void_reason = game.record().void_reason;
  return part;
}

}  // namespace autoref::experiments
