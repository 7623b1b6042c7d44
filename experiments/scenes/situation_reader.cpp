#include "experiments/scenes/situation_reader.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/reading/named_teams_reader.hpp"
#include "experiments/scenes/distribution.hpp"
#include "experiments/scenes/scene_reader.hpp"
#include "game/settings/mapping.hpp"
#include "io/words.hpp"
#include "logs/logged_state.hpp"
#include "soccer/named.hpp"

namespace autoref::experiments {
namespace {

constexpr double kRounded = 1e4;  // steps per metre, radian or second

double rounded_value(double value) { return std::round(value * kRounded) / kRounded; }

class LoggedNumbers {
 public:
  explicit LoggedNumbers(double spread_m) : spread_m_(spread_m) {}

  template <typename Numbers>
  void set(const Numbers& numbers, const std::vector<double>& values) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Range& range = numbers[i].range;
      const double value = std::clamp(rounded_value(values[i]), range.low, range.high);
      const bool is_spread = numbers[i].unit == "m" && numbers[i].key != "height_m";
      *numbers[i].place =
          is_spread && spread_m_ > 0 ? Distribution::normal(value, spread_m_) : Distribution(value);
    }
  }

 private:
  double spread_m_;
};

std::vector<DrawnRobot> drawn_robots(const sim::RobotStates& robots, const Field& field,
                                     const LoggedNumbers& numbers) {
  std::vector<DrawnRobot> drawn;
  for (const sim::RobotState& robot : robots) {
    DrawnRobot one;
    one.number = robot.number;
    numbers.set(numbers_of(one, field),
                {robot.position_m.x(), robot.position_m.y(), robot.velocity_mps.x(),
                 robot.velocity_mps.y(), robot.angular_velocity_radps});
    one.heading_deg = rounded_value(angle_of(robot.heading) * 180 / kPi);
    drawn.push_back(one);
  }
  return drawn;
}

Restart restart_of(const std::optional<Command>& command) {
  if (!command) return Restart::kNone;
  switch (command->kind) {
    case CommandKind::kPrepareKickoff:
      return Restart::kKickoff;
    case CommandKind::kPreparePenalty:
      return Restart::kPenalty;
    case CommandKind::kDirectFree:
      return Restart::kDirectFree;
    case CommandKind::kIndirectFree:
      return Restart::kIndirectFree;
    default:
      return Restart::kForceStart;
  }
}

const std::vector<std::string> kByHand = {"restart", "taken_by",  "after_stop",
                                          "ball",    "attackers", "defenders"};
const std::vector<std::string> kTakers = {"attackers", "defenders"};

template <typename Numbers>
void read_numbers(const game::YamlFile& file, const std::vector<game::YamlEntry>& entries,
                  const std::string& path, const Numbers& numbers) {
  for (const auto& number : numbers) {
    const game::YamlEntry* entry = game::find_entry(entries, number.key);
    if (entry == nullptr) continue;
    *number.place = read_distribution(file, *entry, fmt::format("{}.{}", path, number.key),
                                      number.range, number.unit);
  }
}

template <typename Numbers>
std::vector<std::string> keys_of(const Numbers& numbers) {
  std::vector<std::string> keys;
  keys.reserve(numbers.size());
  for (const auto& number : numbers) keys.emplace_back(number.key);
  return keys;
}

void refuse_missing(const game::YamlFile& file, const game::YamlEntry& entry,
                    const std::string& path, const std::vector<game::YamlEntry>& entries) {
  for (const char* key : {"x_m", "y_m"}) {
    if (game::find_entry(entries, key) == nullptr)
      file.refuse(entry.location, path, fmt::format("the key '{}' is missing", key));
  }
}

// The entries of a mapping that has no unknown keys.
std::vector<game::YamlEntry> known_entries(const game::YamlFile& file, const game::YamlEntry& entry,
                                           const std::string& path,
                                           const std::vector<std::string>& known) {
  const game::Mapping checked(file, entry, path, known);
  return file.entries(entry, path, known);
}

}  // namespace

