#include "view/game_recording.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/errors.hpp"
#include "referee/event.hpp"
#include "soccer/units.hpp"

namespace autoref::view {
namespace {

using referee::Event;

struct ShownText {
  const char* name;  // name on the page
  const char* key;   // key in the event log
  std::string RecordedDecision::*text;
};

// The texts that a page shows in addition to time, event and position.
constexpr ShownText kShownTexts[] = {
    {"rule", "rule", &RecordedDecision::rule},
    {"reason", "evidence", &RecordedDecision::reason},
    {"offender", "offender", &RecordedDecision::offender},
    {"card", "card", &RecordedDecision::card},
    {"card_reason", "card_reason", &RecordedDecision::card_reason},
    {"restart", "restart", &RecordedDecision::restart},
};

// Returns the text under this key, or an empty string if there is none.
std::string text_at(const io::Json& line, const char* key) {
  const auto found = line.find(key);
  return found != line.end() && found->is_string() ? found->get<std::string>() : "";
}

// Throws Json::exception if a coordinate is not a number.
std::optional<Vec2> position_in(const io::Json& line) {
  const auto found = line.find("position_m");
  if (found == line.end() || !found->is_array() || found->size() != 2) return std::nullopt;
  return Vec2((*found)[0].get<double>(), (*found)[1].get<double>());
}

constexpr double kTicksPerSecond = 10'000;
constexpr double kMostTicks = 4e9;  // 111 hours

using Triple = std::array<PackedColumn, 3>;
using Numbers = std::array<std::int16_t, 3>;

constexpr Numbers kNotSeen = {PackedColumn::kNothing, PackedColumn::kNothing,
                              PackedColumn::kNothing};

std::int16_t packed_mm(double metres) { return packed(metres * 1000); }

Numbers numbers_of(const RobotObservation& robot) {
  return {packed_mm(robot.position_m.x()), packed_mm(robot.position_m.y()),
          packed(angle_of(robot.heading) * 1800 / kPi)};
}

Numbers numbers_of(const std::optional<BallObservation>& ball) {
  if (!ball) return kNotSeen;
  return {packed_mm(ball->position_m.x()), packed_mm(ball->position_m.y()),
          ball->height_m ? packed_mm(*ball->height_m) : PackedColumn::kNothing};
}

void add_to(Triple& columns, const Numbers& numbers) {
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i].add(numbers[i]);
}

Triple unseen_for(std::size_t frames) {
  Triple columns;
  for (PackedColumn& column : columns) column.begin_with_nothing(frames);
  return columns;
}

// Signals arrive with every frame, but only a few change the page.
bool show_the_same(const RefereeSignal& one, const RefereeSignal& other) {
  const auto target = [](const RefereeSignal& signal) {
    return signal.placement ? std::optional(signal.placement->target_m) : std::nullopt;
  };
  return one.command == other.command && one.command_counter == other.command_counter &&
         one.stage == other.stage && one.goals == other.goals &&
         one.shootout_goals == other.shootout_goals && one.yellow_cards == other.yellow_cards &&
         one.red_cards == other.red_cards && one.next_command == other.next_command &&
         one.blue_on_positive_half == other.blue_on_positive_half && target(one) == target(other);
}

// The time left, rounded up as clocks do; limited to a day, in case the input is invalid.
int shown_seconds(double left_s) {
  return static_cast<int>(std::ceil(std::clamp(left_s, -86'400.0, 86'400.0) - 1e-6));
}

}  // namespace

bool is_shown(const std::string& event) {
  constexpr std::array kInEveryGame = {
      Event::kBegin,        Event::kRobotsMoved, Event::kStartTimeout, Event::kReady,
      Event::kReadyTimeout, Event::kSignalled,   Event::kCommandGiven};
  return std::none_of(kInEveryGame.begin(), kInEveryGame.end(),
                      [&](Event one) { return name_of(one) == event; });
}

RecordedDecision recorded(const io::Json& line) {
  RecordedDecision decision;
  decision.time_s = line.at("time_s").get<double>();
  decision.event = line.at("event").get<std::string>();
  for (const ShownText& shown : kShownTexts) decision.*shown.text = text_at(line, shown.key);
  decision.position_m = position_in(line);
  return decision;
}

std::vector<RecordedDecision> decisions_in(std::string_view lines, const std::string& file) {
  std::vector<RecordedDecision> decisions;
  for (int number = 1; !lines.empty(); ++number) {
    const std::string line(lines.substr(0, lines.find('\n')));
    lines.remove_prefix(std::min(line.size() + 1, lines.size()));
    if (line.empty()) continue;
    try {
      decisions.push_back(recorded(io::Json::parse(line)));
    } catch (const io::Json::exception&) {
      throw io::InputError(
          {file, number, 1}, "",
          "this is not a referee's decision as written by `autoref play --events`");
    }
  }
  return decisions;
}

