#include "logs/facts_collector.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/loop/game_event_fields.hpp"
#include "league/game_event_message.hpp"
#include "logs/third_differences.hpp"

namespace autoref::logs {
namespace {

// A key that is equal for the same event in different packets.
std::string key_of(GameEvent event) {
  if (!event.id.empty()) return event.id;
  event.origin.clear();  // grows when another automatic referee reports the event
  return game::game_event_json(event);
}

bool is_identified(const GameEvent& event) { return !event.id.empty() || event.created_us; }

constexpr std::size_t kEnoughDifferences = 200;
constexpr std::size_t kMostDifferences = 200'000;
constexpr double kMostUneven = 0.25;  // as a fraction of the interval between two frames
constexpr double kLongestInterval_s = 0.1;
constexpr double kLeastNoise_m = 0.00015;
constexpr double kLeastNoise_rad = 0.0005;
constexpr double kMostNoise_m = 0.02;
constexpr double kMostNoise_rad = 0.2;

void note(double difference, std::vector<double>& differences) {
  if (differences.size() < kMostDifferences) differences.push_back(std::abs(difference));
}

std::optional<double> deviation_of(std::vector<double> differences) {
  if (differences.size() < kEnoughDifferences) return std::nullopt;
  return noise_in(std::move(differences));
}

double within(double deviation, double least, double most) {
  return deviation < least ? 0 : std::min(deviation, most);
}

}  // namespace

void RecordedGameEvents::add(double time_s, const league::RefereePacket& packet) {
  const auto& now = packet.game_events();
  if (!std::equal(now.begin(), now.end(), current_.begin(), current_.end())) {
    current_.assign(now.begin(), now.end());
    add_new(time_s, packet);
  }
  is_first_ = false;
}

void RecordedGameEvents::add_new(double time_s, const league::RefereePacket& packet) {
  std::set<std::string> shown;
  for (GameEvent& event : league::game_events_of(packet)) {
    std::string key = key_of(event);
    bool is_new = !shown_.contains(key) && !is_first_;
    if (is_identified(event) && known_.size() < 2 * kMostEvents)
      is_new = known_.insert(key).second && is_new;
    shown.insert(std::move(key));
    if (is_new && events_.size() < kMostEvents) events_.push_back({time_s, std::move(event)});
  }
  shown_ = std::move(shown);
}

std::optional<Vec2> LoggedNoise::Track::add(double time_s, const Vec2& position) {
  if (!latest_.empty() && time_s - latest_.back().time_s > kLongestInterval_s) latest_.clear();
  latest_.push_back({time_s, position});
  if (latest_.size() > 4) latest_.erase(latest_.begin());
  if (latest_.size() < 4) return std::nullopt;
  const double mean_s = (latest_[3].time_s - latest_[0].time_s) / 3;
  for (std::size_t i = 1; i < 4; ++i) {
    const double interval_s = latest_[i].time_s - latest_[i - 1].time_s;
    if (std::abs(interval_s - mean_s) > kMostUneven * mean_s) return std::nullopt;
  }
  return third_difference<Vec2>(latest_[0].at, latest_[1].at, latest_[2].at, latest_[3].at);
}

void LoggedNoise::add(const Frame& frame) {
  for (const Side side : kSides) {
    for (const RobotObservation& robot : frame.robots[side]) add(robot, side, frame.time_s);
  }
  if (!frame.ball) return;
  if (const auto difference_m = ball_.add(frame.time_s, frame.ball->position_m)) {
    note(difference_m->x(), ball_m_);
    note(difference_m->y(), ball_m_);
  }
}

void LoggedNoise::add(const RobotObservation& robot, Side side, double time_s) {
  const auto number = static_cast<std::size_t>(robot.number);
  if (const auto difference_m = robots_[side][number].add(time_s, robot.position_m)) {
    note(difference_m->x(), robot_m_);
    note(difference_m->y(), robot_m_);
  }
  // For small angles, the change of the heading vector across itself is the angle.
  if (const auto difference = headings_[side][number].add(time_s, robot.heading))
    note(cross(robot.heading, *difference), robot_rad_);
}

std::optional<tracking::VisionNoise> LoggedNoise::noise() const {
  const std::optional<double> ball_m = deviation_of(ball_m_);
  const std::optional<double> robot_m = deviation_of(robot_m_);
  const std::optional<double> robot_rad = deviation_of(robot_rad_);
  if (!ball_m || !robot_m || !robot_rad) return std::nullopt;
  return tracking::VisionNoise{within(*ball_m, kLeastNoise_m, kMostNoise_m),
                               within(*robot_m, kLeastNoise_m, kMostNoise_m),
                               within(*robot_rad, kLeastNoise_rad, kMostNoise_rad)};
}

}  // namespace autoref::logs
