// A staged world with all that plays look at.
#pragma once

#include "strategies/plays/plays.hpp"
#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {

struct StagedPlay : StagedPrediction {
  using StagedPrediction::StagedPrediction;

  // Looks at the world for so many frames.
  void watch(int frames = 12) {
    for (int i = 0; i < frames; ++i) {
      look(1);
      field.update();
      handler.update();
    }
  }
  // The parts that a play gives, after a few frames of looking.
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
