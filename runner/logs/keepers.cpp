#include "runner/logs/keepers.hpp"

#include <algorithm>

#include "league/log_contents.hpp"
#include "league/referee_message.hpp"

namespace autoref::runner {
namespace {

constexpr int kEnough = 100;          // frames
constexpr double kMostly = 0.8;       // share of the frames
constexpr double kHardlyEver = 0.05;  // share of the frames

class DutyCounter final : public league::LogVisitor {
 public:
  explicit DutyCounter(const Field& field) : field_(field) {}

  void on_frame(const Frame& frame) override {
    for (const Side side : kSides) count(side, frame.robots[side]);
  }

  void on_referee(double /*time_s*/, const league::RefereePacket& packet) override {
    if (packet.has_blue_team_on_positive_half()) is_turned_ = !packet.blue_team_on_positive_half();
    const std::optional<RefereeSignal> signal = league::signal_of(packet);
    if (!signal) return;
    for (const Side side : kSides)
      announced[side] = signal->keepers[side].value_or(announced[side]);
  }

  PerSide<GoalDuty> duties;
  PerSide<int> announced;

 private:
  void count(Side side, const SeenRobots& robots) {
    if (robots.empty()) return;
    const Vec2 goal_m = field_.goal_centre_m(is_turned_ ? opponent_of(side) : side);
    const auto nearest = std::min_element(
        robots.begin(), robots.end(),
        [&goal_m](const RobotObservation& a, const RobotObservation& b) {
          return (a.position_m - goal_m).squaredNorm() < (b.position_m - goal_m).squaredNorm();
        });
    GoalDuty& duty = duties[side];
    ++duty.all;
    ++duty.nearest[static_cast<std::size_t>(nearest->number)];
    for (const RobotObservation& robot : robots)
      ++duty.frames[static_cast<std::size_t>(robot.number)];
  }

  Field field_;
  bool is_turned_ = false;
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

PerSide<std::optional<int>> actual_keepers(const std::filesystem::path& log, const Field& field) {
  DutyCounter counter(field);
  league::read_log(log, counter);
  PerSide<std::optional<int>> keepers;
  for (const Side side : kSides)
    keepers[side] = actual_keeper(counter.duties[side], counter.announced[side]);
  return keepers;
}

}  // namespace autoref::runner
