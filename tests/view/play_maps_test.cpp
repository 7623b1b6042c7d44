#include "view/play_maps.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace autoref::view {
namespace {

// The field of the rules of 2026, division B: 9 m x 6 m.
Field division_b() {
  Field field;
  field.length_m = 9;
  field.width_m = 6;
  return field;
}

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

// The values of an attribute in the elements with this name, in order.
std::vector<std::string> values_of(const std::string& svg, const std::string& element,
                                   const std::string& attribute) {
  std::vector<std::string> values;
  const std::regex pattern("<" + element + " [^>]*" + attribute + "=\"([^\"]*)\"");
  for (std::sregex_iterator found(svg.begin(), svg.end(), pattern), end; found != end; ++found)
    values.push_back((*found)[1]);
  return values;
}

MappedTeam team_of(const std::string& name, int games) { return {name, games, {}, {}, {}}; }

TEST(ShotMap, DrawsADotWhoseAreaIsProportionalToTheXgOfEachShot) {
  MappedTeam team = team_of("bold", 2);
  team.shots = {{{3, 0.5}, 0.16, false}, {{4, -1}, 0.64, true}};
  const std::string svg = shot_map(division_b(), {team});
  const std::vector<std::string> x = values_of(svg, "circle", "cx");
  // The marks of the field are discs, too; shots are drawn after them.
  ASSERT_GE(x.size(), 2U);
  const std::vector<std::string> radii = values_of(svg, "circle", "r");
  EXPECT_EQ(x[x.size() - 2], "3000");
  EXPECT_EQ(x[x.size() - 1], "4000");
  EXPECT_EQ(std::stod(radii.back()), 2 * std::stod(radii[radii.size() - 2]));
  EXPECT_NE(svg.find("games: 2, shots: 2, xG: 0.8, scored: 1"), std::string::npos) << svg;
}

TEST(ShotMap, DrawsGoalsLastSoThatTheyStayVisible) {
  MappedTeam team = team_of("bold", 1);
  team.shots = {{{1, 0}, 0.5, true}, {{2, 0}, 0.1, false}, {{3, 0}, 0.2, false}};
  const std::vector<std::string> x = values_of(shot_map(division_b(), {team}), "circle", "cx");
  ASSERT_GE(x.size(), 3U);
  EXPECT_EQ(std::vector<std::string>(x.end() - 3, x.end()),
            (std::vector<std::string>{"3000", "2000", "1000"}));
}

TEST(ChainMap, LeavesOutSquaresWithFewChains) {
  MappedTeam team = team_of("bold", 1);
  const auto add = [&](int count, const Vec2& first_m, const Vec2& last_m) {
    for (int i = 0; i < count; ++i) team.chains.push_back({first_m, last_m, 0});
  };
  const int empty = count_of(chain_map(division_b(), {team}), "<circle");
  add(2, {-3.9, 2.1}, {0, 0});
  EXPECT_EQ(count_of(chain_map(division_b(), {team}), "<circle"), empty);
  add(1, {-3.6, 2.9}, {0, 0});  // in the same square, from (-4.5, 2) on
  EXPECT_EQ(count_of(chain_map(division_b(), {team}), "<circle"), empty + 1);
}

// The arrow's tip; the arrow is drawn last.
TEST(ChainMap, PointsFromTheMeanStartToTheMeanEnd) {
  MappedTeam team = team_of("bold", 1);
  team.chains = {{{0.1, 0.1}, {2, 1}, 0}, {{0.2, 0.2}, {3, 1}, 0}, {{0.3, 0.3}, {4, 1}, 0}};
  const std::vector<std::string> paths = values_of(chain_map(division_b(), {team}), "path", "d");
  ASSERT_GE(paths.size(), 2U);
  EXPECT_TRUE(paths[paths.size() - 2].starts_with("M 200 -200 ")) << paths[paths.size() - 2];
  EXPECT_NE(paths.back().find(" L 3000 -1000 "), std::string::npos) << paths.back();
}

// Teams are compared per game: half as many losses in half as many games look the same.
TEST(LossMap, SharesItsScaleAmongTheTeams) {
  MappedTeam one = team_of("one", 2);
  one.losses_m = {{1.1, 1.1}, {1.2, 1.2}};
  MappedTeam other = team_of("other", 1);
  other.losses_m = {{1.1, 1.1}};
  MappedTeam rare = team_of("rare", 4);
  rare.losses_m = {{1.1, 1.1}};
  const std::vector<std::string> fills =
      values_of(loss_map(division_b(), {one, other, rare}), "rect", "fill");
  // Of each panel, the pitch comes before the squares; the first is the background.
  ASSERT_EQ(fills.size(), 1U + 3 * 2);
  EXPECT_EQ(fills[2], fills[4]);
  // From pale to dark, a quarter of the way.
  const auto red = [](const std::string& fill) {
    return std::stoi(fill.substr(1, 2), nullptr, 16);
  };
  EXPECT_NEAR(red(fills[6]), 222 - 0.25 * (222 - red(fills[2])), 1);
}

TEST(LossMap, CountsBallsBeyondTheLinesInTheNearestSquare) {
  MappedTeam team = team_of("bold", 1);
  team.losses_m = {{4.6, 3.2}};
  const std::string svg = loss_map(division_b(), {team});
  EXPECT_EQ(values_of(svg, "rect", "x").back(), "4000");
  EXPECT_EQ(values_of(svg, "rect", "y").back(), "-3000");
}

// The right ends of texts, by their font sizes, are left of the drawing's right end.
TEST(PlayMaps, HaveRoomForTheirTexts) {
  for (const std::size_t panels : {1U, 2U}) {
    const std::vector<MappedTeam> teams(panels, team_of(std::string(70, 'm'), 1000));
    for (const auto& draw : {shot_map, chain_map, loss_map}) {
      const std::string svg = draw(division_b(), teams);
      const std::regex box("viewBox=\"0 [^ ]* ([0-9]+)");
      std::smatch found;
      ASSERT_TRUE(std::regex_search(svg, found, box));
      const double width_mm = std::stod(found[1]) / static_cast<double>(panels);
      const std::vector<std::string> sizes = values_of(svg, "text", "font-size");
      const std::regex texts(">([^<]+)</text>");
      std::size_t i = 0;
      for (std::sregex_iterator text(svg.begin(), svg.end(), texts), end; text != end;
           ++text, ++i) {
        const bool is_legend = i + 1 == sizes.size();
        const double letters = static_cast<double>((*text)[1].length());
        EXPECT_LE(0.6 * letters * std::stod(sizes.at(i)),
                  width_mm * (is_legend ? static_cast<double>(panels) : 1.0))
            << (*text)[1];
      }
      EXPECT_EQ(i, sizes.size());
    }
  }
}

TEST(PlayMaps, HaveAPanelForEachTeam) {
  const std::vector<MappedTeam> teams = {team_of("a<b", 1), team_of("zone", 1), team_of("x", 1)};
  for (const auto& draw : {shot_map, chain_map, loss_map}) {
    const std::string svg = draw(division_b(), teams);
    EXPECT_EQ(count_of(svg, "translate("), 3);
    EXPECT_NE(svg.find("a&lt;b"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
  }
}

}  // namespace
}  // namespace autoref::view
