#include "benchmarks/build_comparison.hpp"

#include <gtest/gtest.h>

#include "io/errors.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::benchmarks {
namespace {

constexpr const char* kGame =
    R"({"status": "ok", "sim_s": 1200, "state_hash": "00000000000000ff", "build": "0.1"})";

// A program that stands in for a build of AutoRef.
std::string stand_in(const TemporaryFolder& folder, const std::string& name,
                     const std::string& script) {
  const std::filesystem::path path = folder / name;
  write_content(path, "#!/bin/sh\n" + script + "\n");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path.string();
}

std::string printing(const std::string& hash) {
  return R"(echo '{"status": "ok", "sim_s": 10, "state_hash": ")" + hash + R"("}')";
}

std::string failure_of(const std::string& script, double longest_game_s = 600) {
  const TemporaryFolder folder;
  const std::string program = stand_in(folder, "program", script);
  try {
    compare_builds(program, program, {.rounds = 6}, longest_game_s);
  } catch (const io::InputError& error) {
    EXPECT_EQ(error.location().file, program);
    return error.what();
  }
  return "no failure";
}

TEST(MeasuredGame, IsTheProcessorTimePerSimulatedSecond) {
  const MeasuredGame game = measured_game("x", kGame, 1.8);
  EXPECT_DOUBLE_EQ(game.processor_s_per_sim_s, 0.0015);
  EXPECT_EQ(game.state_hash, 255U);
  EXPECT_EQ(game.build, "0.1");
}

TEST(MeasuredGame, RefusesAnythingElse) {
  for (const char* text : {"", "hello", "3", "[]", "{}", R"({"status": "ok", "sim_s": 1200})",
                           R"({"status": "ok", "sim_s": 0, "state_hash": "00000000000000ff"})",
                           R"({"status": "void", "sim_s": 1, "state_hash": "00000000000000ff"})",
                           R"({"status": "ok", "sim_s": 1, "state_hash": "ff"})"}) {
    EXPECT_THROW(measured_game("x", text, 1.8), io::InputError) << text;
  }
}

TEST(CompareBuilds, KnowsWhetherTheGamesAreTheSame) {
  const TemporaryFolder folder;
  const std::string a = stand_in(folder, "a", printing("00000000000000aa"));
  const std::string b = stand_in(folder, "b", printing("00000000000000bb"));
  const BuildComparison same = compare_builds(a, a, {.rounds = 6});
  EXPECT_EQ(same.ratios.size(), 6U);
  EXPECT_TRUE(same.plays_same_games());
  EXPECT_FALSE(compare_builds(a, b, {.rounds = 6}).plays_same_games());
}

TEST(CompareBuilds, NamesTheProgramThatFails) {
  EXPECT_NE(failure_of("echo hello").find("found 'hello"), std::string::npos);
  EXPECT_NE(failure_of("exit 3").find("code 3"), std::string::npos);
  EXPECT_NE(failure_of("exec sleep 1000", 0.5).find("took longer than 0.5 s"), std::string::npos);
  EXPECT_NE(failure_of("exec sleep 1000 >&-", 0.5).find("took longer than 0.5 s"),
            std::string::npos);
  EXPECT_THROW(compare_builds("/nonexistent/autoref", "x", {}), io::InputError);
}

}  // namespace
}  // namespace autoref::benchmarks
