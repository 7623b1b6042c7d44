"""The three ways in which robots' commands reach a simulator."""
import collections
import select
import time

import network
from world import BLUE, YELLOW

PORTS = {BLUE: 10301, YELLOW: 10302}
GRSIM_PORT, STATUS_PORTS = 20011, {BLUE: 30011, YELLOW: 30012}
LAST_ANSWERS_S = 3


class Link:
    """Counts what was sent and answered."""

    def __init__(self, messages):
        self.messages, self.counts, self.errors = messages, collections.Counter(), collections.Counter()

    def note_errors(self, errors):
        self.errors.update(error.code for error in errors)

    def note_feedback(self, robots):
        self.counts["feedback"] += len(robots)
        self.counts["ball contacts"] += sum(robot.dribbler_ball_contact for robot in robots)

    def send(self, udp, message, address):
        """An empty message would be an empty datagram; it says nothing and is not sent."""
        packet = message.SerializeToString()
        if packet:
            self.counts["sent"] += 1
            udp.sendto(packet, address)

    def robot_control(self, robots, commands):
        """Even numbers are commanded in their own coordinates, odd ones in the field's."""
        control = self.messages.RobotControl()
        for number, command in commands.items():
            one = control.robot_commands.add(
                id=number, kick_speed=command.kick_mps, kick_angle=0, dribbler_speed=1000 if command.dribbles else 0
            )
            if number % 2:
                one.move_command.global_velocity.x = command.velocity.real
                one.move_command.global_velocity.y = command.velocity.imag
                one.move_command.global_velocity.angular = command.turn_radps
            else:
                local = command.velocity * robots[number][1].conjugate()
                one.move_command.local_velocity.forward = local.real
                one.move_command.local_velocity.left = local.imag
                one.move_command.local_velocity.angular = command.turn_radps
        return control


class SimulationLink(Link):
    """The simulation protocol: each packet is answered."""

    def __init__(self, messages, teams):
        super().__init__(messages)
        self.sockets = {team: network.sending() for team in teams}

    def inputs(self):
        return self.sockets.values()

    def command(self, team, robots, commands):
        self.send(self.sockets[team], self.robot_control(robots, commands), (network.HOST, PORTS[team]))

    def read_answers(self):
        for udp in self.sockets.values():
            for packet in network.waiting(udp):
                answer = self.messages.RobotControlResponse.FromString(packet)
                self.counts["answers"] += 1
                self.note_feedback(answer.feedback)
                self.note_errors(answer.errors)

    def read_last_answers(self):
        """Waits a little for answers to the last commands."""
        deadline = time.monotonic() + LAST_ANSWERS_S
        while self.counts["answers"] < self.counts["sent"] and time.monotonic() < deadline:
            select.select(self.inputs(), [], [], 0.1)
            self.read_answers()


class GrSimLink(Link):
    """grSim's packets: nothing is answered, but the robots' status arrives at two ports."""

    def __init__(self, messages, teams):
        super().__init__(messages)
        self.udp = network.sending()
        self.status = {team: network.sending(STATUS_PORTS[team]) for team in teams}

    def inputs(self):
        return self.status.values()

    def command(self, team, robots, commands):
        packet = self.messages.grSim_Packet()
        packet.commands.timestamp, packet.commands.isteamyellow = 0, team == YELLOW
        for number, command in commands.items():
            local = command.velocity * robots[number][1].conjugate()
            packet.commands.robot_commands.add(
                id=number,
                kickspeedx=command.kick_mps,
                kickspeedz=0,
                veltangent=local.real,
                velnormal=local.imag,
                velangular=command.turn_radps,
                spinner=command.dribbles,
                wheelsspeed=False,
            )
        self.send(self.udp, packet, (network.HOST, GRSIM_PORT))

    def read_answers(self):
        for udp in self.status.values():
            for packet in network.waiting(udp):
                status = self.messages.Robots_Status.FromString(packet)
                self.counts["status"] += 1
                self.counts["ball contacts"] += sum(one.infrared for one in status.robots_status)

    def read_last_answers(self):
        self.read_answers()


class LockStepLink(Link):
    """SimulationSyncRequest: the game goes on when all teams have asked."""

    def __init__(self, messages, teams):
        super().__init__(messages)
        self.sockets = {team: network.sending() for team in teams}

    def ask(self, team, step_s, robots, commands):
        request = self.messages.SimulationSyncRequest(sim_step=step_s)
        if commands:
            request.robot_control.CopyFrom(self.robot_control(robots, commands))
        self.send(self.sockets[team], request, (network.HOST, PORTS[team]))

    def answer(self, team, patience_s):
        """The detections of one team's answer, in the order in which they were taken."""
        self.sockets[team].settimeout(patience_s)
        packet = self.sockets[team].recv(network.LARGEST_DATAGRAM)
        response = self.messages.SimulationSyncResponse.FromString(packet)
        self.counts["answers"] += 1
        self.note_errors(response.robot_control_response.errors)
        self.note_feedback(response.robot_control_response.feedback)
        return response.detection
