"""The game as the stand-in sees it: stage, command, score, and how they change."""
import math
import time

import events
from laws import (
    AFTER_HALT_S,
    COMMANDS,
    DIRECT_FREE,
    FORCE_START,
    FREE_KICK_S,
    HALT,
    HALVES,
    IN_PLAY_M,
    NORMAL_START,
    NO_PROGRESS_M,
    NO_PROGRESS_S,
    PAUSED,
    PLACED_M,
    PLACEMENT,
    PLACEMENT_S,
    PREPARE_KICKOFF,
    PREPARE_PENALTY,
    PROPOSAL_S,
    RUNNING,
    STAGES,
    STOP,
    STOP_S,
    for_team,
)
from person import PersonsActions, add_event
from protocol import BLUE, YELLOW, name_of_team, opponent_of, referee


class Team:
    def __init__(self, name):
        self.name = name
        self.goals = self.fouls = self.keeper = self.placement_failures = 0
        self.yellow_cards = 0
        self.can_place = True


class Proposal:
    def __init__(self, event, origin, now):
        self.event, self.origins, self.since = event, {origin}, now
        self.is_accepted = False


class Match(PersonsActions):
    """Pure: times are given, in seconds; `on_change` is called after each change. What a tick, an
    event or an action brings about is a change that the engine makes later (engine.py)."""

    def __init__(self, journal, half_s=300.0):
        self.journal, self.half_s = journal, half_s
        self.on_change = lambda: None
        self.enqueue = self.continue_with = None  # set by the engine
        self.field = events.Field()
        self.now = self.command_s = 0.0
        self.autorefs = 0
        self.auto_continue = True
        self.reset()

    def reset(self):
        self.teams = {YELLOW: Team("Yellow"), BLUE: Team("Blue")}
        self.first_kickoff, self.max_robots = YELLOW, 6
        self.stage, self.stage_left = 0, self.half_s
        self.command, self.counter, self.command_us = HALT, 0, 0
        self.next_command = for_team(PREPARE_KICKOFF, YELLOW)
        self.blue_on_positive_half = True
        self.position = (0.0, 0.0)
        self.failed_placement, self.was_placed = set(), False
        self.resumed_s = -math.inf  # when the last HALT ended
        self.is_play = False  # the ball is in play
        self.goal = None  # a possible goal that waits for a person
        self.events, self.proposals = [], []
        self.ball = self.start = None
        self.ball_s = 0.0  # since when the ball is near `start`

    # What automatic referees report.

    def propose(self, event, origin):
        """Takes an event with a type."""
        self.enqueue(lambda: self._propose(event, origin))

    def _propose(self, event, origin):
        name = events.NAMES.get(event.type, str(event.type))
        why = self._why_ignored(name)
        if why:
            self.journal.note("ignored", event=name, why=why)
            return
        for proposal in self.proposals:
            if not proposal.is_accepted and self._is_same(proposal.event, event):
                proposal.origins.add(origin)
                return
        self.proposals.append(Proposal(event, origin, self.now))
        self.journal.note("proposal", event=name, origin=origin, time_s=self.now)
        self.on_change()

    @staticmethod
    def _is_same(one, other):
        return one.type == other.type and events.team_of(one) == events.team_of(other)

    def _why_ignored(self, name):
        if self.stage not in HALVES and self.stage != 12:
            return "the stage is " + STAGES[self.stage]
        if self.command == HALT:
            return "the game is halted"
        if not self.is_play and name not in events.OUTSIDE_PLAY:
            return "play has not begun"
        return ""

    def _settle_proposals(self):
        for proposal in [one for one in self.proposals if not one.is_accepted]:
            if self.now - proposal.since < PROPOSAL_S:
                continue
            name = events.NAMES.get(proposal.event.type, "")
            if name in events.ACCEPTED or 2 * len(proposal.origins) > self.autorefs:
                self.enqueue(lambda name=name, proposal=proposal: self._accept(name, proposal))
        self.proposals = [one for one in self.proposals if self.now - one.since < 5]

    def _accept(self, name, proposal):
        """If two ticks are taken before this change, a proposal is accepted twice and its foul counts
        twice."""
        proposal.is_accepted = True
        self.on_change()
        self._count(name, proposal.event, sorted(proposal.origins))

    def _count(self, name, event, origins):
        """An event that counts changes the game."""
        why = self._why_ignored(name)
        self.journal.note(
            "event",
            event=name,
            team=name_of_team(events.team_of(event)),
            origins=origins,
            why_ignored=why,
            time_s=self.now,
        )
        if why:
            return
        self.events.append(event)
        team = events.team_of(event)
        if name == "POSSIBLE_GOAL":
            self._possible_goal(event)
        elif name == "PLACEMENT_SUCCEEDED":
            self._after_placement()
        elif name == "DEFENDER_IN_DEFENSE_AREA":
            sign = 1 if (team == BLUE) == self.blue_on_positive_half else -1
            self._stop(for_team(PREPARE_PENALTY, opponent_of(team)), (sign * (self.field.half_length - 6), 0.0))
        elif name == "PENALTY_KICK_FAILED":
            where = events.placement_of(event, self.field, self.blue_on_positive_half)
            self._stop(for_team(DIRECT_FREE, opponent_of(team)), where)
        elif name in events.STOPPING:
            where = events.placement_of(event, self.field, self.blue_on_positive_half)
            self._stop(for_team(DIRECT_FREE, opponent_of(team)) if team else FORCE_START, where)
        elif name in events.FOULS_IN_PLAY and team:
            self._foul(team)
        self.on_change()

    def _possible_goal(self, event):
        self.goal = event
        where = events.placement_of(event, self.field, self.blue_on_positive_half)
        self._plan(for_team(DIRECT_FREE, opponent_of(events.team_of(event))), where)
        self.is_play = False
        self._set(HALT)

    def _foul(self, team):
        self.teams[team].fouls += 1
        if self.teams[team].fouls % 3 == 0:
            self.journal.note(
                "event",
                event="MULTIPLE_FOULS",
                team=name_of_team(team),
                origins=["game controller"],
                why_ignored="",
                time_s=self.now,
            )
            self.teams[team].yellow_cards += 1

    # What happens by itself.

    def tick(self, now, frame):
        """Goes on to a time, with the newest tracked frame or None."""
        elapsed, self.now = max(0.0, now - self.now) if self.now else 0.0, now
        if self.stage in PAUSED or self.command in RUNNING:
            self.stage_left -= elapsed
        if frame is not None and frame.balls:
            self.ball = frame.balls[0].pos.x, frame.balls[0].pos.y
        self._settle_proposals()
        self._watch_ball()
        if self.command & ~1 == PLACEMENT and self._since() > PLACEMENT_S:
            self.enqueue(self._fail_placement)
        if self.auto_continue:
            self._continue()

    def _since(self):
        return self.now - self.command_s

    def _watch_ball(self):
        if self.ball is None:
            return
        if self.start is None:
            self.start, self.ball_s = self.ball, self.now
        moved = math.dist(self.ball, self.start)
        waits = self.command & ~1 == DIRECT_FREE or self.command == NORMAL_START
        if not self.is_play and waits and moved > IN_PLAY_M:
            self.enqueue(self._play)
        elif not self.is_play and waits and self._since() > FREE_KICK_S:
            self.enqueue(self._play)
        elif self.is_play and moved > NO_PROGRESS_M:
            self.start, self.ball_s = self.ball, self.now
        elif self.is_play and self.now - self.ball_s > NO_PROGRESS_S:
            self.enqueue(self._no_progress)

    def _no_progress(self):
        self.journal.note(
            "event",
            event="NO_PROGRESS_IN_GAME",
            team="UNKNOWN",
            origins=["game controller"],
            why_ignored="",
            time_s=self.now,
        )
        self._stop(FORCE_START, self.field.free_kick_position(*self.ball))

    def _play(self):
        self.is_play = True
        self.next_command = None
        self.start, self.ball_s = self.ball, self.now
        self.on_change()

    def is_placed(self):
        return self.ball is not None and self.position is not None and math.dist(self.ball, self.position) < PLACED_M

    def _continue(self):
        """What the controller does without a person: it starts placements, and goes on when
        everything is ready."""
        if self.command == STOP and self.next_command is not None:
            team = 0 if self.is_placed() or self.was_placed else self._placing_team()
            if team and (self.next_command & ~1 == DIRECT_FREE or self.next_command == FORCE_START):
                self.continue_with("BALL_PLACEMENT_START", team)
            elif self._since() >= self._preparation_s() and self.is_placed():
                self.continue_with("NEXT_COMMAND", 0)
        elif self.command & ~1 in (PREPARE_KICKOFF, PREPARE_PENALTY) and self._since() >= STOP_S and self.is_placed():
            self.continue_with("NORMAL_START", 0)

    def _preparation_s(self):
        if self.was_placed:
            return 0.0
        return AFTER_HALT_S if self.resumed_s == self.command_s else STOP_S

    def _placing_team(self):
        """Who places the ball next, or 0 if a person has to."""
        own = 1 + (self.next_command & 1) if self.next_command >= PREPARE_KICKOFF else YELLOW
        for team in (own, opponent_of(own)):
            if self.teams[team].can_place and team not in self.failed_placement:
                return team
        return 0

    def _after_placement(self):
        if self.command & ~1 != PLACEMENT or not self.is_placed():
            return
        self.was_placed = self.next_command == for_team(DIRECT_FREE, 1 + (self.command & 1))
        self._set(STOP)

    def _fail_placement(self):
        team = 1 + (self.command & 1)
        self.failed_placement.add(team)
        self.teams[team].placement_failures += 1
        add_event(self.events, "PLACEMENT_FAILED", team)
        self.journal.note(
            "event",
            event="PLACEMENT_FAILED",
            team=name_of_team(team),
            origins=["game controller"],
            why_ignored="",
            time_s=self.now,
        )
        self._set(STOP)

    def _stop(self, next_command, position):
        """A kick-off or penalty kick that has not been taken yet stays."""
        if self.is_play or self.next_command is None or self._next_kind() not in (PREPARE_KICKOFF, PREPARE_PENALTY):
            self._plan(next_command, position)
        if self.command not in (HALT, STOP):
            self._set(STOP)

    def _next_kind(self):
        """During a PREPARE, the next command is NORMAL_START; after a STOP it is the PREPARE again."""
        if self.command & ~1 in (PREPARE_KICKOFF, PREPARE_PENALTY):
            self.next_command = self.command
        return self.next_command & ~1

    def _plan(self, next_command, position):
        self.next_command, self.position = next_command, position
        self.failed_placement, self.was_placed = set(), False
        self.is_play = False

    def _enter(self, stage, left):
        self.journal.note("stage", stage=STAGES[stage], time_s=self.now, left_s=round(self.stage_left, 3))
        self.stage, self.stage_left = stage, left
        self.proposals = []

    def _set(self, command):
        if self.command == HALT and command == STOP:
            self.resumed_s = self.now
        self.command, self.command_s = command, self.now
        self.command_us = time.time_ns() // 1000
        self.counter += 1
        self.start = None
        self.is_play = command == FORCE_START
        if command in (PREPARE_KICKOFF, PREPARE_KICKOFF + 1, PREPARE_PENALTY, PREPARE_PENALTY + 1):
            self.next_command = NORMAL_START
        elif command in RUNNING:
            self.next_command, self.proposals, self.events = None, [], []
        self.journal.note("command", command=COMMANDS[command], time_s=self.now)
        self.on_change()
        return True

    # What everybody is sent.

    def message(self):
        packet = referee.RefereePacket(
            packet_timestamp=time.time_ns() // 1000,
            stage=self.stage,
            command=self.command,
            stage_time_left=round(1e6 * self.stage_left),
            command_counter=self.counter,
            command_timestamp=self.command_us,
            blue_team_on_positive_half=self.blue_on_positive_half,
            source_identifier=b"stand-in",
            match_type=3,
        )
        for team, info in ((YELLOW, packet.yellow), (BLUE, packet.blue)):
            self._fill_team(self.teams[team], info)
        if self.position is not None:
            packet.designated_position.x = 1000 * self.position[0]
            packet.designated_position.y = 1000 * self.position[1]
        if self.next_command is not None:
            packet.next_command = self.next_command
        if self.command & ~1 == PLACEMENT:
            packet.current_action_time_remaining = round(1e6 * (PLACEMENT_S - self._since()))
        packet.game_events.extend(event.SerializeToString() for event in self.events)
        return packet

    def _fill_team(self, team, info):
        info.name, info.score = team.name.encode(), team.goals
        info.red_cards = info.timeout_time = 0
        info.yellow_cards, info.timeouts = team.yellow_cards, 4
        info.goalkeeper, info.foul_counter = team.keeper, team.fouls
        info.ball_placement_failures, info.can_place_ball = team.placement_failures, team.can_place
        info.max_allowed_bots = self.max_robots
