// A recording of a game: every frame, the referee's signals and its decisions, and the possession
// chains, shots and win probability, as far as they are known, packed for a page (page.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/json.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/referee_signal.hpp"
#include "view/packed_column.hpp"

namespace autoref::view {

// A decision of the referee, as shown on a page. Texts are those of the event log; a null there
// becomes an empty text.
struct RecordedDecision {
  double time_s = 0;
  std::string event;
  std::string rule;
  std::string reason;    // a sentence
  std::string offender;  // a colour
  std::string card;
  std::string card_reason;
  std::string restart;
  std::optional<Vec2> position_m;  // as published (soccer/referee_signal.hpp)
  bool operator==(const RecordedDecision&) const = default;
};

// Whether pages show this event. Pages omit routine events, such as robots being ready for a
// restart.
bool is_shown(const std::string& event);

// The part of an event log's line that a page shows. Throws Json::exception if the line is not a
// decision.
RecordedDecision recorded(const io::Json& line);

// The decisions of an event log, as written by `autoref play --events`: `lines`, one JSON object
// per line. Throws InputError with `file` and the line's number if a line is not a decision.
std::vector<RecordedDecision> decisions_in(std::string_view lines, const std::string& file);

// The decision as the page's script reads it (view/page/highlights.js).
io::Json page_json(const RecordedDecision& decision);

struct RecordedSignal {
  double time_s = 0;
  RefereeSignal signal;
};

// The stage's clock showed `left_s` from `time_s` on.
struct ClockMark {
  double time_s = 0;
  int left_s = 0;
};

// A possession chain.
struct RecordedChain {
  double start_s = 0;
  double end_s = 0;
  Side team = Side::kWest;
  std::string start;  // how it began and how it ended: names in ChainKinds
  std::string end;
  int passes = 0;
  int shots = 0;
  double xg = 0;  // expected goals of these shots
};

// A shot.
struct RecordedShot {
  double time_s = 0;
  Side team = Side::kWest;
  Vec2 from_m{0, 0};  // the ball's position at that time, as published
  double xg = 0;      // probability that it scores
  bool has_scored = false;
};

// What a robot of a simulated game did with the ball.
struct RecordedAction {
  double start_s = 0;
  double end_s = 0;
  Side team = Side::kWest;
  int robot = -1;     // number; -1 if unknown
  std::string kind;   // name of a game::ActionKind
  Vec2 from_m{0, 0};  // the ball's positions at these times, as published
  Vec2 to_m{0, 0};
  double worth = 0;  // goals
};

// The win probability of a simulated game at some time. East wins otherwise.
struct RecordedWinProbability {
  double time_s = 0;
  double west = 0;
  double draw = 0;
};

// Takes positions as published (soccer/referee_signal.hpp).
class GameRecording {
 public:
  // Frames, signals, decisions, chains and so on beyond these limits are left out. No game in the
  // league reaches these limits: kMostFrames frames last 4.6 hours at 60 frames per second.
  static constexpr std::size_t kMostFrames = 1'000'000;
  static constexpr std::size_t kMostSignals = 100'000;
  static constexpr std::size_t kMostDecisions = 100'000;
  static constexpr std::size_t kMostChains = 100'000;
  static constexpr std::size_t kMostShots = 100'000;
  static constexpr std::size_t kMostActions = 100'000;
  static constexpr std::size_t kMostWinProbabilities = 100'000;

  // Times must increase.
  void add(const Frame& frame);

  // Stores the signal if it differs visibly from the previous one. A time earlier than the previous
  // signal's is replaced by that time.
  void add(double time_s, const RefereeSignal& signal);

  // Stores the decision if pages show it.
  void add(RecordedDecision decision);

  void add(RecordedChain chain);
  void add(const RecordedShot& shot);
  void add(RecordedAction action);
  void add(const RecordedWinProbability& probability);

  // Returns the recording so far and begins an empty one, which continues from the previous
  // signals.
  GameRecording take_recording();

  std::size_t frames() const { return frames_; }
  double first_s() const { return first_s_; }
  double last_s() const { return last_s_; }
  const std::vector<RecordedSignal>& signals() const { return signals_; }
  const std::vector<ClockMark>& clock() const { return clock_; }
  const std::vector<RecordedDecision>& decisions() const { return decisions_; }
  const std::vector<RecordedChain>& chains() const { return chains_; }
  const std::vector<RecordedShot>& shots() const { return shots_; }
  const std::vector<RecordedAction>& actions() const { return actions_; }
  const std::vector<RecordedWinProbability>& win_probabilities() const {
    return win_probabilities_;
  }
  bool is_full() const { return is_full_; }  // whether anything was left out

  // All robots seen so far, in the order of their columns.
  std::vector<RobotId> robots() const;

  // The frames as bytes. First comes each frame's time in units of 0.1 ms, as a little-endian
  // uint32. Then come columns (packed_column.hpp): for each robot x and y in mm and the heading in
  // 0.1 degrees, counter-clockwise from x. The last columns are the ball's x, y and height in mm.
  // The height is kNothing if vision does not provide it.
  std::string bytes() const;

 private:
  using Triple = std::array<PackedColumn, 3>;
  // Columns by robot number; nullopt: robot never seen.
  using Columns = std::array<std::optional<Triple>, kMaxRobots>;

  void add_time(double time_s);
  void add_robots(const SeenRobots& robots, Columns& columns);

  // Appends the value unless the list is full.
  template <typename T>
  void add_to_list(std::vector<T>& list, std::size_t most, T value);

  std::size_t frames_ = 0;
  double first_s_ = 0;
  double last_s_ = 0;
  std::string times_;
  PerSide<Columns> robots_;
  Triple ball_;
  std::vector<RecordedSignal> signals_;
  std::vector<ClockMark> clock_;
  std::vector<RecordedDecision> decisions_;
  std::vector<RecordedChain> chains_;
  std::vector<RecordedShot> shots_;
  std::vector<RecordedAction> actions_;
  std::vector<RecordedWinProbability> win_probabilities_;
  std::optional<RecordedSignal> last_signal_;
  std::optional<ClockMark> last_mark_;
  bool is_full_ = false;
};

}  // namespace autoref::view
