/* A team of one page. Robot 0 stays in the goal, the robot nearest to the ball gets behind it and
   kicks it to the opponents' goal, and the others stand in a row. Our goal is at -x.

   It reads flat records and answers each frame with one. Anything else, such as debugging
   output, belongs on stderr. Every number is in metres and seconds. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define SPEED_MPS 2.0 /* of all robots */
#define STOP_MPS 0.9  /* while play is stopped: the Laws of 2014 allow 1 m/s */
#define TURN_RADPS 8.0
#define KICK_MPS 5.0
/* Distance to the ball or its path while we may not play it: the rules require 0.5 m to the hull. */
#define TOO_NEAR_M 0.6
#define KEEP_OFF_M 0.65 /* the distance to which robots retreat */

enum { START = 1, FRAME = 2, END = 3, OUTPUT = 4 };       /* kinds of records */
enum { HALT = 0, STOP = 1, KICKOFF = 4, RUNNING = 8 };    /* some values of `play` */
enum { MOST_ROBOTS = 16, OUTPUT_BYTES = 32, COMMAND_BYTES = 40 };

struct point { double x, y; };
struct robot { int32_t number; struct point at, front, velocity; };
struct aim { struct point at, facing; };

static char record[1 << 16]; /* the last record read; the numbers below are offsets in it */
static double length_m, width_m, area_depth_m, area_straight_m;
static int area_is_box;

static double f64(int offset) { double x; memcpy(&x, record + offset, 8); return x; }
static uint32_t u32(int offset) { uint32_t x; memcpy(&x, record + offset, 4); return x; }
static uint16_t u16(int offset) { uint16_t x; memcpy(&x, record + offset, 2); return x; }
static uint8_t u8(int offset) { return (uint8_t)record[offset]; }
static struct point point_at(int offset) { struct point p = {f64(offset), f64(offset + 8)}; return p; }

static struct point unit(double x, double y) {
  double length = sqrt(x * x + y * y);
  struct point p = {1.0, 0.0};
  if (length > 0) { p.x = x / length; p.y = y / length; }
  return p;
}

/* Whether a point is in the opponents' defence area, approximated by a box; for ours, pass -x. */
static int is_in_area(double x, double y, double margin) {
  double half = area_straight_m / 2;
  double depth = area_depth_m + margin;
  if (!area_is_box) half = half + area_depth_m;
  return x > length_m / 2 - depth && -half - margin < y && y < half + margin;
}

/* The nearest x at which a robot is in neither defence area. */
static double out_of_areas(double x, double y) {
  double limit = length_m / 2 - area_depth_m - 0.3;
  if (is_in_area(x, y, 0.3)) return limit;
  return is_in_area(-x, y, 0.3) ? -limit : x;
}

static int nearest(const struct robot *own, int count, struct point ball) {
  int best = count;
  double least = INFINITY;
  for (int i = 1; i < count; ++i) {
    double dx = own[i].at.x - ball.x, dy = own[i].at.y - ball.y;
    if (dx * dx + dy * dy < least) { best = i; least = dx * dx + dy * dy; }
  }
  return best;
}

/* Drives through the ball towards the goal, or first to a place behind the ball, or around it. */
static struct aim attack(const struct robot *robot, struct point ball) {
  struct point to = unit(length_m / 2 - ball.x, -ball.y);
  double dx = robot->at.x - ball.x, dy = robot->at.y - ball.y;
  double ahead = dx * to.x + dy * to.y, aside = dy * to.x - dx * to.y;
  double back = 0.2, off = aside > 0 ? 0.25 : -0.25;
  struct aim aim;
  if (ahead < -0.05 && -0.04 < aside && aside < 0.04) { back = -0.05; off = 0.0; }
  else if (ahead < -0.12) { back = 0.15; off = 0.0; }
  aim.at.x = ball.x - back * to.x - off * to.y;
  aim.at.y = ball.y - back * to.y + off * to.x;
  aim.facing = to;
  return aim;
}

/* Stands on the line from the ball to the middle of our goal. */
static struct aim guard(struct point ball) {
  double goal_x = -length_m / 2;
  struct aim aim;
  aim.facing = unit(ball.x - goal_x, ball.y);
  aim.at.x = goal_x + 0.1 + 0.2 * aim.facing.x;
  aim.at.y = 0.3 * aim.facing.y;
  return aim;
}

/* Stands in a row across our half, facing the ball. */
static struct aim line_up(double index, double count, struct point ball) {
  struct aim aim;
  aim.at.x = -length_m / 5;
  aim.at.y = (index - count / 2) * width_m / (count + 1);
  aim.facing = unit(ball.x - aim.at.x, ball.y - aim.at.y);
  return aim;
}

/* The point nearest to the robot on the ball's path to the referee's target. */
static struct point nearest_on_way(const struct robot *robot, struct point ball) {
  struct point end = u8(138) ? point_at(40) : ball;
  double way_x = end.x - ball.x, way_y = end.y - ball.y;
  double whole = way_x * way_x + way_y * way_y;
  double along = (robot->at.x - ball.x) * way_x + (robot->at.y - ball.y) * way_y;
  if (along <= 0) return ball;
  if (along >= whole) return end;
  ball.x = ball.x + along / whole * way_x;
  ball.y = ball.y + along / whole * way_y;
  return ball;
}

