#include "live/controller/controlled_game.hpp"

#include <chrono>
#include <cmath>
#include <deque>
#include <thread>
#include <utility>
#include <vector>

#include "game/loop/game.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/game_event_fields.hpp"
#include "io/errors.hpp"
#include "league/field_message.hpp"
#include "league/tracker_message.hpp"
#include "live/controller/controller_client.hpp"
#include "live/controller/controller_differences.hpp"
#include "live/controller/controller_operator.hpp"
#include "live/controller/followed_signal.hpp"
#include "live/controller/placement_watch.hpp"
#include "live/frame_pacer.hpp"
#include "live/live_options.hpp"
#include "live/published_tracks.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::live {
namespace {

// The time of the first frame on the controller's clock: 1 January 2026.
constexpr double kStart_s = 1767225600;
constexpr double kGeometryEvery_s = 1;
constexpr double kTickEvery_s = 0.025;  // the period of the controller's own clock
constexpr double kRounding_s = 1e-6;    // of differences of frame times
// After an event is due, or a time has run out, changes are expected for this long.
constexpr double kSettling_s = 2 * kTickEvery_s;
constexpr std::chrono::milliseconds kLongestEffect{2000};  // longest wait for an action's effect
// Longest wait for the reply to an event and for the answer to the last input.
constexpr std::chrono::milliseconds kLongestReply{500};
constexpr std::chrono::seconds kLongestRegistration{5};
constexpr std::chrono::milliseconds kPoll{1};

}  // namespace

class ControlledGame::Impl final : public game::Observer {
 public:
  Impl(const game::GameConfiguration& game, const ControllerPlace& place,
       std::function<bool()> is_interrupted)
      : game_(game),
        is_interrupted_(std::move(is_interrupted)),
        connection_(place.ci),
        autoref_(thread_, {place.ci.host, place.autoref_port}, kIdentifier),
        operator_(game),
        followed_(game) {
    if (game.match.knockout)
      throw io::InputError({"--game-controller"}, "", "games with extra time are not supported");
    league::fill_geometry(game.field, game::logged_cameras(game), geometry_);
  }

  game::PlayedGame play(game::Observers observers, game::GamePrograms& programs,
                        std::optional<double> frames_per_s) {
    await([this] { return autoref_.status().is_registered; }, kLongestRegistration);
    if (is_interrupted_()) throw io::Interrupted();
    observers.add(this);
    game::Game game(game_, observers, programs.maker());
    is_set_up_ = true;
    exchange(game, operator_.set_up(requests_));
    SteadyFrameClock clock;
    std::optional<FramePacer> pacer;
    if (frames_per_s) pacer.emplace(clock, *frames_per_s);
    do {
      if (pacer) pacer->wait();
      if (is_interrupted_() || !programs.before_step(game)) return {game.record(), true};
      if (!game.begin_step()) break;
      const bool reports = report_events(game);
      const ControllerOperator::Inputs inputs =
          operator_.act(followed_.packet(), followed_.signal(), game.tracks());
      const bool is_due = game.tracks().time_s - tick_s_ >= kTickEvery_s - kRounding_s;
      if (reports || is_due || !inputs.empty()) exchange(game, inputs);
      differences_.add(followed_.packet(), followed_.signal(), game.frame().time_s);
    } while (game.end_step());
    return {game.record()};
  }

