#include "runner/settings/renamed.hpp"

#include <gtest/gtest.h>

#include "runner/experiments/kinds/scenario_reader.hpp"
#include "runner/io/errors.hpp"
#include "runner/settings/fields.hpp"
#include "tests/runner/cli/answer.hpp"

namespace autoref::runner {
namespace {

std::string refusal_of_scenario(const std::string& text) {
  try {
    read_scenario_text(text, "x.yaml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RenamedKey, IsRefusedInAFileWithItsNewName) {
  EXPECT_TRUE(refusal_of_scenario("schema: 1\nkind: game\nsim:\n  calm_substeps: 4\n")
                  .starts_with("x.yaml:4:3: sim: unknown key 'calm_substeps'; its name is "
                               "'contact_free_substeps' now"));
}

TEST(RenamedKey, IsRefusedOnTheCommandLineWithItsNewName) {
  GameSettings game;
  try {
    set_by_path(game, "sim.calm_substeps", "4");
    FAIL() << "an old key was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "unknown key 'sim.calm_substeps'; its name is "
                 "'sim.contact_free_substeps' now");
  }
}

TEST(RenamedKey, HasAKnownNewName) {
  GameSettings game;
  EXPECT_NO_THROW(set_by_path(game, "sim.contact_free_substeps", "4"));
}

TEST(RenamedKind, IsRefusedWithItsNewName) {
  EXPECT_NE(refusal_of_scenario("schema: 1\nkind: match\n")
                .find("unknown kind 'match'; its name is 'sprt' now"),
            std::string::npos);
}

TEST(RenamedVerb, IsRefusedWithItsNewName) {
  const Answer answer = answer_to({"plan", "--delta", "0.5"});
  EXPECT_EQ(answer.code, kBadInput);
  EXPECT_EQ(answer.err, "autoref: unknown verb 'plan'; its name is 'sample-size' now\n");
}

TEST(RenamedRule, IsRefusedWithItsNewName) {
  EXPECT_NE(refusal_of_scenario("schema: 1\nkind: game\nmatch: { switch: { crash: true } }\n")
                .find("unknown key 'crash'; its name is 'bot_crash_unique' now"),
            std::string::npos);
}

}  // namespace
}  // namespace autoref::runner
