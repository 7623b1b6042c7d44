// Conversion between the referee's signal and the league's message.
#pragma once

#include <optional>
#include <string>

#include "league/messages/referee.pb.h"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::league {

struct LoggedTeam {
  std::string name;
  int keeper = 0;  // the keeper's robot number, unless the signal names another one
};

// Fills `packet`, sent at game time `time_s`. West is yellow; positions are as published
// (soccer/referee_signal.hpp).
void fill_referee(const RefereeSignal& signal, const PerSide<LoggedTeam>& teams, double time_s,
                  RefereePacket& packet);

// The signal in a packet; nullopt if its command or stage is not one of the league's (the numbers
// of 2013 are still in use). If the packet lacks the number of robots allowed, as packets before
// 2018 do, it is kMaxRobots. A keeper whose number is outside the league's range counts as not
// named, and a position that is not finite counts as not given. If the packet does not say which
// end is blue's, blue is assumed to be on the positive half.
std::optional<RefereeSignal> signal_of(const RefereePacket& packet);

// The time in seconds from the packet's command to the packet itself, both on the sender's clock;
// nullopt if it is negative or longer than a day.
std::optional<double> command_age_s(const RefereePacket& packet);

// The command with that number; nullopt if there is none.
std::optional<Command> command_of(int league_number);

}  // namespace autoref::league
