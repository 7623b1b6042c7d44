// A team of one page. Robot 0 stays in the goal, the robot nearest to the ball gets behind it and
// kicks it to the opponents' goal, and the others stand in a row. Our goal is at -x.
//
// It reads flat records and answers each frame with one. Anything else, such as debugging output,
// belongs on stderr. Every number is in metres and seconds.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

constexpr double kSpeed_mps = 2.0;  // of all robots
constexpr double kStop_mps = 0.9;   // while play is stopped: the Laws of 2014 allow 1 m/s
constexpr double kTurn_radps = 8.0;
constexpr double kKick_mps = 5.0;
// Distance to the ball or its path while we may not play it: the rules require 0.5 m to the hull.
constexpr double kTooNear_m = 0.6;
constexpr double kKeepOff_m = 0.65;  // the distance to which robots retreat

enum Play {
  kHalt,
  kStop,
  kPrepareKickoff,
  kPreparePenalty,
  kKickoff,
  kPenalty,
  kDirectFree,
  kIndirectFree,
  kRunning
};

struct Pitch {
  double length = 0;
  double width = 0;
  double area_depth = 0;
  double area_straight = 0;
  bool area_is_box = false;
};

struct Point {
  double x = 0;
  double y = 0;
};

struct Player {
  int number = 0;
  Point at;
  Point front;  // unit vector
  Point velocity;
};

struct Sight {
  std::int64_t frame = 0;
  double latency = 0;
  int play = kHalt;
  bool ours = false;
  Point ball;
  Point ball_velocity;
  bool is_placed = false;
  Point placement;  // the referee's target for the ball, if `is_placed`
  std::vector<Player> own;
};

struct Order {
  int robot = 0;
  double forward = 0;
  double left = 0;
  double turn = 0;
};

struct Aim {
  Point at;
  Point facing;  // unit vector
};

inline Point unit(double x, double y) {
  const double length = std::sqrt(x * x + y * y);
  return length > 0 ? Point{x / length, y / length} : Point{1.0, 0.0};
}

// Whether a point is in the opponents' defence area, approximated by a box; for ours, pass -x.
inline bool is_in_area(const Pitch& pitch, double x, double y, double margin) {
  double half = pitch.area_straight / 2;
  if (!pitch.area_is_box) half = half + pitch.area_depth;
  const double depth = pitch.area_depth + margin;
  return x > pitch.length / 2 - depth && -half - margin < y && y < half + margin;
}

// The nearest x at which a robot is in neither defence area.
inline double out_of_areas(const Pitch& pitch, double x, double y) {
  const double limit = pitch.length / 2 - pitch.area_depth - 0.3;
  if (is_in_area(pitch, x, y, 0.3)) return limit;
  return is_in_area(pitch, -x, y, 0.3) ? -limit : x;
}

inline std::size_t nearest(const std::vector<Player>& own, const Point& ball) {
  std::size_t best = own.size();
  double least = INFINITY;
  for (std::size_t i = 1; i < own.size(); ++i) {
    const double dx = own[i].at.x - ball.x;
    const double dy = own[i].at.y - ball.y;
    if (dx * dx + dy * dy >= least) continue;
    best = i;
    least = dx * dx + dy * dy;
  }
  return best;
}

// Drives through the ball towards the goal, or first to a place behind the ball, or around it.
inline Aim attack(const Player& robot, const Point& ball, const Pitch& pitch) {
  const Point to = unit(pitch.length / 2 - ball.x, -ball.y);
  const double dx = robot.at.x - ball.x;
  const double dy = robot.at.y - ball.y;
  const double ahead = dx * to.x + dy * to.y;
  const double aside = dy * to.x - dx * to.y;
  double back = 0.2;
  double off = aside > 0 ? 0.25 : -0.25;
  if (ahead < -0.05 && -0.04 < aside && aside < 0.04) {
    back = -0.05;
    off = 0.0;
  } else if (ahead < -0.12) {
    back = 0.15;
    off = 0.0;
  }
  return {{ball.x - back * to.x - off * to.y, ball.y - back * to.y + off * to.x}, to};
}

