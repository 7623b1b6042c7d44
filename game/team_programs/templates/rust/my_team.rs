// A team of one page. Robot 0 stays in the goal, the robot nearest to the ball gets behind it and
// kicks it to the opponents' goal, and the others stand in a row. Our goal is at -x.
//
// It reads flat records and answers each frame with one. Anything else, such as debugging output,
// belongs in eprintln!. Every number is in metres and seconds.
use std::io::{self, Read, Write};

const SPEED_MPS: f64 = 2.0; // of all robots
const STOP_MPS: f64 = 0.9; // while play is stopped: the Laws of 2014 allow 1 m/s
const TURN_RADPS: f64 = 8.0;
const KICK_MPS: f64 = 5.0;
// Distance to the ball or its path while we may not play it: the rules require 0.5 m to the hull.
const TOO_NEAR_M: f64 = 0.6;
const KEEP_OFF_M: f64 = 0.65; // the distance to which robots retreat

const HALT: u8 = 0; // some values of `play`
const STOP: u8 = 1;
const KICKOFF: u8 = 4;
const RUNNING: u8 = 8;

#[derive(Clone, Copy)]
struct Point {
    x: f64,
    y: f64,
}

struct Robot {
    number: i32,
    at: Point,
    front: Point, // unit vector
    velocity: Point,
}

struct Frame {
    number: i64,
    latency: f64,
    play: u8,
    ours: bool,
    ball: Point,
    ball_velocity: Point,
    placement: Option<Point>, // the referee's target for the ball
    own: Vec<Robot>,
}

#[derive(Default)]
struct Field {
    length: f64,
    width: f64,
    area_depth: f64,
    area_straight: f64,
    area_is_box: bool,
}

struct Aim {
    at: Point,
    facing: Point, // unit vector
}

struct Command {
    robot: i32,
    numbers: [f64; 4], // forward, to its left, turn, kick
}

fn decide(frame: &Frame, field: &Field) -> Vec<Command> {
    if frame.play == HALT {
        return Vec::new();
    }
    let latency = frame.latency; // our commands take effect this much later
    let ball = Point {
        x: frame.ball.x + frame.ball_velocity.x * latency,
        y: frame.ball.y + frame.ball_velocity.y * latency,
    };
    let is_ours = frame.play == RUNNING || (frame.ours && frame.play >= KICKOFF);
    let most = if frame.play == STOP { STOP_MPS } else { SPEED_MPS };
    let is_ball_in_our_area = is_in_area(field, -ball.x, ball.y, 0.0);
    let chaser = if is_ball_in_our_area { 0 } else { nearest(&frame.own, ball) };
    let mut commands = Vec::new();
    for (index, robot) in frame.own.iter().enumerate() {
        let mut aim = if is_ours && index == chaser {
            attack(robot, ball, field)
        } else if index == 0 {
            guard(ball, field)
        } else {
            line_up(index as f64, frame.own.len() as f64, ball, field)
        };
        if index != 0 {
            aim.at.x = out_of_areas(field, aim.at.x, aim.at.y);
        }
        if !is_ours {
            aim.at = keep_off(robot, aim.at, nearest_on_way(robot, ball, frame));
        }
        commands.push(drive(robot, &aim, most, latency));
    }
    commands
}

// The index of the robot nearest to the ball, except the keeper.
fn nearest(own: &[Robot], ball: Point) -> usize {
    let mut best = own.len();
    let mut least = f64::INFINITY;
    for (index, robot) in own.iter().enumerate().skip(1) {
        let (dx, dy) = (robot.at.x - ball.x, robot.at.y - ball.y);
        if dx * dx + dy * dy < least {
            best = index;
            least = dx * dx + dy * dy;
        }
    }
    best
}