void take_from_log(const LoggedInstant& instant, const Field& field, int most_attackers,
                   int most_defenders, SituationSetup& situation) {
  const logs::LoggedState logged = logs::logged_state(instant.log, instant.at_s);
  logs::check_same_field(logged, field);
  game::StartState start =
      instant.attackers == Side::kWest ? logged.start : game::mirrored(logged.start);
  logs::renumber(start, Side::kWest, most_attackers);
  logs::renumber(start, Side::kEast, most_defenders);
  // Before a restart, the ball is at rest where the restart is taken.
  const referee::MidwayStart& midway_start = start.referee;
  if (midway_start.restart) start.ball = {midway_start.ball_m, {0, 0}, 0, 0, true};
  const LoggedNumbers numbers(instant.spread_m);
  situation.attackers = drawn_robots(start.robots[Side::kWest], field, numbers);
  situation.defenders = drawn_robots(start.robots[Side::kEast], field, numbers);
  const sim::BallState& ball = start.ball;
  LoggedNumbers(midway_start.restart ? 0 : instant.spread_m)
      .set(numbers_of(situation.ball, field),
           {ball.position_m.x(), ball.position_m.y(), ball.velocity_mps.x(), ball.velocity_mps.y(),
            ball.height_m, ball.vertical_mps});
  situation.restart = restart_of(midway_start.restart);
  situation.is_attackers_restart =
      !midway_start.restart || midway_start.restart->side == Side::kWest;
  situation.is_after_stop = midway_start.is_stopped;
}

SituationSetup SituationReader::read(const game::YamlEntry& entry) const {
  check_name(file_, entry, "situations", "situation");
  const std::string path = fmt::format("situations.{}", entry.key);
  locations_[path] = entry.location;
  const std::vector<game::YamlEntry> all = file_.entries(entry, path, {});
  const game::YamlEntry* from = game::find_entry(all, "from");
  std::vector<std::string> known = scene_key_names();
  known.emplace_back("from");
  if (from == nullptr) known.insert(known.end(), kByHand.begin(), kByHand.end());
  const std::vector<game::YamlEntry> entries = known_entries(file_, entry, path, known);
  SituationSetup situation;
  situation.scene = scene_;
  read_scene(file_, entries, path, situation.scene);
  if (from != nullptr) {
    read_log(*from, path + ".from", situation);
  } else {
    read_by_hand(entries, path, situation);
  }
  return situation;
}

std::string SituationReader::word(const game::YamlEntry& entry, const std::string& path,
                                  const std::vector<std::string>& known) const {
  std::string word = file_.scalar(entry, path, "one of " + io::listed(known), false);
  if (std::find(known.begin(), known.end(), word) != known.end()) return word;
  file_.refuse(game::value_location(entry), path,
               fmt::format("expected one of {}, found '{}'{}", io::listed(known), word,
                           io::suggestion(word, known)));
}

void SituationReader::read_by_hand(const std::vector<game::YamlEntry>& entries,
                                   const std::string& path, SituationSetup& situation) const {
  read_restart(entries, path, situation);
  read_ball(entries, path, situation);
  if (const game::YamlEntry* robots = game::find_entry(entries, "attackers"))
    read_robots(*robots, path + ".attackers", situation.attackers);
  if (const game::YamlEntry* robots = game::find_entry(entries, "defenders"))
    read_robots(*robots, path + ".defenders", situation.defenders);
}

void SituationReader::read_restart(const std::vector<game::YamlEntry>& entries,
                                   const std::string& path, SituationSetup& situation) const {
  if (const game::YamlEntry* restart = game::find_entry(entries, "restart")) {
    const std::string name = word(*restart, path + ".restart", all_names<Restart>());
    situation.restart = find_named<Restart>(name).value();
  }
  if (const game::YamlEntry* taker = game::find_entry(entries, "taken_by"))
    situation.is_attackers_restart = word(*taker, path + ".taken_by", kTakers) == "attackers";
  const game::YamlEntry* stop = game::find_entry(entries, "after_stop");
  if (stop == nullptr) return;
  situation.is_after_stop = word(*stop, path + ".after_stop", {"true", "false"}) == "true";
  if (situation.is_after_stop && situation.restart == Restart::kNone)
    file_.refuse(stop->location, path + ".after_stop",
                 "a scene that begins with STOP also needs a restart");
}