  ~Impl() override {
    if (!is_set_up_) return;
    try {
      league::CiInput input = timed_input(tick_s_);
      *input.mutable_api_inputs() = ControllerOperator::leave();
      connection_.send(input);
      const auto is_any = [](const league::CiOutput&) { return true; };
      connection_.read_until(is_any, kLongestReply);
    } catch (const io::InputError&) {  // the connection is lost
    }
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  ControlledGameReport report() const {
    const ControllerStatus status = autoref_.status();
    return {status.counts.accepted, status.counts.rejected,
            static_cast<std::int64_t>(status.waiting) + status.counts.dropped, status.problem,
            differences_.text()};
  }

  void on_requests(const PerSide<TeamRequests>& requests) override { requests_ = requests; }
  void on_decision(const referee::Decision& decision) override {
    operator_.on_decision(decision);
    differences_.on_decision(decision);
    if (std::optional<GameEvent> event = game::game_event_of(decision, kStart_s))
      events_.push_back(*std::move(event));
  }

 private:
  // Waits until the condition holds or the game is interrupted, but at most for the given time.
  template <typename Condition>
  void await(const Condition& condition, std::chrono::milliseconds longest) {
    const auto deadline = std::chrono::steady_clock::now() + longest;
    while (!condition() && !is_interrupted_() && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(kPoll);
  }

  // The controller's clock stands still until it has answered. The time that it gives an event is
  // therefore that of the frame in which the event was reported.
  // Returns whether there were any.
  bool report_events(const game::Game& game) {
    if (std::optional<GameEvent> event = placement_.update(followed_.signal(), game.tracks()))
      events_.push_back(*std::move(event));
    if (events_.empty()) return false;
    due_s_.push_back(tick_s_ + ControllerOperator::kProposal_s);
    operator_.await_event(due_s_.back() + kSettling_s);
    for (const GameEvent& event : events_) autoref_.report(event);
    sent_ += static_cast<std::int64_t>(events_.size());
    events_.clear();
    const auto is_answered = [this] {
      const ControllerStatus status = autoref_.status();
      return status.counts.accepted + status.counts.rejected + status.counts.dropped >= sent_;
    };
    await(is_answered, kLongestReply);
    return true;
  }

  static league::CiInput timed_input(double time_s) {
    league::CiInput input;
    input.set_timestamp(std::llround((kStart_s + time_s) * 1e9));
    return input;
  }

  void exchange(game::Game& game, const ControllerOperator::Inputs& inputs) {
    const Tracks& tracks = game.tracks();
    league::CiInput input = timed_input(tracks.time_s);
    *input.mutable_api_inputs() = inputs;
    const bool is_turned = !followed_.signal().blue_on_positive_half;
    league::fill_tracker(is_turned ? turned(tracks) : tracks, source_, kStart_s + tracks.time_s,
                         *input.mutable_tracker_packet());
    if (tracks.time_s >= geometry_due_s_) {
      *input.mutable_geometry() = geometry_;
      geometry_due_s_ = tracks.time_s + kGeometryEvery_s;
    }
    league::CiOutput newest = connection_.exchange(input);
    tick_s_ = tracks.time_s;
    const auto take = [&](std::optional<league::CiOutput> output) {
      if (output) newest = *std::move(output);
    };
    const auto is_done = [&](const league::CiOutput& output) {
      return operator_.is_done(output.referee_msg());
    };
    if (!inputs.empty() && inputs[0].has_continue_action() && !is_done(newest))
      take(connection_.read_until(is_done, kLongestEffect));
    if (!inputs.empty() || may_change()) take(connection_.read_until_silence());
    apply(newest, game);
  }

  // Whether the controller may have made a change of its own in this tick, because an event has
  // become old enough to count or because a time has run out. Other changes of its own may come
  // later: no action depends on them.
  bool may_change() {
    while (!due_s_.empty() && due_s_.front() + kSettling_s < tick_s_) due_s_.pop_front();
    const bool is_event_due = !due_s_.empty() && due_s_.front() <= tick_s_ + kTickEvery_s;
    const CommandKind kind = followed_.signal().command.kind;
    const league::RefereePacket& packet = followed_.packet();
    const bool is_timed = packet.has_current_action_time_remaining() &&
                          (kind == CommandKind::kBallPlacement || !is_before_restart(kind));
    const double left_s = static_cast<double>(packet.current_action_time_remaining()) / 1e6;
    return is_event_due || (is_timed && std::abs(left_s) <= kSettling_s);
  }

  void apply(const league::CiOutput& output, game::Game& game) {
    if (!followed_.take(output.referee_msg(), game.frame().time_s))
      throw io::InputError({"--game-controller"}, "",
                           "the game controller sent an unknown command or stage");
    const RefereeSignal& signal = followed_.signal();
    game.follow(operator_.places_ball() ? with_ball_placed_by_hand(signal) : signal);
  }

  game::GameConfiguration game_;
  std::function<bool()> is_interrupted_;
  NetworkThread thread_;
  CiConnection connection_;
  ControllerClient autoref_;
  ControllerOperator operator_;
  ControllerDifferences differences_;
  PlacementWatch placement_;
  league::Geometry geometry_;
  league::TrackerSource source_{"00000000-0000-4000-8000-000000000000", kIdentifier};
  double geometry_due_s_ = 0;
  PerSide<TeamRequests> requests_;
  std::vector<GameEvent> events_;  // events to report
  std::int64_t sent_ = 0;
  bool is_set_up_ = false;    // whether the match has been set up
  double tick_s_ = 0;         // time of the newest input
  std::deque<double> due_s_;  // when reported events are old enough to count
  FollowedSignal followed_;
};

ControlledGame::ControlledGame(const game::GameConfiguration& game, const ControllerPlace& place,
                               std::function<bool()> is_interrupted)
    : impl_(std::make_unique<Impl>(game, place, std::move(is_interrupted))) {}
ControlledGame::~ControlledGame() = default;

game::PlayedGame ControlledGame::play(game::Observers observers, game::GamePrograms& programs,
                                      std::optional<double> frames_per_s) {
  return impl_->play(std::move(observers), programs, frames_per_s);
}

ControlledGameReport ControlledGame::report() const { return impl_->report(); }

}  // namespace autoref::live