/* Moves away from a point if the robot is near it; otherwise goes to the place, but around the
   point. */
static struct point keep_off(const struct robot *robot, struct point place, struct point point) {
  double dx = robot->at.x - point.x, dy = robot->at.y - point.y, lack;
  struct point from = unit(dx, dy);
  if (dx * dx + dy * dy < TOO_NEAR_M * TOO_NEAR_M) place = robot->at;
  lack = KEEP_OFF_M - (place.x - point.x) * from.x - (place.y - point.y) * from.y;
  if (lack > 0) { place.x = place.x + lack * from.x; place.y = place.y + lack * from.y; }
  return place;
}

/* Writes a command that brings the robot to its aim. */
static void drive(const struct robot *robot, struct aim aim, double most, double latency, char *command) {
  double vx = 3 * (aim.at.x - robot->at.x - robot->velocity.x * latency);
  double vy = 3 * (aim.at.y - robot->at.y - robot->velocity.y * latency);
  double speed = sqrt(vx * vx + vy * vy);
  struct point front = robot->front;
  double turn = front.x * aim.facing.y - front.y * aim.facing.x; /* the sine of the angle to turn by */
  double numbers[4];
  if (speed > most) { vx = vx / speed * most; vy = vy / speed * most; }
  if (front.x * aim.facing.x + front.y * aim.facing.y < 0) turn = turn > 0 ? 1.0 : -1.0;
  numbers[0] = vx * front.x + vy * front.y; /* forward */
  numbers[1] = vy * front.x - vx * front.y; /* to its left */
  numbers[2] = TURN_RADPS * turn;
  numbers[3] = KICK_MPS; /* takes effect as soon as the ball is at the kicker */
  memcpy(command, numbers, sizeof numbers);
  memcpy(command + 32, &robot->number, 4);
}

static int read_robots(struct robot *own) {
  int count = u8(144) < MOST_ROBOTS ? u8(144) : MOST_ROBOTS;
  for (int i = 0; i < count; ++i) {
    int offset = 152 + 64 * i;
    own[i].at = point_at(offset);
    own[i].front = point_at(offset + 16);
    own[i].velocity = point_at(offset + 32);
    own[i].number = (int32_t)u32(offset + 56);
  }
  return count;
}

/* Writes one command for each robot. Returns their number. */
static int decide(const struct robot *own, int count, char *commands) {
  double latency = f64(24); /* our commands take effect this much later */
  struct point ball = {f64(56) + f64(72) * latency, f64(64) + f64(80) * latency};
  int play = u8(136), is_ours = play == RUNNING || (u8(137) && play >= KICKOFF);
  double most = play == STOP ? STOP_MPS : SPEED_MPS;
  int chaser = 0; /* the keeper if the ball is in our area, otherwise another robot */
  if (play == HALT) return 0;
  if (!is_in_area(-ball.x, ball.y, 0.0)) chaser = nearest(own, count, ball);
  for (int i = 0; i < count; ++i) {
    struct aim aim = line_up(i, count, ball);
    if (is_ours && i == chaser) aim = attack(&own[i], ball);
    else if (i == 0) aim = guard(ball);
    if (i != 0) aim.at.x = out_of_areas(aim.at.x, aim.at.y);
    if (!is_ours) aim.at = keep_off(&own[i], aim.at, nearest_on_way(&own[i], ball));
    drive(&own[i], aim, most, latency, commands + COMMAND_BYTES * i);
  }
  return count;
}

static void answer(void) {
  static char output[OUTPUT_BYTES + MOST_ROBOTS * COMMAND_BYTES];
  struct robot own[MOST_ROBOTS];
  uint16_t commands = (uint16_t)decide(own, read_robots(own), output + OUTPUT_BYTES);
  uint32_t size = OUTPUT_BYTES + commands * (uint32_t)COMMAND_BYTES;
  uint16_t kind = OUTPUT;
  int32_t keeper = commands > 0 ? own[0].number : 0, leaves = -1;
  memcpy(output, &size, 4);
  memcpy(output + 4, &kind, 2);
  memcpy(output + 8, record + 8, 8); /* the frame's number */
  memcpy(output + 16, &keeper, 4);
  memcpy(output + 20, &leaves, 4);
  memcpy(output + 24, &commands, 2);
  fwrite(output, size, 1, stdout);
  fflush(stdout);
}

static void start(void) {
  length_m = f64(32);
  width_m = f64(40);
  area_depth_m = f64(80);
  area_straight_m = f64(88);
  area_is_box = u32(136) != 0;
}

int main(void) {
  puts("autoref-team 1 flat");
  fflush(stdout);
  while (fread(record, 4, 1, stdin) == 1) {
    if (u32(0) < 8 || u32(0) > sizeof record) return 1;
    if (fread(record + 4, u32(0) - 4, 1, stdin) != 1) return 1;
    if (u16(4) == START) start();
    if (u16(4) == FRAME) answer();
    if (u16(4) == END) return 0;
  }
  return 1;
}
