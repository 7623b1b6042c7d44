#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "league/camera_clocks.hpp"
#include "league/field_message.hpp"
#include "league/messages/league_input.pb.h"
#include "league/messages/referee.pb.h"
#include "league/messages/vision.pb.h"
#include "league/referee_message.hpp"
#include "league/simulator/robot_control.hpp"
#include "league/team/delimited.hpp"
#include "league/team/league_signal.hpp"
#include "league/team/output_builder.hpp"
#include "league/team/team_codec.hpp"
#include "league/team/team_fault.hpp"
#include "league/team/team_messages.hpp"
#include "league/vision_message.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"

namespace autoref::league {
namespace {

// Serializes frames as the packets of their cameras. A camera gets a number once it has seen a ball
// whose height vision does not know. Until a camera has seen such a ball, there is a single camera
// above the field's centre.
class LeagueVision {
 public:
  explicit LeagueVision(const Field& field);

  // An SSL_WrapperPacket with the geometry.
  const std::string& geometry() const { return geometry_; }

  // One packet per camera, after the geometry if that is due: once per second, and when there are
  // new cameras. The packets are valid until the next call.
  const std::vector<std::string>& packets_of(const Frame& frame);

 private:
  void note_camera(const Frame& frame);
  void write_geometry();

  Field field_;
  std::vector<CameraPosition> cameras_{CameraPosition{}};
  bool has_seen_a_camera_ = false;
  std::vector<VisionPacket> messages_;
  std::vector<std::string> packets_;
  std::string geometry_;
  double geometry_due_s_ = 0;
};

constexpr double kGeometryOfTeamsEvery_s = 1.0;

Frame seen_by_a_perfect_camera(const TeamView& view) {
  Frame frame;
  const auto add = [&frame](const TrackedRobots& robots, Side side) {
    for (const TrackedRobot& robot : robots)
      frame.robots[side].push_back({robot.number, robot.position_m, robot.heading});
  };
  add(view.own, Side::kWest);
  add(view.opponents, Side::kEast);
  frame.ball.emplace();
  frame.ball->position_m = view.ball.position_m;
  frame.ball->height_m = view.ball.is_height_known ? view.ball.height_m : 0;
  return frame;
}

// The detections in a team's frame, in field coordinates. If the frame has none, they are those of
// a perfect camera: the tracked positions, and the ball's height if it is known.
Frame field_frame_of(const TeamFrame& frame, Side side) {
  Frame seen = frame.detections ? *frame.detections : seen_by_a_perfect_camera(frame.view);
  seen.number = frame.view.frame;
  seen.time_s = frame.view.time_s;
  return side == Side::kWest ? seen : mirrored(seen);
}

LeagueVision::LeagueVision(const Field& field) : field_(field) { write_geometry(); }

void LeagueVision::write_geometry() {
  VisionPacket packet;
  fill_geometry(field_, cameras_, *packet.mutable_geometry());
  packet.set_source(kOtherSource);
  packet.SerializeToString(&geometry_);
}

void LeagueVision::note_camera(const Frame& frame) {
  if (!frame.ball || frame.ball->height_m) return;
  const CameraPosition& camera = frame.ball->seen_from;
  const auto is_camera = [&camera](const CameraPosition& other) {
    return other.position_m == camera.position_m && other.height_m == camera.height_m;
  };
  const bool is_known = std::any_of(cameras_.begin(), cameras_.end(), is_camera);
  if (has_seen_a_camera_ && (is_known || cameras_.size() == CameraClocks::kMaxCameras)) return;
  if (!has_seen_a_camera_) cameras_.clear();
  has_seen_a_camera_ = true;
  cameras_.push_back(camera);
  write_geometry();
  geometry_due_s_ = frame.time_s;
}

const std::vector<std::string>& LeagueVision::packets_of(const Frame& frame) {
  note_camera(frame);
  const bool is_due = frame.time_s >= geometry_due_s_;
  messages_.resize(cameras_.size());
  fill_detections(frame, cameras_, messages_);
  packets_.resize(cameras_.size() + (is_due ? 1 : 0));
  if (is_due) packets_.front() = geometry_;
  for (std::size_t i = 0; i < messages_.size(); ++i)
    messages_[i].SerializeToString(&packets_[i + (is_due ? 1 : 0)]);
  if (is_due) geometry_due_s_ = frame.time_s + kGeometryOfTeamsEvery_s;
  return packets_;
}

// Headings of a team's robots in the frame of vision, by number.
using Headings = std::array<Vec2, kMaxRobots>;

// `headings` are used to rotate global velocities into the robots' frames.
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

// Stores what messages need from earlier messages: the colour and the robots from START, the
// referee's commands, and the number of the latest frame with the robots' headings in it.
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