// For kick-offs and penalty kicks, the key `ball` can be left out: the ball is then on its spot.
void SituationReader::read_ball(const std::vector<game::YamlEntry>& entries,
                                const std::string& path, SituationSetup& situation) const {
  const game::YamlEntry* ball = game::find_entry(entries, "ball");
  if (situation.restart == Restart::kPenalty) {
    const Side defended = situation.is_attackers_restart ? Side::kEast : Side::kWest;
    situation.ball.x_m = field_.penalty_mark_at(defended).x();
  }
  if (ball == nullptr) {
    if (situation.restart == Restart::kPenalty || situation.restart == Restart::kKickoff) return;
    file_.refuse(locations_[path], path, "the key 'ball' is missing");
  }
  const auto numbers = numbers_of(situation.ball, field_);
  const std::vector<game::YamlEntry> its =
      known_entries(file_, *ball, path + ".ball", keys_of(numbers));
  refuse_missing(file_, *ball, path + ".ball", its);
  read_numbers(file_, its, path + ".ball", numbers);
}

void SituationReader::read_robots(const game::YamlEntry& entry, const std::string& path,
                                  std::vector<DrawnRobot>& robots) const {
  for (const game::YamlEntry& robot : file_.entries(entry, path, {})) {
    const std::optional<int> number = io::whole_number_in(robot.key);
    if (!number || *number < 0 || *number >= kMaxRobots) {
      file_.refuse(robot.location, path,
                   fmt::format("expected the number of a robot, from 0 to {}, found '{}'",
                               kMaxRobots - 1, robot.key));
    }
    const std::string its_path = fmt::format("{}.{}", path, *number);
    locations_[its_path] = robot.location;
    robots.push_back(read_robot(robot, its_path));
    robots.back().number = *number;
  }
  std::sort(robots.begin(), robots.end(),
            [](const DrawnRobot& a, const DrawnRobot& b) { return a.number < b.number; });
  const auto same = std::adjacent_find(
      robots.begin(), robots.end(),
      [](const DrawnRobot& a, const DrawnRobot& b) { return a.number == b.number; });
  if (same != robots.end())
    file_.refuse(entry.location, path, fmt::format("robot {} is given twice", same->number));
}

DrawnRobot SituationReader::read_robot(const game::YamlEntry& entry,
                                       const std::string& path) const {
  DrawnRobot robot;
  const auto numbers = numbers_of(robot, field_);
  std::vector<std::string> keys = keys_of(numbers);
  keys.emplace_back("heading_deg");
  const std::vector<game::YamlEntry> entries = known_entries(file_, entry, path, keys);
  refuse_missing(file_, entry, path, entries);
  read_numbers(file_, entries, path, numbers);
  if (const game::YamlEntry* heading = game::find_entry(entries, "heading_deg")) {
    robot.heading_deg =
        read_distribution(file_, *heading, path + ".heading_deg", kHeading_deg, "deg");
  }
  return robot;
}

void SituationReader::read_log(const game::YamlEntry& entry, const std::string& path,
                               SituationSetup& situation) const {
  const game::Mapping from(file_, entry, path, {"log", "at_s", "attackers", "spread_m"});
  for (const char* key : {"log", "at_s"}) {
    if (from.find(key) == nullptr)
      file_.refuse(entry.location, path, fmt::format("the key '{}' is missing", key));
  }
  const game::YamlEntry& log = *from.find("log");
  LoggedInstant instant;
  instant.log = file_.folder() / file_.scalar(log, path + ".log", "an SSL log", false);
  from.number("at_s", instant.at_s, {0, 1e6}, "s");
  from.number("spread_m", instant.spread_m, {0, 1}, "m");
  std::string attackers = "yellow";
  from.word("attackers", attackers, {"yellow", "blue"});
  instant.attackers = attackers == "yellow" ? Side::kWest : Side::kEast;
  try {
    take_from_log(instant, field_, teams_.attackers, teams_.defenders, situation);
  } catch (const std::invalid_argument& error) {
    file_.refuse(game::value_location(log), path, error.what());
  }
}

}  // namespace autoref::experiments