// Drives through the ball towards the goal, or first to a place behind the ball, or around it.
fn attack(robot: &Robot, ball: Point, field: &Field) -> Aim {
    let to = unit(field.length / 2.0 - ball.x, -ball.y);
    let (dx, dy) = (robot.at.x - ball.x, robot.at.y - ball.y);
    let ahead = dx * to.x + dy * to.y;
    let aside = dy * to.x - dx * to.y;
    let (back, off) = if ahead < -0.05 && -0.04 < aside && aside < 0.04 {
        (-0.05, 0.0)
    } else if ahead < -0.12 {
        (0.15, 0.0)
    } else {
        (0.2, if aside > 0.0 { 0.25 } else { -0.25 })
    };
    let at = Point {
        x: ball.x - back * to.x - off * to.y,
        y: ball.y - back * to.y + off * to.x,
    };
    Aim { at, facing: to }
}

// Stands on the line from the ball to the middle of our goal.
fn guard(ball: Point, field: &Field) -> Aim {
    let goal_x = -field.length / 2.0;
    let to = unit(ball.x - goal_x, ball.y);
    let at = Point { x: goal_x + 0.1 + 0.2 * to.x, y: 0.3 * to.y };
    Aim { at, facing: to }
}

// Stands in a row across our half, facing the ball.
fn line_up(index: f64, count: f64, ball: Point, field: &Field) -> Aim {
    let at = Point {
        x: -field.length / 5.0,
        y: (index - count / 2.0) * field.width / (count + 1.0),
    };
    Aim { at, facing: unit(ball.x - at.x, ball.y - at.y) }
}

// Whether a point is in the opponents' defence area, approximated by a box; for ours, pass -x.
fn is_in_area(field: &Field, x: f64, y: f64, margin: f64) -> bool {
    let mut half = field.area_straight / 2.0;
    if !field.area_is_box {
        half = half + field.area_depth;
    }
    let depth = field.area_depth + margin;
    x > field.length / 2.0 - depth && -half - margin < y && y < half + margin
}

// The nearest x at which a robot is in neither defence area.
fn out_of_areas(field: &Field, x: f64, y: f64) -> f64 {
    let limit = field.length / 2.0 - field.area_depth - 0.3;
    if is_in_area(field, x, y, 0.3) {
        limit
    } else if is_in_area(field, -x, y, 0.3) {
        -limit
    } else {
        x
    }
}

// The point nearest to the robot on the ball's path to the referee's target.
fn nearest_on_way(robot: &Robot, ball: Point, frame: &Frame) -> Point {
    let end = frame.placement.unwrap_or(ball);
    let way = Point { x: end.x - ball.x, y: end.y - ball.y };
    let whole = way.x * way.x + way.y * way.y;
    let along = (robot.at.x - ball.x) * way.x + (robot.at.y - ball.y) * way.y;
    if along <= 0.0 {
        ball
    } else if along >= whole {
        end
    } else {
        Point { x: ball.x + along / whole * way.x, y: ball.y + along / whole * way.y }
    }
}

// Moves away from a point if the robot is near it; otherwise goes to the place, but around the
// point.
fn keep_off(robot: &Robot, mut place: Point, point: Point) -> Point {
    let (dx, dy) = (robot.at.x - point.x, robot.at.y - point.y);
    if dx * dx + dy * dy < TOO_NEAR_M * TOO_NEAR_M {
        place = robot.at;
    }
    let from = unit(dx, dy);
    let lack = KEEP_OFF_M - (place.x - point.x) * from.x - (place.y - point.y) * from.y;
    if lack > 0.0 {
        place = Point { x: place.x + lack * from.x, y: place.y + lack * from.y };
    }
    place
}

// A command that brings the robot to its aim.
fn drive(robot: &Robot, aim: &Aim, most: f64, latency: f64) -> Command {
    let mut vx = 3.0 * (aim.at.x - robot.at.x - robot.velocity.x * latency);
    let mut vy = 3.0 * (aim.at.y - robot.at.y - robot.velocity.y * latency);
    let speed = (vx * vx + vy * vy).sqrt();
    if speed > most {
        vx = vx / speed * most;
        vy = vy / speed * most;
    }
    let front = robot.front;
    let mut turn = front.x * aim.facing.y - front.y * aim.facing.x; // the sine of the angle to turn by
    if front.x * aim.facing.x + front.y * aim.facing.y < 0.0 {
        turn = if turn > 0.0 { 1.0 } else { -1.0 };
    }
    let forward = vx * front.x + vy * front.y;
    let left = vy * front.x - vx * front.y;
    // It kicks as soon as the ball is at the kicker.
    Command { robot: robot.number, numbers: [forward, left, TURN_RADPS * turn, KICK_MPS] }
}

