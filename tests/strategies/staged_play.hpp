// A staged world with all that plays look at.
#pragma once

#include "strategies/plays/plays.hpp"
#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {

struct StagedPlay : StagedOutlook {
  using StagedOutlook::StagedOutlook;

  // Looks at the world for so many frames.
  void watch(int frames = 12) {
    for (int i = 0; i < frames; ++i) {
      look(1);
      field.update();
      handler.update();
    }
  }
  // The parts that a play gives, after a few frames of looking.
  Cast cast(void (*play)(Playbook&, Cast&)) {
    watch();
    Cast cast(outlook);
    play(book, cast);
    return cast;
  }

  PassField field{outlook};
  BallHandler handler{outlook};
  Playbook book{outlook, handler, field};
};

}  // namespace autoref::strategies
