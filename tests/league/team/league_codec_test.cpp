// The encoding of the league's own messages.
#include <gtest/gtest.h>

#include "league/field_message.hpp"
#include "league/messages/league_input.pb.h"
#include "league/messages/referee.pb.h"
#include "league/messages/simulation.pb.h"
#include "league/messages/vision.pb.h"
#include "league/team/team_codec.hpp"

namespace autoref::league {
namespace {

using Result = OutputDecoder::Result;

template <typename Message>
Message parsed_league(const std::string& bytes) {
  Message message;
  EXPECT_TRUE(message.ParseFromString(bytes));
  return message;
}

class LeagueEncoding : public testing::Test {
 protected:
  template <typename Message>
  team::LeagueInput sent(const Message& message) {
    std::string bytes;
    codec->append(message, bytes);
    const std::size_t length_bytes = static_cast<unsigned char>(bytes[0]) < 0x80 ? 1 : 2;
    return parsed_league<team::LeagueInput>(bytes.substr(length_bytes));
  }

  team::LeagueInput start(Side side) {
    TeamStart start;
    start.side = side;
    start.field.length_m = 12;
    start.robots.resize(2);
    return sent(start);
  }

  // The last packet's detection; those before it have the geometry.
  DetectionFrame detected(const TeamFrame& frame) {
    const team::LeagueInput input = sent(frame);
    return parsed_league<VisionPacket>(input.vision(input.vision_size() - 1)).detection();
  }

  Result read(const simulation::RobotControl& control) {
    std::string bytes = control.SerializeAsString();
    bytes.insert(0, 1, static_cast<char>(bytes.size()));
    decoder.add(bytes);
    return decoder.next(output);
  }

