#include "live/simulator/live_game.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <utility>

#include "game/loop/game.hpp"
#include "io/errors.hpp"
#include "live/frame_pacer.hpp"
#include "live/simulator/command_slots.hpp"
#include "live/simulator/control_requests.hpp"
#include "live/simulator/game_publisher.hpp"
#include "live/simulator/robot_reports.hpp"
#include "live/simulator/robot_updates.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::live {
namespace {

constexpr double kAfterEnd_s = 1;
constexpr double kLongestControlled_s = 86'400;  // a match with people takes as long as it takes
constexpr std::chrono::milliseconds kSlice{50};  // length of a wait before checking for interrupts
constexpr std::chrono::milliseconds kLastSlice{500};  // time for the last requests after the game
// The time of the first frame in lock-step, so that the packets are the same in each run: 1 January
// 2026.
constexpr double kLockstepStart_s = 1767225600;

double now_unix_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

int frames_of(double seconds, const game::GameConfiguration& game) {
  return static_cast<int>(std::lround(seconds * game.sim.frame_rate_hz));
}

}  // namespace

class LiveGame::Impl {
 public:
  Impl(const game::GameConfiguration& game, const LiveOptions& options, FrameClock& clock,
       std::function<bool()> is_interrupted)
      : game_(game),
        options_(options),
        is_interrupted_(std::move(is_interrupted)),
        is_network_(network_sides(game)),
        slots_(frames_of(options.lapse_s, game)),
        robot_updates_(game),
        lock_step_(is_network_, game.sim.frame_rate_hz),
        publisher_(game, options,
                   options.speed.pace == Pace::kLockStep ? kLockstepStart_s : now_unix_s()),
        ports_(thread_, options, game,
               {&slots_, &requests_, &robot_updates_,
                options.speed.pace == Pace::kLockStep ? &lock_step_ : nullptr}),
        clock_(&clock),
        pacer_(clock, game.sim.frame_rate_hz * options.speed.factor),
        waiting_pacer_(clock, game.sim.frame_rate_hz) {
    if (game.match.control == referee::Control::kGameController) {
      assert(options.speed.pace == Pace::kClock);
      controller_.emplace(game, options);
      game_.longest_s = kLongestControlled_s;
    }
    for (const Side side : kSides) states_[side].wheels = wheels_of(game::team_on(game, side));
  }

  std::unique_ptr<strategies::Strategy> make_network_team(
      const strategies::TeamContext& context) const {
    return std::make_unique<NetworkTeam>(inputs_[context.side]);
  }

  game::PlayedGame play(game::Observers observers, game::GamePrograms& programs) {
    observers.add(&publisher_);
    if (controller_) observers.add(&*controller_);
    game::Game game(game_, observers, programs.maker());
    if (options_.speed.pace == Pace::kLockStep) {
      publisher_.send_standing_field(waiting_signal(game));
    } else {
      await_start(game);
    }
    if (change_robots(programs)) game = game::Game(game_, observers, programs.maker());
    if (controller_) controller_->follow(game);
    be_prompt();  // call this after starting programs, since they would inherit the scheduling
    // An interrupted game ends between two steps, so that the recorded commands lead to its state.
    while (!is_interrupted_()) {
      // Count the packets before the frame is sent: a fast team may answer immediately.
      const PerSide<std::int64_t> before = slots_.packets();
      if (!game.begin_step()) break;
      print_notices();
      publisher_.publish(game.tracks());
      if (controller_) controller_->report(game, publisher_.start_unix_s());
      const PerSide<RobotReports> reports = reports_of(game_, game.world());
      ports_.report(reports);
      wait(game.frame().number, before, reports);
      const bool is_first = game.frame().number == 0;
      if (is_first && is_interrupted_()) throw io::Interrupted();  // the teams may never have come
      if (controller_) controller_->follow(game);
      collect_commands(game, before);
      if (!game.end_step()) break;
      control(game, programs);
    }
    if (!game.is_over()) return {game.record(), true};
    publish_end(game);
    return {game.record()};
  }

  LiveReport report() const {
    return {pacer_.punctuality(),
            publisher_.dropped(),
            ports_.traffic(),
            ports_.troubles(),
            ports_.wrong_control(),
            ages_,
            controller_ ? std::optional(controller_->summary()) : std::nullopt};
  }

 private:
  bool has_network_teams() const { return is_network_[Side::kWest] || is_network_[Side::kEast]; }

  // The signal before the game; the game's own signal begins with the first frame.
  RefereeSignal waiting_signal(const game::Game& game) const {
    RefereeSignal signal = game.signal();
    for (const Side side : kSides)
      signal.robots_allowed[side] = static_cast<int>(game::team_on(game_, side).robots.size());
    return signal;
  }

