// The referee's signal as the league sends it.
#pragma once

#include <optional>
#include <string>

#include "league/messages/referee.pb.h"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::league {

struct LoggedTeam {
  std::string name;
  int keeper = 0;  // its robot's number
};

// Fills `packet`, sent at `time_s` of the game. West is yellow and defends the goal at -x.
void fill_referee(const RefereeSignal& signal, const PerSide<LoggedTeam>& teams, double time_s,
                  RefereePacket& packet);

// The signal of a packet; its command counts as sent `since_us` after the log's first packet. None
// where command or stage are none that the league's referee of 2013 sends.
std::optional<RefereeSignal> signal_of(const RefereePacket& packet);

// The command of that number; none where there is none.
std::optional<Command> command_of(int league_number);

}  // namespace autoref::league