  std::unique_ptr<TeamCodec> codec = make_team_codec(TeamEncoding::kLeague);
  OutputDecoder decoder{*codec};
  TeamOutput output;
};

// The team's robot 1 at (-1, 0.5) and the opponents' robot 2 at (2, 0), as the team sees them.
TeamFrame tracked_frame() {
  TeamFrame frame;
  frame.view.frame = 60;
  frame.view.time_s = 1;
  frame.view.own = {{1, {-1, 0.5}, {0, 1}}};
  frame.view.opponents = {{2, {2, 0}, {-1, 0}}};
  frame.view.ball.position_m = {0.25, -0.5};
  frame.view.goals_own = 3;
  frame.view.placement_m = Vec2(1, 2);
  return frame;
}

TEST_F(LeagueEncoding, StartsWithColourGeometryAndAHaltedReferee) {
  const team::LeagueInput input = start(Side::kEast);
  EXPECT_TRUE(input.has_is_yellow());
  EXPECT_FALSE(input.is_yellow());
  EXPECT_FALSE(input.has_frame());
  ASSERT_EQ(input.vision_size(), 1);
  const auto packet = parsed_league<VisionPacket>(input.vision(0));
  EXPECT_EQ(packet.geometry().field().field_length(), 12000);
  EXPECT_EQ(packet.geometry().calib_size(), 1);
  EXPECT_EQ(parsed_league<RefereePacket>(input.referee()).command(), 0);
}

TEST_F(LeagueEncoding, ShowsYellowTheFieldAsItIs) {
  start(Side::kWest);
  const DetectionFrame seen = detected(tracked_frame());
  EXPECT_EQ(seen.frame_number(), 60U);
  EXPECT_EQ(seen.t_capture(), 1);
  EXPECT_EQ(seen.robots_yellow(0).robot_id(), 1U);
  EXPECT_FLOAT_EQ(seen.robots_yellow(0).x(), -1000);
  EXPECT_FLOAT_EQ(seen.robots_blue(0).x(), 2000);
  EXPECT_FLOAT_EQ(seen.balls(0).x(), 250);
}

TEST_F(LeagueEncoding, RotatesBluesViewBackIntoTheField) {
  start(Side::kEast);
  const DetectionFrame seen = detected(tracked_frame());
  EXPECT_EQ(seen.robots_blue(0).robot_id(), 1U);
  EXPECT_FLOAT_EQ(seen.robots_blue(0).x(), 1000);
  EXPECT_FLOAT_EQ(seen.robots_blue(0).y(), -500);
  EXPECT_NEAR(seen.robots_blue(0).orientation(), -1.5708, 1e-4);
  EXPECT_FLOAT_EQ(seen.robots_yellow(0).x(), -2000);
  EXPECT_FLOAT_EQ(seen.balls(0).y(), 500);
}

TEST_F(LeagueEncoding, RotatesThePlacementAndNamesScoresByColour) {
  start(Side::kEast);
  const auto referee = parsed_league<RefereePacket>(sent(tracked_frame()).referee());
  EXPECT_FLOAT_EQ(referee.designated_position().x(), -1000);
  EXPECT_FLOAT_EQ(referee.designated_position().y(), -2000);
  EXPECT_EQ(referee.blue().score(), 3U);
  EXPECT_EQ(referee.yellow().score(), 0U);
  EXPECT_TRUE(referee.blue_team_on_positive_half());
  EXPECT_EQ(referee.packet_timestamp(), 1000000U);
}

TEST_F(LeagueEncoding, PrefersDetectionsToTrackedMotion) {
  start(Side::kEast);
  TeamFrame frame = tracked_frame();
  frame.detections.emplace().robots[Side::kWest].push_back({5, {-2, 0}, {1, 0}});
  const DetectionFrame seen = detected(frame);
  EXPECT_EQ(seen.robots_yellow_size(), 0);
  EXPECT_EQ(seen.robots_blue(0).robot_id(), 5U);
  EXPECT_EQ(seen.balls_size(), 0);
}

TEST_F(LeagueEncoding, NumbersTheCamerasThatSeeTheBall) {
  start(Side::kEast);
  TeamFrame frame = tracked_frame();
  for (const double x : {1.0, -2.0}) {
    frame.detections.emplace().ball = BallObservation{{x, 0}, std::nullopt, {{x, 0}, 5}};
    sent(frame);
  }
  frame.view.time_s = 2;
  const team::LeagueInput input = sent(frame);
  ASSERT_EQ(input.vision_size(), 3);
  const Geometry geometry = parsed_league<VisionPacket>(input.vision(0)).geometry();
  ASSERT_EQ(geometry.calib_size(), 2);
  EXPECT_FLOAT_EQ(geometry.calib(0).derived_camera_world_tx(), -1000);
  EXPECT_FLOAT_EQ(geometry.calib(1).derived_camera_world_tx(), 2000);
  EXPECT_EQ(parsed_league<VisionPacket>(input.vision(1)).detection().balls_size(), 0);
  EXPECT_EQ(parsed_league<VisionPacket>(input.vision(2)).detection().balls_size(), 1);
}

TEST_F(LeagueEncoding, RepeatsTheGeometryOncePerSecond) {
  start(Side::kWest);
  TeamFrame frame = tracked_frame();
  int geometries = 0;
  for (int i = 0; i <= 180; ++i) {
    frame.view.time_s = i / 60.0;
    geometries += sent(frame).vision_size() - 1;
  }
  EXPECT_EQ(geometries, 4);
}

TEST_F(LeagueEncoding, ReportsTheBallInTheDribblerZone) {
  start(Side::kWest);
  TeamFrame frame = tracked_frame();
  frame.ball_in_dribbler_zone.set(1);
  const auto feedback = parsed_league<simulation::RobotControlResponse>(sent(frame).feedback());
  ASSERT_EQ(feedback.feedback_size(), 2);
  EXPECT_FALSE(feedback.feedback(0).dribbler_ball_contact());
  EXPECT_EQ(feedback.feedback(1).id(), 1U);
  EXPECT_TRUE(feedback.feedback(1).dribbler_ball_contact());
}

TEST_F(LeagueEncoding, SaysWhyTheGameEnded) {
  EXPECT_EQ(sent(TeamEnd{"time", 1, 2}).end(), "time");
}

simulation::RobotCommand& add_local(float forward, simulation::RobotControl& control) {
  simulation::RobotCommand& command = *control.add_robot_commands();
  command.set_id(1);
  simulation::MoveLocalVelocity& velocity =
      *command.mutable_move_command()->mutable_local_velocity();
  velocity.set_forward(forward);
  velocity.set_left(-0.5F);
  velocity.set_angular(2);
  return command;
}

TEST_F(LeagueEncoding, TakesLocalVelocitiesKicksAndTheDribbler) {
  start(Side::kWest);
  sent(tracked_frame());
  simulation::RobotControl control;
  simulation::RobotCommand& command = add_local(1.5F, control);
  command.set_kick_speed(6.5F);
  command.set_dribbler_speed(1000);
  ASSERT_EQ(read(control), Result::kOutput) << decoder.fault();
  EXPECT_EQ(output.frame, 60);
  EXPECT_EQ(output.commands[1].velocity_mps, Vec2(1.5, -0.5));
  EXPECT_EQ(output.commands[1].angular_velocity_radps, 2);
  EXPECT_EQ(output.commands[1].kick_mps, 6.5);
  EXPECT_FALSE(output.commands[1].chip);
  EXPECT_TRUE(output.commands[1].dribble);
  EXPECT_EQ(output.commands[0].velocity_mps, Vec2(0, 0));
}

TEST_F(LeagueEncoding, ChipsKicksAtAnAngle) {
  simulation::RobotControl control;
  add_local(0, control).set_kick_angle(45);
  ASSERT_EQ(read(control), Result::kOutput) << decoder.fault();
  EXPECT_TRUE(output.commands[1].chip);
}

// Blue's robot 1 faces +y in its own coordinates, thus -y on the field.
TEST_F(LeagueEncoding, RotatesGlobalVelocitiesByTheDetectedHeading) {
  start(Side::kEast);
  sent(tracked_frame());
  simulation::RobotControl control;
  simulation::RobotCommand& command = *control.add_robot_commands();
  command.set_id(1);
  auto& velocity = *command.mutable_move_command()->mutable_global_velocity();
  velocity.set_x(1);
  velocity.set_y(-2);
  velocity.set_angular(3);
  ASSERT_EQ(read(control), Result::kOutput) << decoder.fault();
  EXPECT_NEAR(output.commands[1].velocity_mps.x(), 2, 1e-9);
  EXPECT_NEAR(output.commands[1].velocity_mps.y(), 1, 1e-9);
  EXPECT_EQ(output.commands[1].angular_velocity_radps, 3);
}

TEST_F(LeagueEncoding, TakesAnEmptyControlAsStandingStill) {
  ASSERT_EQ(read({}), Result::kOutput) << decoder.fault();
  EXPECT_EQ(decoder.bytes_left(), 0U);
  EXPECT_EQ(output.requests.keeper, 0);
}

}  // namespace
}  // namespace autoref::league