  // Sends the field in its state before the game until the game controller has a match, or until
  // every team has commanded a robot.
  void await_start(const game::Game& game) {
    const RefereeSignal waiting = waiting_signal(game);
    while (!may_start()) {
      if (is_interrupted_()) throw io::Interrupted();
      print_notices();
      publisher_.add_waiting_frame(game.world().state(), waiting);
    }
    pacer_.set_rate(game_.sim.frame_rate_hz * options_.speed.factor);
  }

  // Returns after the period of a frame, or as soon as the game may start.
  bool may_start() {
    if (!controller_)
      return slots_.wait({{0, 0}}, is_network_, CommandSlots::Clock::now() + frame_period());
    waiting_pacer_.wait();
    return controller_->has_match();
  }

  // Prints what prevents the game from starting or continuing.
  void print_notices() {
    if (const auto notice = controller_ ? controller_->take_notice() : std::nullopt)
      io::write_message(stderr, fmt::format("autoref: {}\n", *notice));
    for (const std::string& notice : ports_.take_notices())
      io::write_message(stderr, fmt::format("autoref: {}\n", notice));
  }

  // Applies what programs have set before the game.
  bool change_robots(game::GamePrograms& programs) {
    const std::vector<game::ChangedRobot> changed = robot_updates_.close();
    for (const game::ChangedRobot& robot : changed) {
      game::apply(robot, game_);
      programs.record(robot);
    }
    return !changed.empty();
  }

  CommandSlots::Clock::duration frame_period() const {
    return std::chrono::duration_cast<CommandSlots::Clock::duration>(
        std::chrono::duration<double>(1 / game_.sim.frame_rate_hz));
  }

  void wait(std::int64_t frame, const PerSide<std::int64_t>& before,
            const PerSide<RobotReports>& reports) {
    if (options_.speed.pace == Pace::kLockStep) {
      for (const std::string& detection : publisher_.detections())
        lock_step_.add_detection(detection);
      const auto take = [this](const league::SimulatorRequest& request) { requests_.add(request); };
      const bool is_first = frame == 0;
      wait_in_slices(
          [&](auto until) { return lock_step_.advance(frame, reports, slots_, take, until); },
          [&] {
            if (!is_first) set_faults_of_silent_teams(lock_step_.is_awaited());
            return !is_first;
          });
    } else if (options_.speed.pace == Pace::kClock) {
      pacer_.wait([this] {
        if (const std::optional<double> speed = requests_.speed()) set_speed(*speed);
      });
    } else if (has_network_teams() && frame >= sim::split_latency(game_.sim).frames) {
      wait_in_slices([&](auto until) { return slots_.wait(before, is_network_, until); },
                     [&] {
                       set_faults_of_silent_teams(silent_since(before));
                       return true;
                     });
    }
  }

  // Calls `wait` until it returns true or the game is interrupted. When the time limit for answers
  // has passed, `give_up` decides whether to stop waiting.
  template <typename Wait, typename GiveUp>
  void wait_in_slices(const Wait& wait, const GiveUp& give_up) {
    const auto deadline =
        CommandSlots::Clock::now() + std::chrono::duration_cast<CommandSlots::Clock::duration>(
                                         std::chrono::duration<double>(options_.answer_s));
    while (!wait(CommandSlots::Clock::now() + kSlice)) {
      if (is_interrupted_()) return;
      if (options_.speed.pace == Pace::kLockStep) publisher_.repeat_standing_field();
      print_notices();
      if (CommandSlots::Clock::now() >= deadline && give_up()) return;
    }
  }

  PerSide<bool> silent_since(const PerSide<std::int64_t>& before) const {
    const PerSide<std::int64_t> packets = slots_.packets();
    PerSide<bool> silent;
    for (const Side side : kSides) silent[side] = packets[side] <= before[side];
    return silent;
  }

  void set_faults_of_silent_teams(const PerSide<bool>& silent) {
    for (const Side side : kSides) {
      if (is_network_[side] && silent[side])
        inputs_[side].fault = fmt::format("sent no commands for {} s", options_.answer_s);
    }
  }

  void collect_commands(const game::Game& game, const PerSide<std::int64_t>& before) {
    const PerSide<std::int64_t> packets = slots_.packets();
    for (const Side side : kSides) {
      if (!is_network_[side]) continue;
      headings_of(game.world().state(), side, game.signal().blue_on_positive_half, states_[side]);
      inputs_[side].commands = slots_.collect_commands(side, game.frame().number, states_[side]);
      const bool is_new = packets[side] > before[side];
      silent_frames_[side] = is_new ? 0 : silent_frames_[side] + 1;
      ++ages_[side].at(static_cast<std::size_t>(std::min(silent_frames_[side], 2)));
    }
  }