fn unit(x: f64, y: f64) -> Point {
    let length = (x * x + y * y).sqrt();
    if length > 0.0 {
        Point { x: x / length, y: y / length }
    } else {
        Point { x: 1.0, y: 0.0 }
    }
}

// From here on: reading and writing. The numbers are offsets in the records.

fn bytes<const N: usize>(record: &[u8], offset: usize) -> [u8; N] {
    record[offset..offset + N].try_into().unwrap()
}

fn f64_at(record: &[u8], offset: usize) -> f64 {
    f64::from_le_bytes(bytes(record, offset))
}

fn point_at(record: &[u8], offset: usize) -> Point {
    Point { x: f64_at(record, offset), y: f64_at(record, offset + 8) }
}

fn read_start(record: &[u8]) -> Field {
    Field {
        length: f64_at(record, 32),
        width: f64_at(record, 40),
        area_depth: f64_at(record, 80),
        area_straight: f64_at(record, 88),
        area_is_box: u32::from_le_bytes(bytes(record, 136)) != 0,
    }
}

fn read_robot(record: &[u8]) -> Robot {
    Robot {
        number: i32::from_le_bytes(bytes(record, 56)),
        at: point_at(record, 0),
        front: point_at(record, 16),
        velocity: point_at(record, 32),
    }
}

fn read_frame(record: &[u8]) -> Frame {
    let robots = usize::from(record[144]);
    Frame {
        number: i64::from_le_bytes(bytes(record, 8)),
        latency: f64_at(record, 24),
        play: record[136],
        ours: record[137] != 0,
        ball: point_at(record, 56),
        ball_velocity: point_at(record, 72),
        placement: (record[138] != 0).then(|| point_at(record, 40)),
        own: record[152..].chunks_exact(64).take(robots).map(read_robot).collect(),
    }
}

fn output_of(frame: i64, commands: &[Command]) -> Vec<u8> {
    let keeper = commands.first().map_or(0, |command| command.robot);
    let mut output = Vec::new();
    output.extend((32 + 40 * commands.len() as u32).to_le_bytes());
    output.extend([4, 0, 0, 0]); // the kind; no timeout
    output.extend(frame.to_le_bytes());
    output.extend(keeper.to_le_bytes());
    output.extend((-1i32).to_le_bytes()); // no robot leaves
    output.extend((commands.len() as u16).to_le_bytes());
    output.extend([0; 6]);
    for command in commands {
        for number in command.numbers {
            output.extend(number.to_le_bytes());
        }
        output.extend(command.robot.to_le_bytes());
        output.extend([0; 4]); // no chip kick, no dribbler
    }
    output
}

fn read_record(input: &mut impl Read) -> io::Result<Vec<u8>> {
    let mut length = [0; 4];
    input.read_exact(&mut length)?;
    let mut record = vec![0; u32::from_le_bytes(length) as usize];
    input.read_exact(&mut record[4..])?;
    Ok(record)
}

fn main() -> io::Result<()> {
    let mut input = io::stdin().lock();
    let mut output = io::stdout().lock();
    output.write_all(b"autoref-team 1 flat\n")?;
    output.flush()?;
    let mut field = Field::default();
    loop {
        let record = read_record(&mut input)?;
        match record[4] {
            1 => field = read_start(&record),
            2 => {
                let frame = read_frame(&record);
                output.write_all(&output_of(frame.number, &decide(&frame, &field)))?;
                output.flush()?;
            }
            _ => return Ok(()), // the game has ended
        }
    }
}
