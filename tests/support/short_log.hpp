// The log of a short game, as written by `autoref play`.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref {

// Writes the log of a game with two halves of 3 s into `folder`; the log also contains the waiting
// time before the game and the breaks.
inline std::string write_short_log(const TemporaryFolder& folder, const std::string& rules) {
  const std::string path = folder / "game.log.gz";
  const std::string game = in_checkout("scenarios/paper-game.yaml");
  const std::string book = "match.rules=" + rules;
  // The rule book sets its own half length, so half_s is set after it.
  const app::Answer answer = app::answer_to({"play", game.c_str(), "--log", path.c_str(), "--set",
                                             book.c_str(), "--set", "match.half_s=3"});
  EXPECT_EQ(answer.code, 0) << answer.err;
  return path;
}

}  // namespace autoref
