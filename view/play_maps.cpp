#include "view/play_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "io/table.hpp"
#include "view/field_marks.hpp"
#include "view/svg.hpp"

namespace autoref::view {
namespace {

constexpr double kMargin_m = 0.4;  // around the field, for the goals
constexpr std::size_t kColumns = 2;
// Fractions of a panel's width.
constexpr double kHeadHeight = 0.12;    // above a panel, for its name and note
constexpr double kLegendHeight = 0.07;  // below all panels
constexpr double kNameSize = 0.042;     // font sizes
constexpr double kNoteSize = 0.03;
constexpr double kNameAbove = 0.055;  // heights of the baselines above the panel
constexpr double kNoteAbove = 0.012;

constexpr double kSureGoal_m = 0.3;  // radius of a shot whose xG is 1
constexpr double kSmallestDot_m = 0.02;

constexpr double kChainSquare_m = 1;
constexpr std::size_t kFewestChains = 3;  // that a square needs to be drawn
constexpr double kLargestDot_m = 0.42;    // radius

constexpr double kLossSquare_m = 0.5;

constexpr const char* kInk = "#17302a";
constexpr const char* kGoalColour = "#e8590c";
constexpr const char* kShotColour = "#1971c2";

struct Rgb {
  double red = 0;
  double green = 0;
  double blue = 0;
};
constexpr Rgb kPale{222, 226, 240};
constexpr Rgb kDark{94, 23, 135};

// The colour between pale and dark for a share from 0 to 1.
std::string shade(double share) {
  const auto mix = [share](double from, double to) {
    return std::lround(from + std::clamp(share, 0.0, 1.0) * (to - from));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(kPale.red, kDark.red),
                     mix(kPale.green, kDark.green), mix(kPale.blue, kDark.blue));
}

// Where panels are drawn. Each has its own frame, whose origin is the field's centre.
class Layout {
 public:
  Layout(const Field& field, std::size_t panels)
      : half_m_(field.half_length_m() + kMargin_m, field.half_width_m() + kMargin_m),
        columns_(std::min(panels, kColumns)),
        rows_((panels + columns_ - 1) / columns_) {}

  double width_m() const { return 2 * half_m_.x(); }
  double row_height_m() const { return 2 * half_m_.y() + kHeadHeight * width_m(); }
  const Vec2& half_m() const { return half_m_; }

  Vec2 min_m() const { return {0, -static_cast<double>(rows_) * row_height_m() - legend_m()}; }
  Vec2 max_m() const { return {static_cast<double>(columns_) * width_m(), 0}; }

  Vec2 centre_m(std::size_t panel) const {
    const std::size_t row = panel / columns_;
    return {static_cast<double>(panel % columns_) * width_m() + half_m_.x(),
            -static_cast<double>(row + 1) * row_height_m() + half_m_.y()};
  }
  Vec2 legend_at_m() const { return {kMargin_m, min_m().y() + legend_m() / 3}; }

 private:
  double legend_m() const { return kLegendHeight * width_m(); }

