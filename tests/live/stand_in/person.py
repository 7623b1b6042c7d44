"""What a person does at the game controller."""
import events
from laws import (
    BEFORE_HALVES,
    BREAK_S,
    FORCE_START,
    GOAL,
    HALT,
    HALVES,
    NORMAL_START,
    PAUSED,
    PLACEMENT,
    POST_GAME,
    PREPARE_KICKOFF,
    PREPARE_PENALTY,
    STOP,
    for_team,
)
from protocol import BLUE, game_event, name_of_team, opponent_of


class Crash(Exception):
    """What the controller does not survive."""


def add_event(listed, name, team):
    """Appends an event of the controller's own."""
    event = game_event.GameEventMessage(type=events.TYPES[name])
    getattr(event, name.lower()).by_team = team
    listed.append(event)


class PersonsActions:
    """The part of Match that does continue actions and changes."""

    def act(self, name, team, made=lambda: None):
        """Does a continue action; `made` is called after its change. Like the real controller, it
        takes the next command of now, and crashes without one."""
        if name == "NEXT_COMMAND" and self.next_command is None:
            raise Crash("NEXT_COMMAND without a next command")
        command = self.next_command
        self.enqueue(lambda: self._act(name, team, command, made))

    def _act(self, name, team, command, made):
        action = getattr(self, "_" + name.lower(), None)
        is_possible = action is not None and action(command if name == "NEXT_COMMAND" else team)
        self.journal.note("action", name=name, team=name_of_team(team), possible=bool(is_possible))
        made()

    def _halt(self, _team):
        return self._set(HALT)

    def _stop_game(self, _team):
        return self._set(STOP)

    def _resume_from_halt(self, _team):
        is_possible = self.command == HALT and self.goal is None and self.stage != POST_GAME
        return is_possible and self._set(STOP)

    def _next_command(self, command):
        return self._set(command)

    def _normal_start(self, _team):
        kind = self.command & ~1
        if kind not in (PREPARE_KICKOFF, PREPARE_PENALTY):
            return False
        if self.stage in BEFORE_HALVES:
            self._enter(self.stage + 1, self.half_s)
        return self._set(NORMAL_START)

    def _force_start(self, _team):
        return self._set(FORCE_START)

    def _ball_placement_start(self, team):
        return self._set(for_team(PLACEMENT, team))

    def _accept_goal(self, _team):
        if self.goal is None:
            return False
        team = events.team_of(self.goal)
        self.goal = None
        add_event(self.events, "GOAL", team)
        self.teams[team].goals += 1
        self._set(for_team(GOAL, team))
        self._plan(for_team(PREPARE_KICKOFF, opponent_of(team)), (0.0, 0.0))
        return self._set(HALT)

    def _reject_goal(self, _team):
        if self.goal is None:
            return False
        add_event(self.events, "INVALID_GOAL", events.team_of(self.goal))
        self.goal = None
        self.on_change()
        return True

    def _next_stage(self, _team):
        if self.stage == POST_GAME:
            return False
        self._enter(self.stage + 1, BREAK_S if self.stage + 1 in PAUSED else self.half_s)
        if self.stage in (2, 8):
            self.blue_on_positive_half = not self.blue_on_positive_half
        kicking = self.first_kickoff if self.stage in (0, 6) else opponent_of(self.first_kickoff)
        self._plan(for_team(PREPARE_KICKOFF, kicking), (0.0, 0.0))
        return self._set(HALT)

    def _end_game(self, _team):
        self._enter(POST_GAME, 0.0)
        self._plan(None, None)
        return self._set(HALT)

    def configure(self, change):
        """Does a change of names, sides or division."""
        self.enqueue(lambda: self._configure(change))

    def _configure(self, change):
        kind = change.WhichOneof("change")
        body = getattr(change, kind) if kind else None
        self.journal.note("change", name=kind)
        if kind == "update_config_change":
            self._configure_game(body)
        elif kind == "update_team_state_change" and body.for_team in self.teams:
            self._configure_team(self.teams[body.for_team], body)
        elif kind == "set_ball_placement_pos_change":
            self.position = (body.pos.x, body.pos.y)
        elif kind == "change_stage_change":
            self._enter(body.new_stage, self.half_s if body.new_stage in HALVES else 0.0)
        self.on_change()

    def _configure_game(self, body):
        if body.first_kickoff_team:
            self.first_kickoff = body.first_kickoff_team
            if self.stage == 0:
                self.next_command = for_team(PREPARE_KICKOFF, self.first_kickoff)
        if body.HasField("max_robots_per_team"):
            self.max_robots = body.max_robots_per_team.value

    def _configure_team(self, team, body):
        if body.HasField("team_name"):
            team.name = body.team_name.value.decode(errors="replace")
        if body.HasField("goals"):
            team.goals = body.goals.value
        if body.HasField("goalkeeper"):
            team.keeper = body.goalkeeper.value
        if body.HasField("can_place_ball"):
            team.can_place = body.can_place_ball.value
        if body.HasField("on_positive_half"):
            is_blue = body.for_team == BLUE
            self.blue_on_positive_half = body.on_positive_half.value == is_blue
