#include "runner/bench/team_cost.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <stdexcept>

#include "runner/game/game.hpp"

namespace autoref::runner {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kSeed = 1;
constexpr double kHalf_s = 300;  // two halves contain about 72000 decisions

struct Decisions {
  double ns = 0;
  std::int64_t count = 0;
};

// Wraps another strategy and times its decisions.
class Timed final : public strategies::Strategy {
 public:
  Timed(std::unique_ptr<strategies::Strategy> team, Decisions& decisions)
      : team_(std::move(team)), decisions_(decisions) {}

  void decide(const TeamView& view, TeamCommands& commands) override {
    const Clock::time_point start = Clock::now();
    team_->decide(view, commands);
    decisions_.ns += std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    ++decisions_.count;
  }
  TeamRequests requests() const override { return team_->requests(); }

 private:
  std::unique_ptr<strategies::Strategy> team_;
  Decisions& decisions_;
};

}  // namespace

TeamCost cost_of_team(std::string_view name) {
  GameConfiguration game;
  game.seed = kSeed;
  game.match.half_s = kHalf_s;
  game.a.strategy = game.b.strategy = name;
  Decisions decisions;
  const GameRecord record = play(
      game, nullptr, [&decisions](const TeamConfiguration& team, const strategies::TeamContext& b) {
        return std::make_unique<Timed>(make_registered_team(team, b), decisions);
      });
  if (record.status == Status::kVoid) {
    throw std::logic_error(fmt::format("{} against itself: {}", name, record.void_reason));
  }
  return {std::string(name), decisions.ns / static_cast<double>(decisions.count), decisions.count};
}

}  // namespace autoref::runner
