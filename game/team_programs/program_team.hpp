// A team that runs as a separate program.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "game/team_programs/program_process.hpp"
#include "league/team/greeting.hpp"
#include "league/team/team_codec.hpp"
#include "strategies/strategy.hpp"

namespace autoref::game {

// The program was killed from outside, so it is not to blame.
class ProgramKilled : public strategies::StrategyFault {
 public:
  using StrategyFault::StrategyFault;
};

// Plays by the program's commands (docs/team-programs.md), as transmitted() sends them to robots.
// The constructor starts the program; the destructor ends it and all processes that it started. If
// the program has any fault, decide() throws a strategies::StrategyFault, which is a ProgramKilled
// if the program was killed from outside. decide() can also throw InputOutputError
// (program_process.hpp).
class ProgramTeam final : public strategies::Strategy {
 public:
  ProgramTeam(const ProgramSpec& spec, const strategies::TeamContext& context);

  bool has_sensors() const override { return true; }
  void sense(const strategies::SensorReadings& readings) override;
  void prepare(const TeamView& view) override;
  void decide(const TeamView& view, TeamCommands& commands) override;
  TeamRequests requests() const override { return output_.requests; }
  void end(const strategies::GameEnd& end) override;

  // The program's greeting; nullopt until the program has been asked for a decision.
  const std::optional<league::Greeting>& greeting() const { return greeting_; }
  // How the program ended, for example "ended with status 0"; valid after end().
  const std::string& ending() const { return ending_; }

 private:
  template <typename Action>
  void blame_program(const Action& action);
  void begin();
  void receive(std::int64_t frame);
  template <typename Message>
  void send(const Message& message);

  std::optional<ProgramProcess> process_;  // nullopt if the program could not be started
  std::string fault_;                      // empty until a fault occurs
  bool was_killed_ = false;
  std::string ending_;
  league::TeamStart start_;
  std::optional<league::Greeting> greeting_;
  std::unique_ptr<league::TeamCodec> codec_;
  std::optional<league::OutputDecoder> decoder_;
  league::TeamFrame frame_;
  league::TeamOutput output_;
  std::string bytes_;
};

}  // namespace autoref::game
