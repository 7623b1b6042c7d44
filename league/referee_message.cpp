#include "league/referee_message.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "league/message_fields.hpp"

namespace autoref::league {
namespace {

constexpr int kLastStage = static_cast<int>(Stage::kPostGame);
constexpr double kLongestCommand_s = 86400;

// The field holds up to 71 minutes.
std::uint32_t duration_us(double time_s) {
  return static_cast<std::uint32_t>(
      std::clamp(time_s * 1e6, 0.0, double{std::numeric_limits<std::uint32_t>::max()}));
}

void fill_team(const RefereeSignal& signal, const LoggedTeam& team_info, Side side,
               TeamInfo& team) {
  team.set_name(team_info.name);
  team.set_score(static_cast<std::uint32_t>(signal.goals[side]));
  team.set_red_cards(static_cast<std::uint32_t>(signal.red_cards[side]));
  team.set_yellow_cards(static_cast<std::uint32_t>(signal.yellow_cards[side]));
  team.clear_yellow_card_times();
  for (const double left_s : signal.yellow_left_s[side])
    team.add_yellow_card_times(duration_us(left_s));
  team.set_foul_counter(static_cast<std::uint32_t>(signal.fouls[side]));
  team.set_timeouts(static_cast<std::uint32_t>(signal.timeouts_left[side]));
  team.set_timeout_time(duration_us(signal.timeout_left_s[side]));
  const int keeper = signal.keepers[side].value_or(team_info.keeper);
  team.set_goalkeeper(static_cast<std::uint32_t>(keeper));
  team.set_can_place_ball(signal.can_place_ball[side]);
  team.set_max_allowed_bots(static_cast<std::uint32_t>(signal.robots_allowed[side]));
}

int bounded(std::uint32_t count) { return static_cast<int>(std::min(count, 9999U)); }

template <typename Times>
void read_card_times(const TeamInfo& team, Times& left_s) {
  for (const std::uint32_t left_us : team.yellow_card_times()) {
    if (left_us > 0 && left_s.size() < left_s.capacity()) left_s.push_back(left_us / 1e6);
  }
  std::sort(left_s.begin(), left_s.end());
}

void read_team(const TeamInfo& team, Side side, RefereeSignal& signal) {
  signal.goals[side] = bounded(team.score());
  signal.red_cards[side] = bounded(team.red_cards());
  signal.yellow_cards[side] = bounded(team.yellow_cards());
  read_card_times(team, signal.yellow_left_s[side]);
  signal.fouls[side] = bounded(team.foul_counter());
  signal.timeouts_left[side] = bounded(team.timeouts());
  signal.timeout_left_s[side] = team.timeout_time() / 1e6;
  if (team.goalkeeper() < kMaxRobots) signal.keepers[side] = static_cast<int>(team.goalkeeper());
  if (team.has_can_place_ball()) signal.can_place_ball[side] = team.can_place_ball();
  if (team.has_max_allowed_bots()) signal.robots_allowed[side] = bounded(team.max_allowed_bots());
}

}  // namespace

void fill_referee(const RefereeSignal& signal, const PerSide<LoggedTeam>& teams, double time_s,
                  RefereePacket& packet) {
  packet.Clear();
  packet.set_packet_timestamp(static_cast<std::uint64_t>(to_us(time_s)));
  packet.set_stage(static_cast<int>(signal.stage));
  packet.set_stage_time_left(to_us(signal.stage_time_left_s));
  packet.set_command(league_number(signal.command));
  packet.set_command_counter(signal.command_counter);
  packet.set_command_timestamp(static_cast<std::uint64_t>(to_us(signal.command_time_s)));
  fill_team(signal, teams[Side::kWest], Side::kWest, *packet.mutable_yellow());
  fill_team(signal, teams[Side::kEast], Side::kEast, *packet.mutable_blue());
  packet.set_blue_team_on_positive_half(signal.blue_on_positive_half);
  if (signal.placement) {
    packet.mutable_designated_position()->set_x(to_mm(signal.placement->target_m.x()));
    packet.mutable_designated_position()->set_y(to_mm(signal.placement->target_m.y()));
  }
  if (signal.next_command) packet.set_next_command(league_number(*signal.next_command));
}

std::optional<double> command_age_s(const RefereePacket& packet) {
  // The difference is computed in double, since with malicious times an integer may overflow.
  const double age_s = (static_cast<double>(packet.packet_timestamp()) -
                        static_cast<double>(packet.command_timestamp())) /
                       1e6;
  return age_s >= 0 && age_s <= kLongestCommand_s ? std::optional(age_s) : std::nullopt;
}

// The inverse of league_number.
std::optional<Command> command_of(int number) {
  const int first_pair = static_cast<int>(CommandKind::kPrepareKickoff);
  const int kinds = static_cast<int>(CommandKind::kBallPlacement) + 1;
  if (number < 0 || number >= first_pair + 2 * (kinds - first_pair)) return std::nullopt;
  if (number < first_pair) return Command{static_cast<CommandKind>(number), Side::kWest};
  const int kind = first_pair + (number - first_pair) / 2;
  const bool is_blue = (number - first_pair) % 2 == 1;
  return Command{static_cast<CommandKind>(kind), is_blue ? Side::kEast : Side::kWest};
}

std::optional<RefereeSignal> signal_of(const RefereePacket& packet) {
  const std::optional<Command> command = command_of(packet.command());
  if (!command || packet.stage() < 0 || packet.stage() > kLastStage) return std::nullopt;
  RefereeSignal signal;
  signal.command = *command;
  signal.command_counter = packet.command_counter();
  signal.command_time_s = static_cast<double>(packet.command_timestamp()) / 1e6;
  signal.stage = static_cast<Stage>(packet.stage());
  signal.stage_time_left_s = static_cast<double>(packet.stage_time_left()) / 1e6;
  read_team(packet.yellow(), Side::kWest, signal);
  read_team(packet.blue(), Side::kEast, signal);
  if (packet.has_designated_position()) {
    const DesignatedPosition& position = packet.designated_position();
    const Vec2 target_m(to_m(position.x()), to_m(position.y()));
    if (target_m.allFinite()) signal.placement = Placement{target_m};
  }
  if (packet.has_blue_team_on_positive_half())
    signal.blue_on_positive_half = packet.blue_team_on_positive_half();
  if (packet.has_next_command()) signal.next_command = command_of(packet.next_command());
  return signal;
}

}  // namespace autoref::league
