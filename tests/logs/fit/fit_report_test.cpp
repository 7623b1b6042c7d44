#include "logs/fit/fit_report.hpp"

#include <gtest/gtest.h>

#include "tests/support/has_part.hpp"

namespace autoref::logs {
namespace {

LogFit small_fit() {
  LogFit fit;
  fit.ball = {{"ball", "roll_mps2", {12, Estimated{0.31, 0.30, 0.32}}},
              {"ball", "roll_per_s", {12, Estimated{-0.002, -0.005, 0.001}}},
              {"ball", "hop_first_z", {1, {}}},
              {"contacts", "wall_restitution", {3, {}}}};
  fit.vision = {{"", "frame_rate_hz", {100, Estimated{73.2, 73.2, 73.2}}},
                {"vision", "near_robots_m", {50, Estimated{-0.01, -0.02, 0.01}}}};
  fit.kicker = {{"kicker", "direction_noise_deg", {40, Estimated{2.9, 2.5, 3.3}}}};
  fit.teams = {{"TIGERs Mannheim", {{"robot", "speed_mps", {9, Estimated{2.5, 2.4, 2.6}}}}}};
  fit.cameras[0] = {100, 73.2, {}};
  fit.cameras[1] = {100, 73.2, {0.002, 0.0001}};
  fit.cameras[2] = {100, 73.2, {}};
  fit.camera_height_m = 0.5;
  fit.ball_seen = {{0.09, 100, 63}, {0.11, 0, 0}};
  return fit;
}

TEST(MeasuredYaml, HasNumbersWithTheirIntervals) {
  const std::string yaml = measured_yaml(small_fit(), "Ball of \"x\".");
  EXPECT_TRUE(has(yaml, "kind: measured\nabout: \"Ball of \\\"x\\\".\"\n")) << yaml;
  EXPECT_TRUE(has(yaml, "\nball:\n  roll_mps2: 0.31   # 0.3 to 0.32; 12 seen\n")) << yaml;
  EXPECT_TRUE(has(yaml, "\nframe_rate_hz: 73.2 ")) << yaml;
}

TEST(MeasuredYaml, LeavesOutWhatIsNotEnough) {
  const std::string yaml = measured_yaml(small_fit(), "x");
  EXPECT_TRUE(has(yaml, "\n  # hop_first_z: not enough; 1 seen\n")) << yaml;
  EXPECT_TRUE(has(yaml, "\n# contacts:\n  # wall_restitution: not enough; 3 seen\n")) << yaml;
}

TEST(MeasuredYaml, KeepsNumbersInTheRangesOfTheirSettings) {
  const std::string yaml = measured_yaml(small_fit(), "x");
  EXPECT_TRUE(has(yaml, "\n  roll_per_s: 0   # -0.005 to 0.001; 12 seen\n")) << yaml;
  EXPECT_TRUE(has(yaml, "\n  near_robots_m: 1e-06 ")) << yaml;  // must be above 0
  EXPECT_TRUE(has(yaml, "\n  camera_height_m: 1\n")) << yaml;
  EXPECT_TRUE(has(yaml, "\n  # not simulated: cameras: 3\n")) << yaml;
}

TEST(RobotsYaml, HasTheTeamsRobotsAndAllKicks) {
  const LogFit fit = small_fit();
  const std::string yaml = robots_yaml(fit, fit.teams[0], "x");
  EXPECT_TRUE(has(yaml, "kind: robot\n")) << yaml;
  EXPECT_TRUE(has(yaml, "\nrobot:\n  speed_mps: 2.5 ")) << yaml;
  EXPECT_TRUE(has(yaml, "\nkicker:\n  direction_noise_deg: 2.9 ")) << yaml;
}

// Teams rarely turn as fast as their robots can: the defaults are 15 rad/s and 40 rad/s^2.
TEST(RobotsYaml, HasNoTurningRatesBelowTheDefaults) {
  LogFit fit = small_fit();
  fit.teams[0].robots.push_back({"robot", "angular_speed_radps", {9, Estimated{8, 7.8, 8.2}}});
  fit.teams[0].robots.push_back(
      {"robot", "angular_acceleration_radps2", {9, Estimated{50, 48, 52}}});
  const std::string yaml = robots_yaml(fit, fit.teams[0], "x");
  EXPECT_FALSE(has(yaml, "angular_speed_radps")) << yaml;
  EXPECT_TRUE(has(yaml, "\n  angular_acceleration_radps2: 50 ")) << yaml;
}

TEST(RobotsYaml, LetsTheWheelsAllowWhatWasReached) {
  LogFit fit = small_fit();
  fit.teams[0].robots.push_back({"robot", "braking_mps2", {9, Estimated{4.2, 4, 4.4}}});
  EXPECT_FALSE(has(robots_yaml(fit, fit.teams[0], "x"), "wheel_acceleration_mps2"));
  fit.teams[0].robots.back().estimate.number->value = 5.5;
  EXPECT_TRUE(has(robots_yaml(fit, fit.teams[0], "x"), "\n  wheel_acceleration_mps2: 5.5 "));
}

TEST(FitText, ListsEstimatesDefaultsAndCameras) {
  const std::string text = io::text_of(fit_text(small_fit()), 1000);
  EXPECT_TRUE(has(text, "ball.hop_first_z             not enough")) << text;
  EXPECT_TRUE(has(text, "TIGERs Mannheim")) << text;
  EXPECT_TRUE(has(text, "Camera 1: 100 captures, 73.20 Hz, 2.00 ms after")) << text;
  EXPECT_TRUE(has(text, "centre: 0.09 m 63 %.")) << text;
}

TEST(FileWord, HasOnlyLettersDigitsAndHyphens) {
  EXPECT_EQ(file_word("TIGERs Mannheim"), "tigers-mannheim");
  EXPECT_EQ(file_word("  cobalt (a) "), "cobalt-a");
  EXPECT_EQ(file_word("../../x"), "x");
  EXPECT_EQ(file_word("\xff\xfe"), "team");
  EXPECT_EQ(file_word(std::string(100, 'a')), std::string(40, 'a'));
}

}  // namespace
}  // namespace autoref::logs
