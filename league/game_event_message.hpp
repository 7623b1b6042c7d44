// Conversion between game events and the league's messages.
#pragma once

#include <cstddef>
#include <vector>

#include "league/messages/game_event.pb.h"
#include "league/messages/referee.pb.h"
#include "soccer/rules/game_event.hpp"

namespace autoref::league {

// Fills `message`, including its type. Members that the type's message lacks are left out; required
// ones that are not known become 0, false or empty, and teams UNKNOWN. West is yellow.
void fill_game_event(const GameEvent& event, GameEventMessage& message);

// The event of a message. Its type is that of the part that is filled, if any. Numbers that are not
// finite or not an int, and texts beyond 1000 bytes, are left out; so are the events that caused a
// MULTIPLE_FOULS.
GameEvent game_event_of(const GameEventMessage& message);

// Datagrams longer than this are cut off by some of the league's receivers.
inline constexpr std::size_t kLongestPacket = 1024;  // bytes

// Adds the event to a referee packet; returns false, and adds nothing, if the packet would reach
// kLongestPacket.
bool add_game_event(const GameEvent& event, RefereePacket& packet);

// The events of a referee packet, at most 100. Those that cannot be parsed are left out.
std::vector<GameEvent> game_events_of(const RefereePacket& packet);

}  // namespace autoref::league
