#include "league/team/flat_output.hpp"

#include <fmt/format.h>

#include <cstring>

#include "league/team/flat_records.hpp"
#include "league/team/output_builder.hpp"
#include "league/team/team_fault.hpp"

namespace autoref::league {
namespace {

template <typename Record>
Record record_at(std::string_view bytes, std::size_t offset) {
  Record record;
  std::memcpy(&record, bytes.data() + offset, sizeof record);
  return record;
}

bool yes_or_no(unsigned value, std::string_view name) {
  if (value > 1) throw TeamFault(fmt::format("{} is {}; it must be 0 or 1", name, value));
  return value == 1;
}

void check_reserved(std::uint32_t value) {
  if (value != 0) throw TeamFault("a reserved number is not 0");
}

void add_flat_command(const FlatCommand& record, OutputBuilder& output) {
  check_reserved(record.reserved);
  RobotCommand command;
  command.velocity_mps = {record.vx_mps, record.vy_mps};
  command.angular_velocity_radps = record.angular_velocity_radps;
  command.kick_mps = record.kick_mps;
  command.chip = yes_or_no(record.chip, "chip");
  command.dribble = yes_or_no(record.dribble, "dribble");
  output.add_command(record.robot, command);
}

}  // namespace

std::optional<MessageExtent> find_flat_output(std::string_view bytes) {
  constexpr std::size_t kHead = 6;  // length and kind
  if (bytes.size() < kHead) return std::nullopt;
  const auto length = record_at<std::uint32_t>(bytes, 0);
  const auto kind = record_at<std::uint16_t>(bytes, 4);
  if (kind != static_cast<std::uint16_t>(FlatKind::kOutput))
    throw TeamFault(fmt::format("a record has the kind {}; an output's is 4", kind));
  if (length < sizeof(FlatOutput) || length > kLongestOutput) {
    throw TeamFault(fmt::format("an output record has the length {}; it must be from {} to {}",
                                length, sizeof(FlatOutput), kLongestOutput));
  }
  if (bytes.size() < length) return std::nullopt;
  return MessageExtent{0, length, length};
}

void read_flat_output(std::string_view content, TeamOutput& output) {
  const auto record = record_at<FlatOutput>(content, 0);
  const std::size_t commands_size = record.commands * sizeof(FlatCommand);
  if (content.size() != sizeof record + commands_size + record.text_bytes) {
    throw TeamFault(fmt::format(
        "an output record has the length {}; with {} commands and {} bytes of text it must be {}",
        content.size(), record.commands, record.text_bytes,
        sizeof record + commands_size + record.text_bytes));
  }
  check_reserved(record.reserved);
  OutputBuilder builder(output);
  builder.set_frame(record.frame);
  builder.set_keeper(record.keeper);
  if (record.leaves != -1) builder.set_leaves(record.leaves);
  builder.set_timeout(yes_or_no(record.timeout, "timeout"));
  for (std::size_t i = 0; i < record.commands; ++i) {
    const std::size_t offset = sizeof record + i * sizeof(FlatCommand);
    add_flat_command(record_at<FlatCommand>(content, offset), builder);
  }
  builder.set_text(content.substr(sizeof record + commands_size));
}

}  // namespace autoref::league
