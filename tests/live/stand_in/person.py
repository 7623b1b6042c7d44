"""What a person does at the game controller."""
import events
from laws import (
    BEFORE_HALVES,
    DIRECT_FREE,
    FORCE_START,
    GOAL,
    HALT,
    HALVES,
    NORMAL_START,
    PLACEMENT,
    POST_GAME,
    PREPARE_KICKOFF,
    PREPARE_PENALTY,
    STOP,
    for_team,
)
from protocol import BLUE, name_of_team, opponent_of


class PersonsActions:
    """The part of Match that does continue actions and changes."""

    def act(self, name, team):
        """Does a continue action. Returns whether it was possible in this state."""
        action = getattr(self, "_" + name.lower(), None)
        is_possible = action is not None and action(team)
        self.journal.note("action", name=name, team=name_of_team(team), possible=bool(is_possible))
        return bool(is_possible)

    def _halt(self, _team):
        return self._set(HALT)

    def _stop_game(self, _team):
        return self._set(STOP)

    def _resume_from_halt(self, _team):
        is_possible = self.command == HALT and self.goal is None and self.stage != POST_GAME
        return is_possible and self._set(STOP)

    def _next_command(self, _team):
        return self.next_command is not None and self._set(self.next_command)

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
        self.teams[team].goals += 1
        self._set(for_team(GOAL, team))
        self._plan(for_team(PREPARE_KICKOFF, opponent_of(team)), (0.0, 0.0))
        return self._set(HALT)

    def _reject_goal(self, _team):
        if self.goal is None:
            return False
        team, where = events.team_of(self.goal), events.location_of(self.goal) or (0.0, 0.0)
        self.goal = None
        self._plan(for_team(DIRECT_FREE, opponent_of(team)), self.field.free_kick_position(*where))
        return self._set(STOP)

    def _next_stage(self, _team):
        if self.stage == POST_GAME:
            return False
        self._enter(self.stage + 1, 0.0)
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