// Stands on the line from the ball to the middle of our goal.
inline Aim guard(const Point& ball, const Pitch& pitch) {
  const double goal_x = -pitch.length / 2;
  const Point to = unit(ball.x - goal_x, ball.y);
  return {{goal_x + 0.1 + 0.2 * to.x, 0.3 * to.y}, to};
}

// Stands in a row across our half, facing the ball.
inline Aim line_up(std::size_t index, std::size_t count, const Point& ball, const Pitch& pitch) {
  const auto i = static_cast<double>(index);
  const auto n = static_cast<double>(count);
  const double x = -pitch.length / 5;
  const double y = (i - n / 2) * pitch.width / (n + 1);
  return {{x, y}, unit(ball.x - x, ball.y - y)};
}

// The point nearest to the robot on the ball's path to the referee's target.
inline Point nearest_on_way(const Player& robot, const Point& ball, const Sight& sight) {
  const Point end = sight.is_placed ? sight.placement : ball;
  const Point way = {end.x - ball.x, end.y - ball.y};
  const double whole = way.x * way.x + way.y * way.y;
  const double along = (robot.at.x - ball.x) * way.x + (robot.at.y - ball.y) * way.y;
  if (along <= 0) return ball;
  if (along >= whole) return end;
  return {ball.x + along / whole * way.x, ball.y + along / whole * way.y};
}

// Moves away from a point if the robot is near it; otherwise goes to the place, but around the
// point.
inline Point keep_off(const Player& robot, Point place, const Point& point) {
  const double dx = robot.at.x - point.x;
  const double dy = robot.at.y - point.y;
  if (dx * dx + dy * dy < kTooNear_m * kTooNear_m) place = robot.at;
  const Point from = unit(dx, dy);
  const double lack = kKeepOff_m - (place.x - point.x) * from.x - (place.y - point.y) * from.y;
  if (lack > 0) place = {place.x + lack * from.x, place.y + lack * from.y};
  return place;
}

// A command that brings the robot to its aim.
inline Order drive(const Player& robot, const Aim& aim, double most, double latency) {
  double vx = 3 * (aim.at.x - robot.at.x - robot.velocity.x * latency);
  double vy = 3 * (aim.at.y - robot.at.y - robot.velocity.y * latency);
  const double speed = std::sqrt(vx * vx + vy * vy);
  if (speed > most) {
    vx = vx / speed * most;
    vy = vy / speed * most;
  }
  const Point& front = robot.front;
  double turn =
      front.x * aim.facing.y - front.y * aim.facing.x;  // the sine of the angle to turn by
  if (front.x * aim.facing.x + front.y * aim.facing.y < 0) turn = turn > 0 ? 1.0 : -1.0;
  return {robot.number, vx * front.x + vy * front.y, vy * front.x - vx * front.y,
          kTurn_radps * turn};
}

inline std::vector<Order> decide(const Sight& sight, const Pitch& pitch) {
  std::vector<Order> orders;
  if (sight.play == kHalt || sight.own.empty()) return orders;
  const double latency = sight.latency;  // our commands take effect this much later
  const Point ball = {sight.ball.x + sight.ball_velocity.x * latency,
                      sight.ball.y + sight.ball_velocity.y * latency};
  const bool is_ours = sight.play == kRunning || (sight.ours && sight.play >= kKickoff);
  const double most = sight.play == kStop ? kStop_mps : kSpeed_mps;
  std::size_t chaser = 0;  // the keeper if the ball is in our area, otherwise another robot
  if (!is_in_area(pitch, -ball.x, ball.y, 0.0)) chaser = nearest(sight.own, ball);
  for (std::size_t i = 0; i < sight.own.size(); ++i) {
    const Player& robot = sight.own[i];
    Aim aim = line_up(i, sight.own.size(), ball, pitch);
    if (is_ours && i == chaser) {
      aim = attack(robot, ball, pitch);
    } else if (i == 0) {
      aim = guard(ball, pitch);
    }
    if (i != 0) aim.at.x = out_of_areas(pitch, aim.at.x, aim.at.y);
    if (!is_ours) aim.at = keep_off(robot, aim.at, nearest_on_way(robot, ball, sight));
    orders.push_back(drive(robot, aim, most, latency));
  }
  return orders;
}

