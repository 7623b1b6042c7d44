// What a live referee shows a person: the state of the game, its last calls, and vision's quality.
#pragma once

#include <deque>
#include <string>

#include "live/referee/live_referee.hpp"
#include "referee/decision.hpp"

namespace autoref::live {

// "12:34.5  ball_left_field yellow: ..." Empty for decisions that only follow somebody's commands.
std::string call_line(const referee::Decision& decision);

// "stage FIRST_HALF, STOP, yellow 1 : 0 blue".
std::string state_line(const LiveRefereeStatus& status);

// "registered; 12 events accepted, 1 rejected ...".
std::string controller_line(const ControllerStatus& controller);

// The whole view, one piece of text with line breaks, at most `columns` wide. `calls` are the last
// ones, the newest last.
std::string status_text(const LiveRefereeStatus& status, const std::deque<std::string>& calls,
                        std::size_t columns);

}  // namespace autoref::live
