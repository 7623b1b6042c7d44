#include "judge/truth/robot_count.hpp"

#include <algorithm>
#include <vector>

#include "judge/truth/ground_truth_rules.hpp"

namespace autoref::judge::ground_truth {
namespace {

// Laws of 2014: reports a surplus once it has lasted for `too_many_s`.
class TooManyRobots final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    for (const Side side : kSides) {
      if (!has_surplus(frame, side)) {
        since_s_[side] = frame.time_s;
        is_reported_[side] = false;
      } else if (!is_reported_[side] && frame.time_s - since_s_[side] >= frame.rules.too_many_s) {
        is_reported_[side] = true;
        all.push_back({"too_many_robots", frame.time_s, side});
      }
    }
  }

 private:
  PerSide<double> since_s_;
  PerSide<bool> is_reported_;
};

// 2026 rules: after a card, the team has a grace period to remove a robot. Any further surplus is a
// foul, except during the grace period after a start of play.
class TooManyRobots2026 final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    for (const Side side : kSides) {
      if (robots_on_field(frame, side) <= tolerated(frame, side)) {
        is_reported_[side] = false;
      } else if (!is_reported_[side] && !has_grace(frame, side)) {
        is_reported_[side] = true;
        raised_s_[side] = frame.time_s;
        all.push_back({"too_many_robots", frame.time_s, side});
      }
    }
  }

 private:
  // The number of robots that was allowed before a card.
  struct Former {
    int allowed = 0;
    double until_s = 0;
  };

  bool has_grace(const TrueFrame& frame, Side side) const {
    const bool has_just_started =
        frame.play.is_on && !has_passed(frame, frame.play.began_s, frame.rules.too_many_start_s);
    return has_just_started || !has_passed(frame, raised_s_[side], frame.rules.foul_repeat_s);
  }

  // The maximum number allowed during the grace periods of the side's cards.
  int tolerated(const TrueFrame& frame, Side side) {
    const int allowed = frame.signal.robots_allowed[side];
    std::vector<Former>& formers = formers_[side];
    // The signal is that of the previous frame.
    const double shown_s = frame.time_s - frame.frame_s;
    if (allowed < allowed_[side]) formers.push_back({allowed_[side], shown_s});
    allowed_[side] = allowed;
    const double grace_s = frame.rules.too_many_s;
    std::erase_if(formers,
                  [&](const Former& former) { return has_passed(frame, former.until_s, grace_s); });
    int most = allowed;
    for (const Former& former : formers) most = std::max(most, former.allowed);
    return most;
  }

  PerSide<int> allowed_{{kMaxRobots, kMaxRobots}};
  PerSide<std::vector<Former>> formers_;
  PerSide<double> raised_s_{{-1e9, -1e9}};
  PerSide<bool> is_reported_;
};

}  // namespace

int robots_on_field(const TrueFrame& frame, Side side) {
  int on_field = 0;
  for_each_robot(frame.now, side, [&](RobotId, const sim::RobotState& robot) {
    on_field += is_on_field(frame.field, robot.position_m) ? 1 : 0;
  });
  return on_field;
}

bool has_surplus(const TrueFrame& frame, Side side) {
  return robots_on_field(frame, side) > frame.signal.robots_allowed[side];
}

std::unique_ptr<GroundTruthRule> too_many_robots() { return std::make_unique<TooManyRobots>(); }
std::unique_ptr<GroundTruthRule> too_many_robots_2026() {
  return std::make_unique<TooManyRobots2026>();
}

}  // namespace autoref::judge::ground_truth
