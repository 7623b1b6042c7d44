// The compiled half of the Python package: games that run in the caller's process
// (autoref/game.py).
#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "game/loop/event_log.hpp"
#include "game/loop/game.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "game/team_programs/program_games.hpp"
#include "io/build_id.hpp"
#include "io/checksum.hpp"

namespace py = pybind11;

namespace autoref::python {
namespace {

using game::GameConfiguration;
using game::GameRecord;
using game::GameSettings;
using strategies::Strategy;

constexpr double kFastestBall_mps = 20;  // far above the speed of any kick
// Number of values in a row of View.own: number, x, y, heading, ...
constexpr std::size_t kRobotNumbers = 8;
constexpr std::size_t kBallNumbers = 5;     // x, y, vx, vy, height
constexpr std::size_t kCommandNumbers = 6;  // vx, vy, angular velocity, kick, chip, dribble

using RobotRows = std::array<std::array<double, kRobotNumbers>, kMaxRobots>;
using Commands = py::array_t<double, py::array::c_style | py::array::forcecast>;

// A team's view as an array of values. The arrays in Python refer to these values.
struct View {
  TeamView seen;
  RobotRows own{};
  RobotRows opponents{};
  std::array<double, kBallNumbers> ball{};
};

void fill(const TrackedRobots& robots, RobotRows& rows) {
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const TrackedRobot& r = robots[i];
    rows[i] = {static_cast<double>(r.number),
               r.position_m.x(),
               r.position_m.y(),
               r.heading.x(),
               r.heading.y(),
               r.velocity_mps.x(),
               r.velocity_mps.y(),
               r.angular_velocity_radps};
  }
}

void fill(const TeamView& seen, View& view) {
  view.seen = seen;
  fill(seen.own, view.own);
  fill(seen.opponents, view.opponents);
  const TrackedBall& ball = seen.ball;
  view.ball = {ball.position_m.x(), ball.position_m.y(), ball.velocity_mps.x(),
               ball.velocity_mps.y(), ball.height_m};
}

// A team whose decisions the caller makes.
struct External {
  View view;
  TeamCommands commands{};
};

class ExternalTeam final : public Strategy {
 public:
  explicit ExternalTeam(External& external) : external_(&external) {}
  void prepare(const TeamView& view) override { fill(view, external_->view); }
  void decide(const TeamView& /*view*/, TeamCommands& commands) override {
    commands = external_->commands;
  }

 private:
  External* external_;
};

TeamCommands commands_in(const Commands& rows, char team) {
  const std::string what = fmt::format("commands of team {}", team);
  if (rows.ndim() != 2 || rows.shape(1) != static_cast<py::ssize_t>(kCommandNumbers) ||
      rows.shape(0) > kMaxRobots) {
    throw py::value_error(
        what + " must be an array (robots, 6): vx, vy, angular velocity, kick, chip, dribble");
  }
  TeamCommands commands{};
  const auto at = rows.unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    RobotCommand& command = commands[static_cast<std::size_t>(i)];
    command = {Vec2(at(i, 0), at(i, 1)), at(i, 2), std::max(at(i, 3), 0.0), at(i, 4) > 0.5,
               at(i, 5) > 0.5};
    if (!is_finite(command) || std::isnan(at(i, 4)) || std::isnan(at(i, 5)))
      throw py::value_error(fmt::format("{}: robot {} has a number that is not finite", what, i));
  }
  return commands;
}

std::string text_of(const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  return py::str(value).cast<std::string>();
}

GameSettings settings_in(std::uint64_t seed, const py::dict& settings) {
  GameSettings game;
  game.seed = seed;
  for (const auto& [path, value] : settings) {
    const auto name = py::str(path).cast<std::string>();
    try {
      game::set_by_path(game, name, text_of(value));
    } catch (const std::exception& error) {
      throw py::value_error(name + ": " + error.what());
    }
  }
  try {
    game::check_game(game);
  } catch (const std::exception& error) {
    throw py::value_error(error.what());
  }
  return game;
}

class PythonGame {
 public:
  explicit PythonGame(const std::string& external) {
    for (const char team : external) {
      if (team != 'a' && team != 'b') throw py::value_error("external must be 'a', 'b' or 'ab'");
      is_external_[index_of(team)] = true;
    }
  }

