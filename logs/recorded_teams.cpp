#include "logs/recorded_teams.hpp"

#include <algorithm>
#include <map>

#include "league/log_contents.hpp"
#include "league/referee_message.hpp"
#include "logs/recorded_ends.hpp"

namespace autoref::logs {
namespace {

constexpr int kEnough = 100;          // minimum number of frames for a conclusion
constexpr int kClearly = 9;           // ratio of frames at one goal to those at the other
constexpr double kMostly = 0.8;       // minimum share of frames for the actual keeper
constexpr double kHardlyEver = 0.05;  // announced keepers with at most this share are not in goal

// Counts for both ends that yellow may defend when the log begins.
class DutyCounter final : public league::LogVisitor {
 public:
  DutyCounter(const Field& field, bool change_ends)
      : end_(field), field_(field), ends_(Side::kWest, change_ends) {}

  void on_frame(const Frame& frame) override {
    end_.add(frame);
    for (const Side team : kSides) {
      for (const Side end : kSides) count(team, end, frame.robots[team]);
      if (says_ends_) compare_ends(team, frame.robots[team]);
    }
  }

  void on_referee(double /*time_s*/, const league::RefereePacket& packet) override {
    end_.add(packet);
    const std::optional<RefereeSignal> signal = league::signal_of(packet);
    if (!signal) return;
    ends_.add(packet, signal->stage);
    stage_ = signal->stage;
    says_ends_ = packet.has_blue_team_on_positive_half();
    keepers_ = signal->keepers;
    if (!said_ && packet.has_blue_team_on_positive_half()) {
      said_ = ends_.yellow();
      first_stage_ = signal->stage;
    }
    for (const Side team : kSides)
      announced_[team] = signal->keepers[team].value_or(announced_[team]);
  }

  RecordedTeams teams() const {
    RecordedTeams teams{end_.end(), {}, turned_stages()};
    // Before the first packet, the ends are those of the first packet's stage.
    if (said_ && first_stage_ && teams.turned.contains(*first_stage_))
      teams.yellow_end = opponent_of(*said_);
    const Side end = end_.end().value_or(Side::kWest);
    for (const Side team : kSides)
      teams.actual_keepers[team] = actual_keeper(duties_[end][team], announced_[team]);
    return teams;
  }

 private:
  // Whether the announced keeper is at the end that the packets give.
  void compare_ends(Side team, const SeenRobots& robots) {
    for (const RobotObservation& robot : robots) {
      if (keepers_[team] != robot.number) continue;
      if (const auto seen = yellow_end_by(field_, team, robot.position_m))
        ++(*seen == ends_.yellow() ? as_said_ : turned_)[stage_][team];
    }
  }

  TurnedStages turned_stages() const {
    TurnedStages stages;
    for (const auto& [stage, frames] : turned_) {
      const auto found = as_said_.find(stage);
      const PerSide<int> said = found == as_said_.end() ? PerSide<int>() : found->second;
      bool are_all = true;
      for (const Side team : kSides) {
        const int least = std::max(kEnough, kClearly * said[team]);
        are_all = are_all && frames[team] >= least;
      }
      if (are_all) stages.insert(stage);
    }
    return stages;
  }

  bool has_changed() const { return ends_.yellow() != said_.value_or(Side::kWest); }

  // `end` is the one that yellow defended initially.
  void count(Side team, Side end, const SeenRobots& robots) {
    if (robots.empty()) return;
    const bool is_there = (team == Side::kWest) != has_changed();
    const Vec2 goal_m = field_.goal_centre_m(is_there ? end : opponent_of(end));
    const auto nearest = std::min_element(
        robots.begin(), robots.end(),
        [&goal_m](const RobotObservation& a, const RobotObservation& b) {
          return (a.position_m - goal_m).squaredNorm() < (b.position_m - goal_m).squaredNorm();
        });
    GoalDuty& duty = duties_[end][team];
    ++duty.all;
    ++duty.nearest[static_cast<std::size_t>(nearest->number)];
  }

  YellowEnd end_;
  Field field_;
  std::optional<Side> said_;  // yellow's initial end according to the referee
  RecordedEnds ends_;
  PerSide<PerSide<GoalDuty>> duties_;  // indexed by yellow's end, then by team
  PerSide<int> announced_;
  Stage stage_ = Stage::kFirstHalfPre;
  std::optional<Stage> first_stage_;  // first stage in which the packets give the ends
  bool says_ends_ = false;
  PerSide<std::optional<int>> keepers_;
  // Numbers of frames in which a team's keeper is seen at the end that the packets give, and at the
  // other end.
  std::map<Stage, PerSide<int>> as_said_;
  std::map<Stage, PerSide<int>> turned_;
};

}  // namespace

std::optional<int> actual_keeper(const GoalDuty& duty, int announced) {
  if (duty.all < kEnough) return std::nullopt;
  const auto share = [&duty](int count) { return static_cast<double>(count) / duty.all; };
  const bool keeps = announced >= 0 && announced < kMaxRobots &&
                     share(duty.nearest[static_cast<std::size_t>(announced)]) > kHardlyEver;
  const auto most = std::max_element(duty.nearest.begin(), duty.nearest.end());
  if (keeps) return std::nullopt;
  return share(*most) < kMostly ? -1 : static_cast<int>(most - duty.nearest.begin());
}

RecordedTeams teams_in(const std::filesystem::path& log, const Field& field, bool change_ends,
                       league::FrameSource source) {
  DutyCounter counter(field, change_ends);
  league::read_log(log, counter, source);
  return counter.teams();
}

}  // namespace autoref::logs
