"""Checks of the referee's packets: units are millimetres and microseconds."""

LARGEST_BYTES = 1024
LONGEST_GAP_US = 60_000
LONGEST_ACTION_US = 60_000_000
HIGHEST_ID = 15
HALT, STOP, NORMAL_START, FORCE_START = 0, 1, 2, 3
PREPARATIONS, PLACEMENTS, GOALS = (4, 5, 6, 7), (16, 17), (14, 15)
INDIRECT = 10, 11
PLAY = NORMAL_START, FORCE_START, 8, 9
STAGE_PAST_HALF = 2
# Type of a game event -> number of its field, where they differ; the others are equal.
EVENT_FIELDS = {41: 43, 42: 44, 43: 45, 44: 46, 45: 47, 46: 48, 47: 51, 48: 52, 40: 42}
YEAR_2020_US, YEAR_2100_US = 1_577_836_800_000_000, 4_102_444_800_000_000


class RefereeChecks:
    """The packets of one game, one after the other."""

    def __init__(self, findings, field_mm=(4500, 3000, 300)):
        self.findings = findings
        self.expect, self.expect_within = findings.expect, findings.expect_within
        self.field_mm, self.previous, self.announced = field_mm, None, None
        self.stages, self.farthest_mm = set(), 0

    def check(self, packet, size):
        self.expect("referee: fits into 1024 bytes", size < LARGEST_BYTES, size)
        self.findings.expect_known("referee: no unknown fields", packet)
        self.check_times(packet)
        self.check_next_command(packet)
        self.check_position(packet)
        for team in (packet.yellow, packet.blue):
            self.check_team(team)
        for event in packet.game_events:
            self.check_event(event)
        if self.previous is not None:
            self.check_change(self.previous, packet)
        self.stages.add(packet.stage)
        self.previous = packet

    def check_times(self, packet):
        self.expect_within("referee: times are in microseconds", packet.packet_timestamp, YEAR_2020_US, YEAR_2100_US)
        self.expect(
            "referee: no command is of the future",
            packet.command_timestamp <= packet.packet_timestamp,
            f"{packet.command_timestamp} > {packet.packet_timestamp}",
        )
        if packet.HasField("stage_time_left"):
            self.expect_within("referee: time left of the stage", packet.stage_time_left, -3_600_000_000, 3_600_000_000)
        if packet.HasField("current_action_time_remaining"):
            self.expect_within(
                "referee: time left of the action",
                packet.current_action_time_remaining,
                -LONGEST_ACTION_US,
                LONGEST_ACTION_US,
            )

    def check_next_command(self, packet):
        self.expect("referee: no indirect free kicks", packet.command not in INDIRECT, packet.command)
        if packet.command in PREPARATIONS:
            self.expect(
                "referee: a preparation announces NORMAL_START",
                packet.HasField("next_command") and packet.next_command == NORMAL_START,
                packet.next_command,
            )
        if packet.command in PLAY:
            self.expect("referee: play announces nothing", not packet.HasField("next_command"), packet.next_command)

    def check_position(self, packet):
        if packet.command in PLACEMENTS:
            self.expect("referee: a placement has a position", packet.HasField("designated_position"))
        if packet.HasField("designated_position"):
            x, y = abs(packet.designated_position.x), abs(packet.designated_position.y)
            end, side, _ = self.field_mm
            self.expect_within("referee: the ball is placed on the field", x, 0, end)
            self.expect_within("referee: the ball is placed on the field", y, 0, side)
            self.farthest_mm = max(x, y, self.farthest_mm)

    def check_team(self, team):
        self.expect("referee: teams have names", team.name != "")
        self.expect_within("referee: keeper's number", team.goalkeeper, 0, HIGHEST_ID)
        self.expect(
            "referee: active cards are among all cards",
            len(team.yellow_card_times) <= team.yellow_cards,
            f"{len(team.yellow_card_times)} of {team.yellow_cards}",
        )
        for time_us in team.yellow_card_times:
            self.expect_within("referee: a card lasts two minutes", time_us, 0, 120_000_000)
        if team.HasField("max_allowed_bots"):
            allowed = max(0, 6 - len(team.yellow_card_times) - team.red_cards)
            self.expect(
                "referee: a robot fewer for each card",
                team.max_allowed_bots == allowed,
                f"{team.max_allowed_bots}, not {allowed}",
            )

    def check_event(self, event):
        self.expect("referee: an event has a type", event.HasField("type"))
        number = EVENT_FIELDS.get(event.type, event.type)
        fields = [field.number for field, _ in event.ListFields()]
        self.expect("referee: an event's type is that of its field", number in fields, f"{event.type}: {fields}")

    def check_change(self, previous, packet):
        gap_us = packet.packet_timestamp - previous.packet_timestamp
        self.expect("referee: time does not go back", gap_us >= 0, gap_us)
        self.expect("referee: every 25 ms", gap_us <= LONGEST_GAP_US, gap_us)
        self.expect(
            "referee: stages follow one another",
            packet.stage >= previous.stage,
            f"{packet.stage} after {previous.stage}",
        )
        self.check_counter(previous, packet)
        is_same_stage = packet.stage == previous.stage
        if packet.blue_team_on_positive_half != previous.blue_team_on_positive_half:
            self.expect("referee: ends change between halves", not is_same_stage)
        if is_same_stage and packet.HasField("stage_time_left"):
            self.expect(
                "referee: a stage's time runs down",
                packet.stage_time_left <= previous.stage_time_left,
                f"{packet.stage_time_left} after {previous.stage_time_left}",
            )
        for now, before in ((packet.yellow, previous.yellow), (packet.blue, previous.blue)):
            self.expect_within("referee: one goal at a time", now.score - before.score, 0, 1)
            self.expect(
                "referee: cards stay", now.yellow_cards >= before.yellow_cards and now.red_cards >= before.red_cards
            )
            self.expect("referee: names stay", now.name == before.name, f"{now.name} after {before.name}")

    def check_counter(self, previous, packet):
        steps = packet.command_counter - previous.command_counter
        self.expect_within("referee: the counter grows by one", steps, 0, 1)
        if steps:
            # Two commands of one frame, such as STOP and HALT at the end of a half, have the same time.
            self.expect(
                "referee: a command is of the time of its packet",
                packet.command_timestamp >= previous.command_timestamp,
                f"{packet.command_timestamp} after {previous.command_timestamp}",
            )
            age_us = packet.packet_timestamp - packet.command_timestamp
            self.expect_within("referee: a command is of the time of its packet", age_us, 0, LONGEST_GAP_US)
            self.check_announced(previous, packet)
        else:
            self.expect(
                "referee: a command counts",
                packet.command == previous.command,
                f"{packet.command} after {previous.command}",
            )
            self.expect("referee: a command keeps its time", packet.command_timestamp == previous.command_timestamp)

    def check_announced(self, previous, packet):
        """After a stop comes what was announced, unless the ball must be placed first or the game halts."""
        others = (HALT, STOP, *PLACEMENTS, *GOALS)
        if previous.HasField("next_command") and packet.command not in others:
            self.expect(
                "referee: the announced command comes",
                packet.command == previous.next_command,
                f"{packet.command}, not {previous.next_command}",
            )

    def check_end(self, stages=(0, 1, 4, 13)):
        missing = sorted(set(stages) - self.stages)
        self.expect("referee: a game goes through its stages", not missing, f"{missing} did not come")
        if self.farthest_mm:  # not only the centre
            self.expect_within("referee: the position is in millimetres", self.farthest_mm, 100, 10000)
