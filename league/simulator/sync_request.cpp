#include "league/simulator/sync_request.hpp"

#include <fmt/format.h>

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>

#include "league/message_fields.hpp"
#include "league/messages/simulation.pb.h"
#include "league/simulator/command_update.hpp"
#include "league/simulator/robot_control.hpp"

namespace autoref::league {
namespace {

using google::protobuf::internal::WireFormatLite;

constexpr double kLongestStep_s = 10;
constexpr int kMostFields = 64;  // number of fields examined

}  // namespace

bool is_sync_request(std::string_view bytes) {
  const std::uint32_t step = WireFormatLite::MakeTag(1, WireFormatLite::WIRETYPE_FIXED32);
  const std::uint32_t robots =
      WireFormatLite::MakeTag(3, WireFormatLite::WIRETYPE_LENGTH_DELIMITED);
  google::protobuf::io::CodedInputStream input(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                               static_cast<int>(bytes.size()));
  for (int i = 0; i < kMostFields; ++i) {
    const std::uint32_t tag = input.ReadTag();
    if (tag == step || tag == robots) return true;
    if (tag == 0 || !WireFormatLite::SkipField(&input, tag)) return false;
  }
  return false;
}

SyncRequest read_sync_request(std::string_view bytes, std::optional<Side> side,
                              const PerSide<int>& robots) {
  SyncRequest request;
  simulation::SimulationSyncRequest message;
  if (!parse(bytes, message)) {
    add_error(request.commands.errors, kNotAMessage,
              fmt::format("a packet of {} bytes is not a SimulationSyncRequest", bytes.size()));
    return request;
  }
  request.is_readable = true;
  request.control = request_of(message.simulator_command(), robots);
  if (side) {
    request.commands = updates_of(message.robot_control(), robots[*side]);
  } else if (message.has_robot_control()) {
    add_error(request.commands.errors, kNotAMessage,
              "robot commands must be sent to their team's port");
  }
  for (const PacketError& error : request.control.errors)
    add_error(request.commands.errors, error.code, error.message);
  const double step_s = static_cast<double>(message.sim_step());
  if (step_s >= 0 && step_s <= kLongestStep_s) {
    request.step_s = step_s;
  } else {
    add_error(request.commands.errors, "STEP",
              fmt::format("sim_step is {} s; it must be from 0 to {} s", step_s, kLongestStep_s));
  }
  return request;
}

std::string sync_response(const std::vector<std::string>& detections, const CommandPacket& commands,
                          const std::bitset<kMaxRobots>& dribbler_contact) {
  simulation::SimulationSyncResponse response;
  for (const std::string& detection : detections) *response.add_detection() = detection;
  fill_response(commands, dribbler_contact, *response.mutable_robot_control_response());
  return response.SerializeAsString();
}

}  // namespace autoref::league
