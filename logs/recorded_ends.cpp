#include "logs/recorded_ends.hpp"

#include <cmath>

namespace autoref::logs {
namespace {

constexpr double kKeepers_s = 60;
constexpr double kRobots_s = 10;
constexpr double kNearArea_m = 0.5;  // distance beyond the depth of the defence area
constexpr double kClearlyApart_m = 0.5;

double mean_x_m(const SeenRobots& robots) {
  double sum_m = 0;
  for (const RobotObservation& robot : robots) sum_m += robot.position_m.x();
  return sum_m / static_cast<double>(robots.size());
}

}  // namespace

std::optional<Side> yellow_end_by(const Field& field, Side team, const Vec2& keeper_m) {
  const double near_m = field.defence_area.depth_m + kNearArea_m;
  for (const Side end : kSides) {
    if ((keeper_m - field.goal_centre_m(end)).norm() <= near_m)
      return team == Side::kWest ? end : opponent_of(end);
  }
  return std::nullopt;
}

void YellowEnd::add(const league::RefereePacket& packet) {
  if (packet.has_blue_team_on_positive_half() && !said_)
    said_ = packet.blue_team_on_positive_half() ? Side::kWest : Side::kEast;
  const auto number_of = [](const league::TeamInfo& team) {
    return team.goalkeeper() < kMaxRobots ? std::optional<int>(team.goalkeeper()) : std::nullopt;
  };
  keepers_ = {{number_of(packet.yellow()), number_of(packet.blue())}};
}

void YellowEnd::add(const Frame& frame) {
  if (!first_s_) first_s_ = frame.time_s;
  const double age_s = frame.time_s - *first_s_;
  for (const Side team : kSides) {
    for (const RobotObservation& robot : frame.robots[team]) {
      if (age_s <= kKeepers_s && keepers_[team] == robot.number) add_keeper(team, robot);
    }
  }
  const SeenRobots& yellow = frame.robots[Side::kWest];
  const SeenRobots& blue = frame.robots[Side::kEast];
  if (age_s > kRobots_s || yellow.empty() || blue.empty()) return;
  apart_m_ += mean_x_m(blue) - mean_x_m(yellow);
  ++frames_apart_;
}

void YellowEnd::add_keeper(Side team, const RobotObservation& keeper) {
  if (const auto end = yellow_end_by(field_, team, keeper.position_m)) ++votes_[*end];
}

std::optional<Side> YellowEnd::end() const {
  if (said_) return said_;
  const int lead = votes_[Side::kWest] - votes_[Side::kEast];
  if (lead != 0) return lead > 0 ? Side::kWest : Side::kEast;
  if (frames_apart_ == 0 || std::abs(apart_m_) < kClearlyApart_m * frames_apart_)
    return std::nullopt;
  return apart_m_ > 0 ? Side::kWest : Side::kEast;
}

}  // namespace autoref::logs