  // Carries out the requests of the control port. While the speed is 0, the field is sent
  // unchanged.
  void control(game::Game& game, game::GamePrograms& programs) {
    for (bool is_first = true;; is_first = false) {
      for (const league::SimulatorRequest& request : requests_.take_all())
        control(request, game, programs);
      if (!is_paused_ || game.is_over() || is_interrupted_()) return;
      print_notices();
      if (controller_) controller_->follow(game);
      if (is_first) waiting_pacer_.set_rate(game_.sim.frame_rate_hz);
      waiting_pacer_.wait();
      publisher_.add_waiting_frame(game.world().state(), game.signal());
    }
  }

  void control(const league::SimulatorRequest& request, game::Game& game,
               game::GamePrograms& programs) {
    for (const league::Teleport& teleport : request.teleports) {
      const bool blue_on_positive_half = game.signal().blue_on_positive_half;
      if (const auto change =
              change_of(teleport, game.world().state(), game_.field, blue_on_positive_half))
        programs.change(*change, game);
    }
    if (request.vision_port) publisher_.set_vision_port(*request.vision_port);
    if (!request.speed || options_.speed.pace != Pace::kClock) return;
    set_speed(*request.speed);
  }

  // Sets the speed as a factor of real time; 0 pauses the game.
  void set_speed(double speed) {
    is_paused_ = speed == 0;
    if (!is_paused_ && speed != speed_) pacer_.set_rate(game_.sim.frame_rate_hz * speed);
    speed_ = speed;
  }

  // Sends the frame in which the game ended, and keeps sending it, so that everybody learns how it
  // ended.
  void publish_end(const game::Game& game) {
    Frame frame = game.frame();
    Tracks tracks = game.tracks();
    publisher_.publish(tracks);
    int left = frames_of(kAfterEnd_s, game_);
    while (!is_interrupted_() && wait_after_end(frame.number) && left-- > 0) {
      tracks.frame = ++frame.number;
      tracks.time_s = frame.time_s = static_cast<double>(frame.number) / game_.sim.frame_rate_hz;
      publisher_.on_frame(frame, game.signal(), game.world());
      publisher_.publish(tracks);
    }
  }

  // Returns false if nobody requests a later frame.
  bool wait_after_end(std::int64_t frame) {
    if (options_.speed.pace == Pace::kClock) pacer_.wait();
    if (options_.speed.pace != Pace::kLockStep) return true;
    for (const std::string& detection : publisher_.detections())
      lock_step_.add_detection(detection);
    const auto ignore = [](const league::SimulatorRequest&) {};
    return lock_step_.advance(frame, {}, slots_, ignore, CommandSlots::Clock::now() + kLastSlice);
  }

  game::GameConfiguration game_;
  LiveOptions options_;
  std::function<bool()> is_interrupted_;
  PerSide<bool> is_network_;
  CommandSlots slots_;
  ControlRequests requests_;
  RobotUpdates robot_updates_;
  LockStep lock_step_;
  GamePublisher publisher_;
  std::optional<FollowedController> controller_;  // nullopt unless it commands the game
  NetworkThread thread_;
  TeamPorts ports_;
  FrameClock* clock_;
  FramePacer pacer_;
  FramePacer waiting_pacer_;  // paces the frames that are sent while the game waits
  bool is_paused_ = false;
  double speed_ = 0;  // requested at the control port; 0: never
  PerSide<SideState> states_;
  PerSide<NetworkInput> inputs_;
  PerSide<int> silent_frames_;  // number of frames since the newest packet
  PerSide<std::array<std::int64_t, 3>> ages_;
};

LiveGame::LiveGame(const game::GameConfiguration& game, const LiveOptions& options,
                   FrameClock& clock, std::function<bool()> is_interrupted)
    : impl_(std::make_unique<Impl>(game, options, clock, std::move(is_interrupted))) {}
LiveGame::~LiveGame() = default;

std::unique_ptr<strategies::Strategy> LiveGame::make_network_team(
    const strategies::TeamContext& context) {
  return impl_->make_network_team(context);
}

game::PlayedGame LiveGame::play(game::Observers observers, game::GamePrograms& programs) {
  return impl_->play(std::move(observers), programs);
}

LiveReport LiveGame::report() const { return impl_->report(); }

}  // namespace autoref::live
