// A log of a short game, as `autoref play` writes it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/checkout.hpp"
#include "tests/runner/cli/answer.hpp"
#include "tests/runner/support/temporary_folder.hpp"

namespace autoref::runner {

// Two halves of 3 s each, after a wait for the teams and before the pauses; in `folder`.
inline std::string write_short_log(const TemporaryFolder& folder, const std::string& rules) {
  const std::string path = folder / "game.log.gz";
  const std::string game = in_checkout("scenarios/paper-game.yaml");
  const std::string book = "match.rules=" + rules;
  // The book brings its own length, over which the last word is said.
  const Answer answer = answer_to({"play", game.c_str(), "--log", path.c_str(), "--set",
                                   book.c_str(), "--set", "match.half_s=3"});
  EXPECT_EQ(answer.code, 0) << answer.err;
  return path;
}

}  // namespace autoref::runner
