// The parameters of a simulation that plays like recorded games, with their intervals.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "logs/fit/ball_fit.hpp"
#include "logs/fit/camera_fit.hpp"
#include "logs/fit/estimate.hpp"
#include "logs/fit/rig_fit.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {

// A number that is estimated.
struct FittedNumber {
  std::string section;  // of the settings below `sim`, such as "ball"; empty for sim itself
  std::string key;      // such as "roll_mps2"
  Estimate estimate;

  std::string name() const { return section.empty() ? key : section + "." + key; }
};

// What the robots of one team reached: lower bounds of what they can do.
struct FittedTeam {
  // As in the referee's packets; "yellow" or "blue" if these do not name the teams differently.
  std::string name;
  std::vector<FittedNumber> robots;
};

struct LogFit {
  std::vector<FittedNumber> ball;  // and contacts
  std::vector<FittedNumber> vision;
  std::vector<FittedNumber> kicker;  // of both teams together
  std::vector<FittedTeam> teams;
  // Parts of the noise that drift slowly, in m. The simulation has no such noise.
  std::vector<FittedNumber> drifts;

  std::map<std::uint32_t, CameraTiming> cameras;
  bool cameras_run_freely = false;
  std::optional<double> camera_height_m;  // mean; nullopt if the log does not say
  bool reports_height = false;
  std::vector<SeenShare> ball_seen;
  std::optional<RollPrediction> roll_prediction;  // compared with the default ball

  double length_s = 0;       // from the first to the last frame of each part
  double running_s = 0;      // while play ran
  std::int64_t packets = 0;  // from vision
};

// A log to read several times, and the teams' names in it (empty: unknown).
struct NamedLog {
  std::string path;
  PerSide<std::string> names;  // yellow is west
};

// Fits all logs together; teams of the same name are one team. Vision is fitted to the first ten
// hours. Throws league::LogError if a file is
// not a log.
LogFit fit_of(const std::vector<NamedLog>& logs);

}  // namespace autoref::logs