io::Json page_json(const RecordedDecision& decision) {
  io::Json json = {{"time_s", decision.time_s}, {"event", decision.event}};
  for (const ShownText& shown : kShownTexts) {
    const std::string& text = decision.*shown.text;
    json[shown.name] = text.empty() ? io::Json() : io::Json(text);
  }
  const std::optional<Vec2>& at_m = decision.position_m;
  json["position_m"] = at_m ? io::Json::array({at_m->x(), at_m->y()}) : io::Json();
  return json;
}

void GameRecording::add(const Frame& frame) {
  if (frames_ >= kMostFrames) {
    is_full_ = true;
    return;
  }
  if (frames_ == 0) first_s_ = frame.time_s;
  last_s_ = frame.time_s;
  add_time(frame.time_s);
  for (const Side side : kSides) add_robots(frame.robots[side], robots_[side]);
  add_to(ball_, numbers_of(frame.ball));
  ++frames_;
}

void GameRecording::add_time(double time_s) {
  const double ticks = std::clamp(time_s * kTicksPerSecond, 0.0, kMostTicks);
  const auto bits = static_cast<std::uint32_t>(std::llround(ticks));
  for (const unsigned shift : {0U, 8U, 16U, 24U})
    times_ += static_cast<char>(bits >> shift & 0xffU);
}

void GameRecording::add_robots(const SeenRobots& robots, Columns& columns) {
  std::array<Numbers, kMaxRobots> seen{};
  seen.fill(kNotSeen);
  for (const RobotObservation& robot : robots) {
    const auto number = static_cast<std::size_t>(robot.number);
    seen[number] = numbers_of(robot);
    // Columns are created when a robot first appears, and padded to the length of the others.
    if (!columns[number]) columns[number] = unseen_for(frames_);
  }
  for (std::size_t number = 0; number < seen.size(); ++number)
    if (columns[number]) add_to(*columns[number], seen[number]);
}

void GameRecording::add(double time_s, const RefereeSignal& signal) {
  if (signals_.size() >= kMostSignals || clock_.size() >= kMostSignals) {
    is_full_ = true;
    return;
  }
  if (last_signal_) time_s = std::max(time_s, last_signal_->time_s);
  if (last_mark_) time_s = std::max(time_s, last_mark_->time_s);
  if (!last_signal_ || !show_the_same(last_signal_->signal, signal)) {
    last_signal_ = {time_s, signal};
    signals_.push_back(*last_signal_);
  }
  const int left_s = shown_seconds(signal.stage_time_left_s);
  if (last_mark_ && last_mark_->left_s == left_s) return;
  last_mark_ = {time_s, left_s};
  clock_.push_back(*last_mark_);
}

GameRecording GameRecording::take_recording() {
  GameRecording taken;
  std::swap(taken, *this);
  last_signal_ = taken.last_signal_;
  last_mark_ = taken.last_mark_;
  return taken;
}

void GameRecording::add(RecordedDecision decision) {
  if (is_shown(decision.event)) add_to_list(decisions_, kMostDecisions, std::move(decision));
}

void GameRecording::add(RecordedChain chain) {
  add_to_list(chains_, kMostChains, std::move(chain));
}

void GameRecording::add(RecordedAction action) {
  add_to_list(actions_, kMostActions, std::move(action));
}

void GameRecording::add(const RecordedShot& shot) { add_to_list(shots_, kMostShots, shot); }

void GameRecording::add(const RecordedWinProbability& probability) {
  add_to_list(win_probabilities_, kMostWinProbabilities, probability);
}

template <typename T>
void GameRecording::add_to_list(std::vector<T>& list, std::size_t most, T value) {
  if (list.size() < most) {
    list.push_back(std::move(value));
  } else {
    is_full_ = true;
  }
}

std::vector<RobotId> GameRecording::robots() const {
  std::vector<RobotId> robots;
  for (const Side side : kSides) {
    for (int number = 0; number < kMaxRobots; ++number)
      if (robots_[side][static_cast<std::size_t>(number)]) robots.push_back({side, number});
  }
  return robots;
}

std::string GameRecording::bytes() const {
  std::string bytes = times_;
  const auto append = [&bytes](const Triple& columns) {
    for (const PackedColumn& column : columns) bytes += column.bytes();
  };
  for (const RobotId robot : robots())
    append(*robots_[robot.side][static_cast<std::size_t>(robot.number)]);
  append(ball_);
  return bytes;
}

}  // namespace autoref::view