  void reset(std::uint64_t seed, const py::dict& settings) {
    const GameConfiguration game = game::resolved(settings_in(seed, settings));
    externals_ = {};
    lines_.clear();
    events_ = game::event_game_of(game);
    game_.emplace(game, &observer_, maker(game.match.a_plays));
    is_played_ = game_->begin_step();
  }

  bool step(const std::optional<Commands>& a, const std::optional<Commands>& b) {
    set_commands('a', a);
    set_commands('b', b);
    game::Game& game = playing();
    if (!is_played_) return false;
    lines_.clear();
    is_played_ = game.end_step() && game.begin_step();
    return is_played_;
  }

  // Continues the game with the commands given last. Returns the number of frames played.
  std::int64_t run(std::int64_t most_frames) {
    const std::int64_t before = playing().record().frames;
    for (std::int64_t i = 0; i < most_frames && is_played_; ++i) {
      lines_.clear();
      is_played_ = game_->end_step() && game_->begin_step();
    }
    return game_->record().frames - before;
  }

  View& view(char team) {
    playing();
    if (!is_external_[index_of(team)])
      throw py::value_error(fmt::format("team {} is not external, so it has no view", team));
    return externals_[index_of(team)].view;
  }

  void place_ball(double x, double y, double vx, double vy) {
    sim::BallState ball;
    ball.position_m = Vec2(x, y);
    ball.velocity_mps = Vec2(vx, vy);
    check(ball.position_m, "ball");
    if (!is_finite(ball.velocity_mps) || ball.velocity_mps.norm() > kFastestBall_mps)
      throw py::value_error(
          fmt::format("the ball's velocity must be at most {} m/s", kFastestBall_mps));
    playing().put_ball(ball);
  }

  void place_robot(char team, int number, const std::array<double, 4>& at) {
    if (team != 'a' && team != 'b')
      throw py::value_error(fmt::format("unknown team '{}'; expected 'a' or 'b'", team));
    const Side a = playing().configuration().match.a_plays;
    const RobotId id{team == 'a' ? a : opponent_of(a), number};
    const auto& robots = playing().world().state().robots[id.side];
    if (std::none_of(robots.begin(), robots.end(),
                     [number](const sim::RobotState& robot) { return robot.number == number; }))
      throw py::value_error(fmt::format("robot {} of team {} is not on the field", number, team));
    sim::RobotState state;
    state.number = number;
    state.position_m = Vec2(at[0], at[1]);
    check(state.position_m, "robot");
    const double length = std::hypot(at[2], at[3]);
    if (!(length > 0) || !std::isfinite(length))
      throw py::value_error("a heading must not be zero");
    state.heading = Vec2(at[2], at[3]) / length;
    playing().put_robot(id, state);
  }

  py::dict record() {
    const GameRecord record = playing().record();
    py::dict entries;
    entries["goals_a"] = record.goals_a;
    entries["goals_b"] = record.goals_b;
    entries["status"] = std::string(name_of(record.status));
    entries["end_reason"] = std::string(name_of(record.end_reason));
    entries["void_reason"] = record.void_reason;
    entries["frames"] = record.frames;
    entries["sim_s"] = record.sim_s;
    entries["state_hash"] = io::hash_text(record.state_hash);
    return entries;
  }

  const std::vector<std::string>& decisions() const { return lines_; }
  bool is_over() const { return game_ && !is_played_; }
  double frame_rate_hz() { return playing().configuration().sim.frame_rate_hz; }
  std::pair<double, double> field_m() {
    const Field& field = playing().configuration().field;
    return {field.length_m, field.width_m};
  }
  double goal_width_m() { return playing().configuration().field.goal_width_m; }

 private:
  class Lines final : public game::Observer {
   public:
    explicit Lines(PythonGame& game) : game_(&game) {}
    void on_decision(const referee::Decision& decision) override {
      game_->lines_.push_back(game::decision_json(decision, game_->events_));
    }

   private:
    PythonGame* game_;
  };

  static std::size_t index_of(char team) { return team == 'a' ? 0 : 1; }

  // A position is valid if it is between the walls.
  void check(const Vec2& position_m, const char* what) {
    const Field& field = playing().configuration().field;
    if (is_finite(position_m) && std::abs(position_m.x()) <= field.wall_x_m() &&
        std::abs(position_m.y()) <= field.wall_y_m())
      return;
    throw py::value_error(
        fmt::format("the {} must be put between the walls, |x| <= {} m and |y| <= {} m", what,
                    field.wall_x_m(), field.wall_y_m()));
  }