  Vec2 half_m_;
  std::size_t columns_;
  std::size_t rows_;
};

// Writes a line, smaller if it is wider than `width_m`.
void write(Svg& svg, const Vec2& at_m, const std::string& text, double size_m, double width_m,
           const char* more) {
  const double letters = std::max(1.0, static_cast<double>(io::width_of(text)));
  size_m = std::min(size_m, width_m / (kLetterWidth * letters));
  svg.text(at_m, text,
           fmt::format(R"(fill="{}" font-size="{:.0f}" {})", kInk, size_m * 1000, more));
}

void draw_pitch(const Field& field, Svg& svg) {
  const Vec2 half_m(field.half_length_m(), field.half_width_m());
  svg.box(-half_m, half_m, R"(fill="#eef4f0")");
}

// Drawn over what fills squares.
void draw_marks(const Field& field, Svg& svg) {
  svg.begin_group(R"(fill="none" stroke="#8fa99b" stroke-width="25")");
  svg.outline(field_lines(field));
  for (const Side end : kSides) {
    const Vec2 post_m = field.goal_centre_m(end) + Vec2(0, field.half_goal_m());
    const Vec2 back_m(goal_sign(end) * field.goal_depth_m, 0);
    const Vec2 across_m(0, -2 * field.half_goal_m());
    svg.line(
        std::array<Vec2, 4>{post_m, post_m + back_m, post_m + back_m + across_m, post_m + across_m},
        R"(stroke="#4f6b5d")");
  }
  svg.end_group();
}

struct Panel {
  std::string note;                // below the team's name
  std::function<void(Svg&)> fill;  // under the field's lines
  std::function<void(Svg&)> draw;  // over the field's lines
};

std::string map_of(const Field& field, const std::vector<MappedTeam>& teams,
                   const std::function<Panel(std::size_t team)>& panel_of,
                   const std::string& legend) {
  const Layout layout(field, teams.size());
  const double width_m = layout.width_m();
  const double text_m = width_m - 2 * kMargin_m;
  Svg svg(layout.min_m(), layout.max_m());
  svg.box(layout.min_m(), layout.max_m(), R"(fill="#ffffff")");
  svg.begin_group(kSvgFont);
  for (std::size_t i = 0; i < teams.size(); ++i) {
    const Panel panel = panel_of(i);
    svg.begin_group_at(layout.centre_m(i));
    draw_pitch(field, svg);
    if (panel.fill) panel.fill(svg);
    draw_marks(field, svg);
    if (panel.draw) panel.draw(svg);
    const Vec2 head_m(-layout.half_m().x() + kMargin_m, layout.half_m().y());
    write(svg, head_m + Vec2(0, kNameAbove * width_m), teams[i].name, kNameSize * width_m, text_m,
          R"(font-weight="bold")");
    write(svg, head_m + Vec2(0, kNoteAbove * width_m), panel.note, kNoteSize * width_m, text_m, "");
    svg.end_group();
  }
  write(svg, layout.legend_at_m(), legend, kNoteSize * width_m, layout.max_m().x() - 2 * kMargin_m,
        "");
  svg.end_group();
  return svg.text();
}

// The position of a square, counted from the field's corner at negative x and y.
using Square = std::pair<int, int>;

class Squares {
 public:
  Squares(const Field& field, double side_m)
      : side_m_(side_m),
        half_m_(field.half_length_m(), field.half_width_m()),
        columns_(number(half_m_.x())),
        rows_(number(half_m_.y())) {}

  // The square that contains a point; the nearest square if the point is not on the field.
  Square at(const Vec2& point_m) const {
    return {index(point_m.x() + half_m_.x(), columns_), index(point_m.y() + half_m_.y(), rows_)};
  }
  Vec2 min_m(const Square& square) const {
    return Vec2(square.first * side_m_, square.second * side_m_) - half_m_;
  }
  // Squares at the far ends may be cut off by the field's lines.
  Vec2 max_m(const Square& square) const {
    return (min_m(square) + Vec2(side_m_, side_m_)).cwiseMin(half_m_);
  }
  Vec2 centre_m(const Square& square) const { return (min_m(square) + max_m(square)) / 2; }

 private:
  int number(double half_m) const {
    return std::max(1, static_cast<int>(std::ceil(2 * half_m / side_m_ - 1e-9)));
  }
  int index(double distance_m, int count) const {
    return static_cast<int>(std::clamp(std::floor(distance_m / side_m_), 0.0, count - 1.0));
  }

  double side_m_;
  Vec2 half_m_;
  int columns_;
  int rows_;
};

// The chains that began in a square.
struct ChainsFromSquare {
  std::size_t count = 0;
  Vec2 first_m{0, 0};  // sums
  Vec2 last_m{0, 0};
  double xg = 0;

  double mean_xg() const { return xg / static_cast<double>(count); }
};
using ChainSquares = std::map<Square, ChainsFromSquare>;

ChainSquares chain_squares(const Squares& squares, const MappedTeam& team) {
  ChainSquares all;
  for (const MappedChain& chain : team.chains) {
    ChainsFromSquare& one = all[squares.at(chain.first_m)];
    ++one.count;
    one.first_m += chain.first_m;
    one.last_m += chain.last_m;
    one.xg += chain.xg;
  }
  std::erase_if(all, [](const auto& entry) { return entry.second.count < kFewestChains; });
  return all;
}

void draw_arrow(const Vec2& from_m, const Vec2& to_m, Svg& svg) {
  constexpr double kArrowHead_m = 0.16;
  const Vec2 path_m = to_m - from_m;
  const double length_m = path_m.norm();
  if (length_m < kArrowHead_m) return;
  const Vec2 along = path_m / length_m;
  const Vec2 neck_m = to_m - kArrowHead_m * along;
  const Vec2 across_m = 0.4 * kArrowHead_m * Vec2(-along.y(), along.x());
  svg.line(std::array<Vec2, 2>{from_m, neck_m},
           fmt::format(R"(fill="none" stroke="{}" stroke-width="28" stroke-opacity="0.75")", kInk));
  svg.line(std::array<Vec2, 3>{neck_m + across_m, to_m, neck_m - across_m},
           fmt::format(R"(fill="{}" fill-opacity="0.75")", kInk));
}

// The largest value of `value_of` over all squares of all teams.
template <typename SquaresOfTeam, typename ValueOf>
double largest(const std::vector<SquaresOfTeam>& teams, const ValueOf& value_of) {
  double most = 0;
  for (std::size_t i = 0; i < teams.size(); ++i)
    for (const auto& [square, content] : teams[i]) most = std::max(most, value_of(i, content));
  return most;
}

double per_game(std::size_t count, const MappedTeam& team) {
  return static_cast<double>(count) / team.games;
}

double share_of(double value, double most) { return most > 0 ? value / most : 0; }

Panel shots_panel(const MappedTeam& team) {
  std::vector<MappedShot> shots = team.shots;
  double xg = 0;
  for (const MappedShot& shot : shots) xg += shot.xg;
  const auto scored = std::count_if(shots.begin(), shots.end(),
                                    [](const MappedShot& shot) { return shot.has_scored; });
  // Shots that scored come last, and small dots after large ones, so that they stay visible.
  std::stable_sort(shots.begin(), shots.end(), [](const MappedShot& one, const MappedShot& other) {
    return std::pair(one.has_scored, -one.xg) < std::pair(other.has_scored, -other.xg);
  });
  const auto draw = [shots](Svg& svg) {
    for (const MappedShot& shot : shots) {
      svg.disc(
          shot.from_m, std::max(kSmallestDot_m, kSureGoal_m * std::sqrt(shot.xg)),
          fmt::format(R"(fill="{}" fill-opacity="{}")", shot.has_scored ? kGoalColour : kShotColour,
                      shot.has_scored ? 0.8 : 0.35));
    }
  };
  return {fmt::format("games: {}, shots: {}, xG: {:.1f}, scored: {}", team.games, shots.size(), xg,
                      scored),
          {},
          draw};
}

}  // namespace

std::string shot_map(const Field& field, const std::vector<MappedTeam>& teams) {
  return map_of(
      field, teams, [&teams](std::size_t i) { return shots_panel(teams[i]); },
      "Area of a dot: expected goals (xG). Orange: shots that scored. Each team attacks to the "
      "right.");
}

std::string chain_map(const Field& field, const std::vector<MappedTeam>& teams) {
  const Squares squares(field, kChainSquare_m);
  std::vector<ChainSquares> chains;
  chains.reserve(teams.size());
  for (const MappedTeam& team : teams) chains.push_back(chain_squares(squares, team));
  const double most = largest(chains, [&](std::size_t i, const ChainsFromSquare& one) {
    return per_game(one.count, teams[i]);
  });
  const double best_xg =
      largest(chains, [](std::size_t, const ChainsFromSquare& one) { return one.mean_xg(); });
  const auto panel_of = [&](std::size_t i) -> Panel {
    const MappedTeam& team = teams[i];
    const auto draw = [&, i](Svg& svg) {
      for (const auto& [square, one] : chains[i]) {
        svg.disc(squares.centre_m(square),
                 kLargestDot_m * std::sqrt(share_of(per_game(one.count, teams[i]), most)),
                 fmt::format(R"(fill="{}")", shade(share_of(one.mean_xg(), best_xg))));
      }
      for (const auto& [square, one] : chains[i]) {
        const auto count = static_cast<double>(one.count);
        draw_arrow(one.first_m / count, one.last_m / count, svg);
      }
    };
    double xg = 0;
    for (const MappedChain& chain : team.chains) xg += chain.xg;
    return {fmt::format("games: {}, chains per game: {:.1f}, xG per game: {:.2f}", team.games,
                        per_game(team.chains.size(), team), xg / team.games),
            {},
            draw};
  };
  return map_of(field, teams, panel_of,
                fmt::format("Chains that began in a square: dots up to {:.2f} per game; mean xG "
                            "from 0 (pale) to {:.2f} (dark); arrows to their mean end.",
                            most, best_xg));
}

std::string loss_map(const Field& field, const std::vector<MappedTeam>& teams) {
  const Squares squares(field, kLossSquare_m);
  std::vector<std::map<Square, std::size_t>> losses(teams.size());
  for (std::size_t i = 0; i < teams.size(); ++i)
    for (const Vec2& loss_m : teams[i].losses_m) ++losses[i][squares.at(loss_m)];
  const double most =
      largest(losses, [&](std::size_t i, std::size_t count) { return per_game(count, teams[i]); });
  const auto panel_of = [&](std::size_t i) -> Panel {
    const MappedTeam& team = teams[i];
    const auto fill = [&, i](Svg& svg) {
      for (const auto& [square, count] : losses[i]) {
        svg.box(squares.min_m(square), squares.max_m(square),
                fmt::format(R"(fill="{}")", shade(share_of(per_game(count, teams[i]), most))));
      }
    };
    return {fmt::format("games: {}, losses per game: {:.1f}", team.games,
                        per_game(team.losses_m.size(), team)),
            fill,
            {}};
  };
  return map_of(field, teams, panel_of,
                fmt::format("Where the ball was lost: up to {:.2f} losses per game (dark) in a "
                            "square of {} m. Each team attacks to the right.",
                            most, kLossSquare_m));
}

}  // namespace autoref::view
