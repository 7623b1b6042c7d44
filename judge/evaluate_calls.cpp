#include "judge/evaluate_calls.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <utility>

#include "judge/association.hpp"
#include "judge/truth/ground_truth_observer.hpp"

namespace autoref::judge {
namespace {

constexpr std::array<std::string_view, 4> kTrueExits = {"throw_in", "corner_kick", "goal_kick",
                                                        "aimless_kick"};

using ground_truth::JudgedCall;
using referee::Decision;

class CallEvaluator final : public game::Observer {
 public:
  explicit CallEvaluator(const game::GameConfiguration& game)
      : a_plays_(game.match.a_plays),
        frame_s_(1.0 / game.sim.frame_rate_hz),
        observer_(game.field, game.match.rules, game.sim.frame_rate_hz) {}

  void on_decision(const Decision& decision) override {
    const std::optional<JudgedCall> call = ground_truth::call_of(decision);
    if (!call) return;
    calls_.push_back(*call);
    const referee::Event event = decision.finding.event;
    if (referee::entry_of(event).is_exit) exits_.push_back(decision.last_touch.side);
    if (observer_.play().is_on || referee::may_come_in_stop(event)) return;
    if (!referee::is_call(event)) return;  // excludes cards
    evaluation_.calls_in_stop.push_back(fmt::format("{} at {:.3f} s", call->name, call->time_s));
  }

  void on_requests(const PerSide<TeamRequests>& requests) override {
    for (const Side side : kSides) observer_.name_keeper(side, requests[side].keeper);
  }

  // Called after the frame's decisions.
  void on_frame(const Frame& /*frame*/, const RefereeSignal& signal,
                const sim::World& world) override {
    observer_.see(world, signal);
    now_s_ = static_cast<double>(world.state().frame) * frame_s_;
    touches_.see(world.touches(), now_s_);
    const bool is_in_air = world.state().ball.height_m > 0;
    for (; judged_ < calls_.size(); ++judged_) calls_[judged_].is_in_air = is_in_air;
    // Decisions arrive before the true state of their frame, so they have been stored until now.
    for (const std::optional<Side>& said : exits_) evaluate_last_touch(said);
    exits_.clear();
  }

  // Call this after the game.
  experiments::CallEvaluation evaluation() {
    evaluation_.verdicts = ground_truth::associate(observer_.true_events(), calls_);
    return std::move(evaluation_);
  }

 private:
  void evaluate_last_touch(const std::optional<Side>& said) {
    if (!observer_.ball().last()) return;
    const Side side = observer_.ball().last()->robot.side;
    const bool is_right = said == side || observer_.ball().is_last_shared();
    const std::size_t team = side == a_plays_ ? 0 : 1;
    add_touch(said, is_right, evaluation_.last_touch[team]);
    if (!touches_.is_contested(exit_time_s(observer_.true_events(), now_s_))) return;
    add_touch(said, is_right, evaluation_.contested_touch[team]);
  }

  static void add_touch(const std::optional<Side>& said, bool is_right,
                        experiments::LastTouchTally& tally) {
    ++(!said ? tally.unknown : is_right ? tally.right : tally.wrong);
  }

  Side a_plays_;
  double frame_s_;
  ground_truth::GroundTruthObserver observer_;
  std::vector<JudgedCall> calls_;
  std::size_t judged_ = 0;                  // number of calls judged before this frame
  std::vector<std::optional<Side>> exits_;  // last touching sides named by this frame's calls
  double now_s_ = 0;
  SideTouches touches_;
  experiments::CallEvaluation evaluation_;
};

}  // namespace

void SideTouches::see(std::span<const sim::Touch> touches, double time_s) {
  for (const sim::Touch& touch : touches) latest_s_[touch.robot.side] = time_s;
}

bool SideTouches::is_contested(double exit_s) const {
  return std::all_of(latest_s_.values.begin(), latest_s_.values.end(),
                     [exit_s](double latest_s) { return latest_s >= exit_s - kContested_s; });
}

double exit_time_s(const ground_truth::TrueEvents& true_events, double call_s) {
  const double since_s = call_s - ground_truth::Window{}.lag_s;
  for (auto event = true_events.rbegin(); event != true_events.rend(); ++event) {
    if (event->time_s < since_s) break;
    if (std::find(kTrueExits.begin(), kTrueExits.end(), event->name) != kTrueExits.end()) {
      return event->time_s;
    }
  }
  return call_s;
}

EvaluatedGame evaluate_calls(const game::GameConfiguration& configuration,
                             const game::TeamMaker& make_team, game::Observers observers) {
  CallEvaluator evaluator(configuration);
  observers.add(&evaluator);
  game::GameRecord record = game::play(configuration, observers, make_team);
  return {std::move(record), evaluator.evaluation()};
}

}  // namespace autoref::judge
