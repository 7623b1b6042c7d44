// The checks that every TeamOutput passes, whatever its encoding.
#pragma once

#include <bitset>
#include <cstdint>
#include <string_view>

#include "league/team/team_messages.hpp"

namespace autoref::league {

// Fills a TeamOutput with the data that a program sent. Its functions throw TeamFault for numbers
// that are not finite or out of range, for robots that do not exist, and for a second command to a
// robot.
class OutputBuilder {
 public:
  // Largest magnitudes of commands; robots are far slower.
  static constexpr double kFastest_mps = 100;
  static constexpr double kFastest_radps = 1000;

  explicit OutputBuilder(TeamOutput& output);

  void set_frame(std::int64_t frame);
  void set_keeper(std::int64_t number);  // -1 if the keeper is unknown
  void set_leaves(std::int64_t number);
  void set_timeout(bool is_requested) { output_->requests.timeout = is_requested; }
  void set_text(std::string_view text);
  void add_command(std::int64_t robot, const RobotCommand& command);

 private:
  TeamOutput* output_;
  std::bitset<kMaxRobots> commanded_;
};

}  // namespace autoref::league
