// What one side's cameras and robots report, as late as the side's view.
#pragma once

#include "game/loop/configuration.hpp"
#include "game/loop/delay_line.hpp"
#include "sim/world.hpp"
#include "soccer/frame.hpp"
#include "strategies/strategy.hpp"

namespace autoref::game {

class Sensors {
 public:
  Sensors(const GameConfiguration& configuration, Side side);

  // Call once per frame, with the world that the camera saw.
  void update(const Frame& frame, const sim::WorldState& world);

  const strategies::SensorReadings& readings() const { return delayed_.oldest(); }

 private:
  Side side_;
  sim::TeamSpec::Robots robots_;
  DelayLine<strategies::SensorReadings> delayed_;
  strategies::SensorReadings latest_;
};

}  // namespace autoref::game
