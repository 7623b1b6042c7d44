// Outputs that a program must not send, and what is said about them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "league/messages/simulation.pb.h"
#include "league/team/flat_records.hpp"
#include "league/team/team_codec.hpp"

namespace autoref::league {
namespace {

using Result = OutputDecoder::Result;

struct Hostile {
  const char* name;
  TeamEncoding encoding;
  std::string bytes;
  std::string fault;  // part of what is said
};

std::string decoded_fault(TeamEncoding encoding, const std::string& bytes) {
  const std::unique_ptr<TeamCodec> codec = make_team_codec(encoding);
  OutputDecoder decoder(*codec);
  decoder.add(bytes);
  TeamOutput output;
  EXPECT_EQ(decoder.next(output), Result::kFault);
  return decoder.fault();
}

class HostileOutput : public testing::TestWithParam<Hostile> {};

TEST_P(HostileOutput, IsRefusedInPlainWords) {
  const std::string fault = decoded_fault(GetParam().encoding, GetParam().bytes);
  EXPECT_NE(fault.find(GetParam().fault), std::string::npos) << fault;
}

const auto name_of_case = [](const auto& test) { return test.param.name; };

Hostile json(const char* name, const std::string& line, const std::string& fault) {
  return {name, TeamEncoding::kJson, line + "\n", fault};
}

INSTANTIATE_TEST_SUITE_P(
    Json, HostileOutput,
    testing::Values(
        json("Garbage", "hello", "an output line is not JSON"),
        json("Empty", "", "an output line is not JSON"),
        json("NotAnObject", "[1]", "an output line is not an object"),
        json("CutOff", R"({"frame": 1)", "an output line is not JSON"),
        json("TwoValues", R"({"frame": 1} {})", "an output line is not JSON"),
        json("NotUtf8", "{\"frame\": 1, \"text\": \"\xFF\"}", "an output line is not JSON"),
        json("NaN", R"({"frame": 1, "commands": [{"robot": 1, "vx_mps": NaN}]})",
             "an output line is not JSON"),
        json("Overflow", R"({"frame": 1, "commands": [{"robot": 1, "vx_mps": 1e999}]})",
             "number overflow"),
        json("NoFrame", R"({"keeper": 1})", "an output line does not name a frame"),
        json("NegativeFrame", R"({"frame": -1})", "frame is -1; it must not be negative"),
        json("FractionalFrame", R"({"frame": 1.5})", "frame of an output line is not an integer"),
        json("HugeFrame", R"({"frame": 18446744073709551615})",
             "frame of an output line is not an integer"),
        json("UnknownMember", R"({"frame": 1, "keper": 2})",
             "an output line has the unknown member \"keper\""),
        json("RepeatedMember", R"({"frame": 1, "frame": 2})",
             "an output line has two members \"frame\""),
        json("UnknownCommandMember", R"({"frame": 1, "commands": [{"robot": 1, "vx": 1}]})",
             "a command has the unknown member \"vx\""),
        json("RepeatedCommandMember", R"({"frame": 1, "commands": [{"chip": true, "chip": true}]})",
             "a command has two members \"chip\""),
        json("MembersOfCommands", R"({"frame": 1, "robot": 1})",
             "an output line has the unknown member \"robot\""),
        json("CommandNotAnObject", R"({"frame": 1, "commands": [1]})",
             "a command is not an object"),
        json("ArrayInCommands", R"({"frame": 1, "commands": [[]]})", "a command is not an object"),
        json("ObjectInCommand", R"({"frame": 1, "commands": [{"robot": {}}]})",
             "robot of a command is not an integer"),
        json("NoRobot", R"({"frame": 1, "commands": [{}]})", "a command does not name a robot"),
        json("NoSuchRobot", R"({"frame": 1, "commands": [{"robot": 16}]})",
             "robot is 16; it must be from 0 to 15"),
        json("SameRobotTwice", R"({"frame": 1, "commands": [{"robot": 3}, {"robot": 3}]})",
             "robot 3 has two commands"),
        json("Text", R"({"frame": 1, "commands": [{"robot": 3, "kick_mps": "hard"}]})",
             "kick_mps of a command is not a number"),
        json("Number", R"({"frame": 1, "commands": [{"robot": 3, "chip": 1}]})",
             "chip of a command is not true or false"),
        json("CommandsNotAnArray", R"({"frame": 1, "commands": {}})",
             "commands of an output line is not an array"),
        json("TooFast", R"({"frame": 1, "commands": [{"robot": 3, "vy_mps": -101}]})",
             "vy_mps of robot 3 is -101; it must be from -100 to 100"),
        json("NegativeKick", R"({"frame": 1, "commands": [{"robot": 3, "kick_mps": -1}]})",
             "kick_mps of robot 3 is -1; it must be from 0 to 100"),
        json("NoSuchKeeper", R"({"frame": 1, "keeper": -2})",
             "keeper is -2; it must be from -1 to 15"),
        json("NoSuchLeaving", R"({"frame": 1, "leaves": -1})",
             "leaves is -1; it must be from 0 to 15"),
        json("LongText", R"({"frame": 1, "text": ")" + std::string(1001, 'x') + "\"}",
             "text has 1001 bytes; the limit is 1000"),
        json("DeepNesting", "{\"frame\": " + std::string(60000, '['),
             "frame of an output line is not an integer"),
        Hostile{"Endless", TeamEncoding::kJson, std::string(kLongestOutput + 1, ' '),
                "an output line is longer than 65536 bytes"}),
    name_of_case);

// A flat output with one command, some of its bytes replaced by those of `value`.
template <typename Value>
std::string flat_with(std::size_t offset, Value value) {
  FlatOutput head{};
  head.length = sizeof(FlatOutput) + sizeof(FlatCommand);
  head.kind = FlatKind::kOutput;
  head.commands = 1;
  head.leaves = -1;
  std::string bytes(head.length, '\0');
  std::memcpy(bytes.data(), &head, sizeof head);
  std::memcpy(bytes.data() + offset, &value, sizeof value);
  return bytes;
}

template <typename Value>
Hostile flat(const char* name, std::size_t offset, Value value, const std::string& fault) {
  return {name, TeamEncoding::kFlat, flat_with(offset, value), fault};
}

constexpr std::size_t kCommand = sizeof(FlatOutput);
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

INSTANTIATE_TEST_SUITE_P(
    Flat, HostileOutput,
    testing::Values(
        Hostile{"Garbage", TeamEncoding::kFlat, "hello world", "a record has kind 8303"},
        flat("Kind", 4, std::uint16_t{2}, "a record has kind 2; outputs have kind 4"),
        flat("Short", 0, std::uint32_t{31}, "length 31; it must be from 32 to 65536"),
        flat("Long", 0, std::uint32_t{65537}, "length 65537; it must be from 32 to 65536"),
        flat("OneByteLess", 0, std::uint32_t{71}, "1 commands and 0 bytes of text it must be 72"),
        flat("ManyCommands", offsetof(FlatOutput, commands), std::uint16_t{65535},
             "with 65535 commands"),
        flat("Text", offsetof(FlatOutput, text_bytes), std::uint16_t{1}, "it must be 73"),
        flat("Reserved", offsetof(FlatOutput, reserved), std::uint32_t{1}, "reserved"),
        flat("Timeout", 6, std::uint16_t{2}, "timeout is 2; it must be 0 or 1"),
        flat("Frame", 8, std::int64_t{-5}, "frame is -5"),
        flat("Keeper", 16, std::int32_t{16}, "keeper is 16"),
        flat("Leaves", 20, std::int32_t{-2}, "leaves is -2"),
        flat("NaN", kCommand, kNotANumber, "vx_mps of robot 0 is nan; it must be finite"),
        flat("Infinity", kCommand + 8, -kInfinity, "vy_mps of robot 0 is -inf; it must be finite"),
        flat("FastTurn", kCommand + 16, 1000.5, "it must be from -1000 to 1000"),
        flat("KickNaN", kCommand + 24, -kNotANumber, "kick_mps of robot 0"),
        flat("Robot", kCommand + 32, std::int32_t{-1}, "robot is -1; it must be from 0 to 15"),
        flat("Chip", kCommand + 36, std::uint8_t{255}, "chip is 255; it must be 0 or 1"),
        flat("Dribble", kCommand + 37, std::uint8_t{2}, "dribble is 2"),
        flat("ReservedOfCommand", kCommand + 38, std::uint16_t{1}, "reserved")),
    name_of_case);

template <typename Change>
Hostile league(const char* name, const Change& change, const std::string& fault) {
  simulation::RobotControl message;
  message.add_robot_commands()->set_id(3);
  change(*message.mutable_robot_commands(0));
  const std::string content = message.SerializePartialAsString();
  return {name, TeamEncoding::kLeague, static_cast<char>(content.size()) + content, fault};
}

INSTANTIATE_TEST_SUITE_P(
    League, HostileOutput,
    testing::Values(
        Hostile{"Garbage", TeamEncoding::kLeague, "\x05hello", "5 bytes is not a RobotControl"},
        Hostile{"LongLength", TeamEncoding::kLeague, "\xFF\xFF\xFF",
                "length is not a number up to 65536"},
        Hostile{"TooLong", TeamEncoding::kLeague, "\x81\x80\x04",
                "an output has 65537 bytes; the limit is 65536"},
        league(
            "NoRobot", [](auto& m) { m.clear_id(); }, "a RobotControl lacks robot_commands[0].id"),
        league(
            "NoSuchRobot", [](auto& m) { m.set_id(16); }, "unknown robot 16; the team has 16"),
        league(
            "Wheels",
            [](auto& m) {
              auto& wheels = *m.mutable_move_command()->mutable_wheel_velocity();
              wheels.set_front_right(1);
              wheels.set_back_right(1);
              wheels.set_back_left(1);
              wheels.set_front_left(1);
            },
            "robot 3 has a wheel velocity; only local and global velocities can be driven"),
        league(
            "NaN",
            [](auto& m) {
              auto& velocity = *m.mutable_move_command()->mutable_global_velocity();
              velocity.set_x(std::numeric_limits<float>::quiet_NaN());
              velocity.set_y(0);
              velocity.set_angular(0);
            },
            "x of robot 3 is nan; it must be from -100 to 100"),
        league(
            "Kick", [](auto& m) { m.set_kick_speed(-1); }, "kick_speed of robot 3 is -1"),
        league(
            "Angle", [](auto& m) { m.set_kick_angle(-45); },
            "kick_angle of robot 3 is -45; it must be from 0 to 90 degrees"),
        league(
            "NaNAngle", [](auto& m) { m.set_kick_angle(std::numeric_limits<float>::quiet_NaN()); },
            "kick_angle of robot 3 is nan")),
    name_of_case);

TEST(OutputDecoder, ReportsAFaultForEver) {
  const std::unique_ptr<TeamCodec> codec = make_team_codec(TeamEncoding::kJson);
  OutputDecoder decoder(*codec);
  TeamOutput output;
  decoder.add("nonsense\n{\"frame\": 1}\n");
  EXPECT_EQ(decoder.next(output), Result::kFault);
  decoder.add("{\"frame\": 2}\n");
  EXPECT_EQ(decoder.next(output), Result::kFault);
  EXPECT_NE(decoder.fault(), "");
}

TEST(OutputDecoder, FindsAWrongRecordBeforeItIsComplete) {
  EXPECT_NE(decoded_fault(TeamEncoding::kFlat, "autoref"), "");
  EXPECT_NE(decoded_fault(TeamEncoding::kLeague, "\xFF\xFF\x7F"), "");
}

TEST(OutputDecoder, QuotesLittleOfALongLine) {
  const std::string bytes = "{\"" + std::string(60000, '\xFF') + "\n";
  const std::string fault = decoded_fault(TeamEncoding::kJson, bytes);
  EXPECT_LT(fault.size(), 400U);
  EXPECT_EQ(fault.find('\xFF'), std::string::npos);
}

TEST(OutputDecoder, AcceptsTheLongestText) {
  const std::unique_ptr<TeamCodec> codec = make_team_codec(TeamEncoding::kJson);
  OutputDecoder decoder(*codec);
  TeamOutput output;
  decoder.add("{\"frame\": 1, \"leaves\": null, \"text\": \"" + std::string(1000, 'x') + "\"}\n");
  ASSERT_EQ(decoder.next(output), Result::kOutput) << decoder.fault();
  EXPECT_EQ(output.text.size(), 1000U);
  EXPECT_EQ(output.requests.keeper, 0);
}

}  // namespace
}  // namespace autoref::league