  game::Game& playing() {
    if (!game_) throw py::value_error("call reset() first");
    return *game_;
  }

  void set_commands(char team, const std::optional<Commands>& rows) {
    if (!rows) {
      externals_[index_of(team)].commands = {};
      return;
    }
    if (!is_external_[index_of(team)])
      throw py::value_error(fmt::format("team {} is not external: it decides for itself", team));
    externals_[index_of(team)].commands = commands_in(*rows, team);
  }

  game::TeamMaker maker(Side side_a) {
    return [this, side_a](const game::TeamConfiguration& team,
                          const strategies::TeamContext& context) -> std::unique_ptr<Strategy> {
      const std::size_t index = context.side == side_a ? 0 : 1;
      if (!is_external_[index]) return game::make_program_or_registered_team(team, context);
      return std::make_unique<ExternalTeam>(externals_[index]);
    };
  }

  std::array<bool, 2> is_external_{};
  std::array<External, 2> externals_;
  game::EventGame events_;
  std::vector<std::string> lines_;
  Lines observer_{*this};
  std::optional<game::Game> game_;
  bool is_played_ = false;
};

// An array that refers to values owned by `owner`.
py::array_t<double> rows_of(RobotRows& rows, std::size_t count, const py::object& owner) {
  return py::array_t<double>({count, kRobotNumbers}, rows[0].data(), owner);
}

void define_view(py::module_& module) {
  py::class_<View>(module, "View")
      .def_property_readonly("own",
                             [](const py::object& self) {
                               auto& view = self.cast<View&>();
                               return rows_of(view.own, view.seen.own.size(), self);
                             })
      .def_property_readonly("opponents",
                             [](const py::object& self) {
                               auto& view = self.cast<View&>();
                               return rows_of(view.opponents, view.seen.opponents.size(), self);
                             })
      .def_property_readonly("ball",
                             [](const py::object& self) {
                               auto& view = self.cast<View&>();
                               return py::array_t<double>({kBallNumbers}, view.ball.data(), self);
                             })
      .def_property_readonly("frame", [](const View& view) { return view.seen.frame; })
      .def_property_readonly("time_s", [](const View& view) { return view.seen.time_s; })
      .def_property_readonly("latency_s", [](const View& view) { return view.seen.latency_s; })
      .def_property_readonly("play",
                             [](const View& view) { return std::string(name_of(view.seen.play)); })
      .def_property_readonly("ours", [](const View& view) { return view.seen.ours; })
      .def_property_readonly("goals_own", [](const View& view) { return view.seen.goals_own; })
      .def_property_readonly("goals_opponent",
                             [](const View& view) { return view.seen.goals_opponent; })
      .def_property_readonly("stage_time_left_s",
                             [](const View& view) { return view.seen.stage_time_left_s; });
}

void define_game(py::module_& module) {
  const auto a_or_none = py::arg("a") = py::none();
  const auto b_or_none = py::arg("b") = py::none();
  py::class_<PythonGame>(module, "Game")
      .def(py::init<const std::string&>(), py::arg("external"))
      .def("reset", &PythonGame::reset, py::arg("seed"), py::arg("settings"))
      .def("step", &PythonGame::step, a_or_none, b_or_none)
      .def("run", &PythonGame::run, py::arg("most_frames"))
      .def("view", &PythonGame::view, py::return_value_policy::reference_internal)
      .def("place_ball", &PythonGame::place_ball)
      .def("place_robot", &PythonGame::place_robot)
      .def("record", &PythonGame::record)
      .def("decisions", &PythonGame::decisions)
      .def_property_readonly("is_over", &PythonGame::is_over)
      .def_property_readonly("frame_rate_hz", &PythonGame::frame_rate_hz)
      .def_property_readonly("field_m", &PythonGame::field_m)
      .def_property_readonly("goal_width_m", &PythonGame::goal_width_m);
}

}  // namespace
}  // namespace autoref::python

PYBIND11_MODULE(_core, module) {
  module.attr("build") = std::string(autoref::io::build_id());
  autoref::python::define_view(module);
  autoref::python::define_game(module);
}
