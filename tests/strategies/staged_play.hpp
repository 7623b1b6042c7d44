// A staged world with everything that plays need.
#pragma once

#include "strategies/plays/plays.hpp"
#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {

struct StagedPlay : StagedPrediction {
  using StagedPrediction::StagedPrediction;

  // Observes the world for a number of frames.
  void watch(int frames = 12) {
    for (int i = 0; i < frames; ++i) {
      look(1);
      field.update();
      handler.update();
    }
  }
  // The role assignment of a play after a few frames of observation.
  RoleAssignment assignment(void (*play)(PlayContext&, RoleAssignment&)) {
    watch();
    RoleAssignment assignment(predicted);
    play(book, assignment);
    return assignment;
  }

  PassField field{predicted};
  BallHandler handler{predicted};
  PlayContext book{predicted, handler, field};
};

}  // namespace autoref::strategies
