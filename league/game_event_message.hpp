// Conversion between game events and the league's messages.
#pragma once

#include <cstddef>
#include <vector>

#include "league/messages/game_event.pb.h"
#include "league/messages/referee.pb.h"
#include "soccer/rules/game_event.hpp"

namespace autoref::league {

// Fills `message`, including its type. Members that do not exist in the type's message are left
// out. Required members that are unknown become 0, false or empty, and unknown teams become
// UNKNOWN. West is yellow.
void fill_game_event(const GameEvent& event, GameEventMessage& message);

// The event in a message. If one of the message's parts is filled, the event has the type of that
// part. Values that are not finite or do not fit an int, and texts longer than 1000 bytes, are left
// out. So are the events that caused a MULTIPLE_FOULS.
GameEvent game_event_of(const GameEventMessage& message);

// The longest referee packet. Some of the league's receivers truncate longer datagrams.
inline constexpr std::size_t kLongestPacket = 1024;  // bytes

// Adds the event to a referee packet; returns false, and adds nothing, if the packet would reach
// kLongestPacket.
bool add_game_event(const GameEvent& event, RefereePacket& packet);

// The events in a referee packet, at most 100. Events that cannot be parsed are left out.
std::vector<GameEvent> game_events_of(const RefereePacket& packet);

}  // namespace autoref::league
