#include <fmt/format.h>

#include <array>

#include "league/messages/league_input.pb.h"
#include "league/messages/referee.pb.h"
#include "league/referee_message.hpp"
#include "league/simulator/robot_control.hpp"
#include "league/team/codecs.hpp"
#include "league/team/delimited.hpp"
#include "league/team/league_signal.hpp"
#include "league/team/league_vision.hpp"
#include "league/team/output_builder.hpp"
#include "league/team/team_fault.hpp"

namespace autoref::league {
namespace {

// Headings of a team's robots in the frame of vision, by number.
using Headings = std::array<Vec2, kMaxRobots>;

// Global velocities are rotated into the robots' frames by `headings`.
void add_commands(const simulation::RobotControl& control, const Headings& headings,
                  OutputBuilder& builder) {
  const CommandPacket packet = updates_of(control, kMaxRobots);
  if (!packet.errors.empty()) throw TeamFault(packet.errors.front().message);
  for (const CommandUpdate& update : packet.updates) {
    if (update.motion && std::holds_alternative<WheelSpeeds>(*update.motion)) {
      throw TeamFault(fmt::format(
          "robot {} has a wheel velocity; only local and global velocities can be driven",
          update.robot));
    }
    const Vec2& heading = headings.at(static_cast<std::size_t>(update.robot));
    builder.add_command(update.robot, command_of(update, heading, {}));
  }
}

// Remembers what the messages need of earlier ones: the colour and robots of START, the referee's
// commands, and of the latest frame its number and the robots' headings.
class LeagueCodec final : public TeamCodec {
 public:
  LeagueCodec() { headings_.fill(Vec2(1, 0)); }

  void append(const TeamStart& start, std::string& bytes) override {
    side_ = start.side;
    robots_ = start.robots.size();
    signal_ = LeagueSignal(side_, static_cast<int>(robots_));
    vision_ = LeagueVision(start.field);
    input_.Clear();
    input_.set_is_yellow(side_ == Side::kWest);
    input_.add_vision(vision_.geometry());
    set_referee(0);
    append_delimited(input_, bytes);
  }

  void append(const TeamFrame& frame, std::string& bytes) override {
    const Frame seen = field_frame_of(frame, side_);
    for (const RobotObservation& robot : seen.robots[side_])
      headings_.at(static_cast<std::size_t>(robot.number)) = robot.heading;
    frame_ = frame.view.frame;
    signal_.update(frame.view);
    input_.Clear();
    input_.set_frame(frame_);
    for (const std::string& packet : vision_.packets_of(seen)) input_.add_vision(packet);
    set_referee(frame.view.time_s);
    set_feedback(frame.ball_in_dribbler_zone);
    append_delimited(input_, bytes);
  }

  void append(const TeamEnd& end, std::string& bytes) override {
    input_.Clear();
    input_.set_end(end.reason.substr(0, kLongestName));
    append_delimited(input_, bytes);
  }

  std::optional<MessageExtent> find_message(std::string_view bytes) const override {
    return find_delimited(bytes);
  }

  void read(std::string_view content, TeamOutput& output) override {
    if (!control_.ParsePartialFromArray(content.data(), static_cast<int>(content.size())))
      throw TeamFault(fmt::format("an output of {} bytes is not a RobotControl", content.size()));
    if (!control_.IsInitialized())
      throw TeamFault("a RobotControl lacks " + control_.InitializationErrorString());
    OutputBuilder builder(output);
    builder.set_frame(frame_);
    add_commands(control_, headings_, builder);
  }

 private:
  void set_referee(double time_s) {
    static const PerSide<LoggedTeam> kTeams{{LoggedTeam{"yellow"}, LoggedTeam{"blue"}}};
    fill_referee(signal_.signal(), kTeams, time_s, referee_);
    referee_.SerializeToString(input_.mutable_referee());
  }

  void set_feedback(const std::bitset<kMaxRobots>& ball_in_dribbler_zone) {
    feedback_.Clear();
    for (std::size_t number = 0; number < robots_; ++number) {
      simulation::RobotFeedback& robot = *feedback_.add_feedback();
      robot.set_id(static_cast<std::uint32_t>(number));
      robot.set_dribbler_ball_contact(ball_in_dribbler_zone[number]);
    }
    feedback_.SerializeToString(input_.mutable_feedback());
  }

  Side side_ = Side::kWest;
  std::size_t robots_ = 0;
  std::int64_t frame_ = 0;
  Headings headings_;
  LeagueSignal signal_{side_, 0};
  LeagueVision vision_{Field{}};
  team::LeagueInput input_;
  RefereePacket referee_;
  simulation::RobotControlResponse feedback_;
  simulation::RobotControl control_;
};

}  // namespace

std::unique_ptr<TeamCodec> make_league_codec() { return std::make_unique<LeagueCodec>(); }

}  // namespace autoref::league
