// The actions of the machine's transitions (referee/machine/machine.hpp): the assignments below the
// line in the paper's figure 3.
#pragma once

#include <string_view>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// An action and its wording in the figure. An action changes only the referee state.
struct Action {
  std::string_view text;
  void (*take)(RefereeState& state, const RefereeInput& input, const Finding& finding);
};

// Helpers shared by several actions. send() sends a command.
void send(RefereeState& state, const RefereeInput& input, const Command& command);
// "When entering the WAIT_STOP state, AutoRef saves the current positions" (paper, section 4.4).
void wait_anew(RefereeState& state, const RefereeInput& input);
void place_ball(RefereeState& state, const Vec2& target_m);
void end_play(RefereeState& state);
// The side that takes the restart started by `command`; nullopt for a force start.
std::optional<Side> kicker_of(const RefereeState& state, const Command& command);
// During a penalty kick, records that the side at fault, or both sides, committed a foul.
void note_foul_at_kick(RefereeState& state, const Finding& finding);

void begin(RefereeState& state, const RefereeInput& input, const Finding& finding);
void prepare_first_kickoff(RefereeState& state, const RefereeInput& input, const Finding& finding);
void send_preparation(RefereeState& state, const RefereeInput& input, const Finding& finding);
void start_play(RefereeState& state, const RefereeInput& input, const Finding& finding);
void award_goal(RefereeState& state, const RefereeInput& input, const Finding& finding);
void stop_play(RefereeState& state, const RefereeInput& input, const Finding& finding);
void allow_more_time(RefereeState& state, const RefereeInput& input, const Finding& finding);
void set_restart_in_stop(RefereeState& state, const RefereeInput& input, const Finding& finding);
void halt_for_foul(RefereeState& state, const RefereeInput& input, const Finding& finding);
void show_card(RefereeState& state, const RefereeInput& input, const Finding& finding);
void end_card(RefereeState& state, const RefereeInput& input, const Finding& finding);
void note_foul(RefereeState& state, const RefereeInput& input, const Finding& finding);
void note_foul_in_penalty(RefereeState& state, const RefereeInput& input, const Finding& finding);
void stop_after_signal(RefereeState& state, const RefereeInput& input, const Finding& finding);
void end_half(RefereeState& state, const RefereeInput& input, const Finding& finding);
void begin_next_half(RefereeState& state, const RefereeInput& input, const Finding& finding);
void begin_timeout(RefereeState& state, const RefereeInput& input, const Finding& finding);
void end_timeout(RefereeState& state, const RefereeInput& input, const Finding& finding);
void begin_extra_time(RefereeState& state, const RefereeInput& input, const Finding& finding);
void end_for_shootout(RefereeState& state, const RefereeInput& input, const Finding& finding);
void begin_shootout(RefereeState& state, const RefereeInput& input, const Finding& finding);
void count_shootout_goal(RefereeState& state, const RefereeInput& input, const Finding& finding);
void count_shootout_miss(RefereeState& state, const RefereeInput& input, const Finding& finding);
void end_game(RefereeState& state, const RefereeInput& input, const Finding& finding);
void begin_new_game(RefereeState& state, const RefereeInput& input, const Finding& finding);

inline constexpr Action kBeginGames{"save positions; send STOP", begin};
inline constexpr Action kPrepareFirstKickoff{
    "place the ball at the centre; send PREPARE_KICKOFF; next = NORMAL_START",
    prepare_first_kickoff};
inline constexpr Action kSendPreparation{"send next; next = NORMAL_START; restart the wait",
                                         send_preparation};
inline constexpr Action kStartPlay{"send next; the clock starts with a half's first kick-off",
                                   start_play};
inline constexpr Action kAwardGoal{
    "score; send GOAL; place the ball at the centre; next = PREPARE_KICKOFF for the conceding team",
    award_goal};
inline constexpr Action kStopPlay{"send STOP; place the ball; next = the rule's restart",
                                  stop_play};
inline constexpr Action kNoteFoul{"count the foul", note_foul};
inline constexpr Action kNoteFoulInPenalty{"count the foul; it decides the penalty kick",
                                           note_foul_in_penalty};
inline constexpr Action kAllowMoreTime{"count the foul; allow 10 s more to place the ball",
                                       allow_more_time};
inline constexpr Action kSetRestartInStop{
    "count the foul; next = the rule's restart; restart the wait", set_restart_in_stop};
inline constexpr Action kHaltForFoul{"count the foul; send HALT; next = the rule's restart",
                                     halt_for_foul};
inline constexpr Action kShowCard{"allow one robot fewer", show_card};
inline constexpr Action kEndCard{"allow one robot more", end_card};
inline constexpr Action kStopAfterSignal{"send STOP", stop_after_signal};
inline constexpr Action kEndHalf{"send HALT; next = PREPARE_KICKOFF for the other team", end_half};
inline constexpr Action kBeginNextHalf{"send STOP; place the ball at the centre", begin_next_half};
inline constexpr Action kBeginTimeout{"send TIMEOUT; then prepare the restart again",
                                      begin_timeout};
inline constexpr Action kEndTimeout{"send STOP; restart the wait", end_timeout};
inline constexpr Action kBeginExtraTime{
    "send HALT; reset the timeouts; next = PREPARE_KICKOFF for the team that kicked off first",
    begin_extra_time};
inline constexpr Action kEndForShootout{
    "send HALT; next = PREPARE_PENALTY for the team that kicked off first", end_for_shootout};
inline constexpr Action kBeginShootout{"send STOP; place the ball at the mark", begin_shootout};
inline constexpr Action kCountShootoutGoal{
    "count the goal; send GOAL; place the ball at the mark; next = PREPARE_PENALTY for the next "
    "kicker",
    count_shootout_goal};
inline constexpr Action kCountShootoutMiss{
    "count the kick; send STOP; place the ball at the mark; next = PREPARE_PENALTY for the next "
    "kicker",
    count_shootout_miss};
inline constexpr Action kEndGame{"send HALT", end_game};
inline constexpr Action kBeginNewGame{
    "reset the scores; send STOP; place the ball at the centre; next = PREPARE_KICKOFF",
    begin_new_game};

}  // namespace autoref::referee