// From here on: reading and writing. The numbers are offsets in the records.

template <typename Number>
Number number_at(const std::vector<char>& record, std::size_t offset) {
  Number number{};
  std::memcpy(&number, record.data() + offset, sizeof number);
  return number;
}

template <typename Number>
void put(Number number, std::vector<char>& record, std::size_t offset) {
  std::memcpy(record.data() + offset, &number, sizeof number);
}

inline Point point_at(const std::vector<char>& record, std::size_t offset) {
  return {number_at<double>(record, offset), number_at<double>(record, offset + 8)};
}

inline Pitch read_start(const std::vector<char>& record) {
  return {number_at<double>(record, 32), number_at<double>(record, 40),
          number_at<double>(record, 80), number_at<double>(record, 88),
          number_at<std::uint32_t>(record, 136) != 0};
}

inline Sight read_frame(const std::vector<char>& record) {
  Sight sight;
  sight.frame = number_at<std::int64_t>(record, 8);
  sight.latency = number_at<double>(record, 24);
  sight.placement = point_at(record, 40);
  sight.ball = point_at(record, 56);
  sight.ball_velocity = point_at(record, 72);
  sight.play = number_at<std::uint8_t>(record, 136);
  sight.ours = number_at<std::uint8_t>(record, 137) != 0;
  sight.is_placed = number_at<std::uint8_t>(record, 138) != 0;
  const std::size_t robots = number_at<std::uint8_t>(record, 144);
  for (std::size_t offset = 152; sight.own.size() < robots; offset += 64) {
    sight.own.push_back({number_at<std::int32_t>(record, offset + 56), point_at(record, offset),
                         point_at(record, offset + 16), point_at(record, offset + 32)});
  }
  return sight;
}

inline std::vector<char> output_of(const Sight& sight, const std::vector<Order>& orders) {
  std::vector<char> record(32 + 40 * orders.size());
  put(static_cast<std::uint32_t>(record.size()), record, 0);
  put(std::uint16_t{4}, record, 4);
  put(sight.frame, record, 8);
  put(orders.empty() ? 0 : orders[0].robot, record, 16);  // the keeper
  put(std::int32_t{-1}, record, 20);
  put(static_cast<std::uint16_t>(orders.size()), record, 24);
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const std::size_t offset = 32 + 40 * i;
    put(orders[i].forward, record, offset);
    put(orders[i].left, record, offset + 8);
    put(orders[i].turn, record, offset + 16);
    put(kKick_mps, record, offset + 24);  // takes effect as soon as the ball is at the kicker
    put(static_cast<std::int32_t>(orders[i].robot), record, offset + 32);
  }
  return record;
}

// Reads the next record. Returns false at the end of the input.
inline bool read_record(std::vector<char>& record) {
  std::uint32_t length = 0;
  if (std::fread(&length, sizeof length, 1, stdin) != 1) return false;
  record.resize(length);
  put(length, record, 0);
  return std::fread(record.data() + 4, length - 4, 1, stdin) == 1;
}

int main() {
  std::puts("autoref-team 1 flat");
  std::fflush(stdout);
  Pitch pitch;
  std::vector<char> record;
  while (read_record(record)) {
    const auto kind = number_at<std::uint16_t>(record, 4);
    if (kind == 1) pitch = read_start(record);
    if (kind == 3) return 0;  // the game has ended
    if (kind != 2) continue;
    const Sight sight = read_frame(record);
    const std::vector<char> output = output_of(sight, decide(sight, pitch));
    std::fwrite(output.data(), output.size(), 1, stdout);
    std::fflush(stdout);
  }
  return 1;
}
