// Exits and goals of our own games, spliced into clips in which the ball stays on the field, are
// called. The clips are a game of ours and, if the environment variable AUTOREF_REAL_LOGS names
// their folder, real games.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

#include "soccer/random.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/logs/spliced_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::logs {
namespace {

namespace fs = std::filesystem;

constexpr std::array kExitLines = {ExitLine::kTouchLine, ExitLine::kGoalLine, ExitLine::kGoal};

// Writes the log of a game by the rule book, as seen by one camera of 2026.
void write_game(const char* book, const char* half_s, int seed, const fs::path& log) {
  const std::string game = in_checkout("scenarios/paper-game.yaml");
  const std::string path = log.string();
  const std::string rules = std::string("match.rules=") + book;
  const std::string half = std::string("match.half_s=") + half_s;
  const std::string seed_text = std::to_string(seed);
  const app::Answer answer = app::answer_to(
      {"play", game.c_str(), "--log", path.c_str(), "--seed", seed_text.c_str(), "--set",
       rules.c_str(), "--set", half.c_str(), "--set", "match.halves=1", "--set",
       "sim.camera=rc2026-b", "--set", "a.strategy=cobalt1", "--set", "b.strategy=counter"});
  ASSERT_EQ(answer.code, 0) << answer.err;
}

bool has_each_line(const std::vector<BallExit>& exits) {
  constexpr int kEnough = 2;
  return std::all_of(kExitLines.begin(), kExitLines.end(), [&exits](ExitLine line) {
    const auto is_over = [line](const BallExit& exit) { return exit.line == line; };
    return std::count_if(exits.begin(), exits.end(), is_over) >= kEnough;
  });
}

// From as many games as it takes to leave over each line.
std::vector<BallExit> exits_of_our_games(const TemporaryFolder& folder) {
  constexpr int kMostGames = 12;
  std::vector<BallExit> exits;
  for (int seed = 1; seed <= kMostGames && !has_each_line(exits); ++seed) {
    const fs::path log = folder / "exits.log";
    write_game("2026-b", "300", seed, log);
    const std::vector<BallExit> more = exits_in(refereed(log));
    exits.insert(exits.end(), more.begin(), more.end());
  }
  return exits;
}

// All splices of each exit over the line, if there are any.
std::vector<std::vector<Splice>> splices_over(ExitLine line, const std::vector<BallExit>& exits,
                                              const RefereedLog& clip) {
  std::vector<std::vector<Splice>> all;
  for (const BallExit& exit : exits) {
    std::vector<Splice> splices =
        exit.line == line ? splices_of(exit, clip) : std::vector<Splice>();
    if (!splices.empty()) all.push_back(std::move(splices));
  }
  return all;
}

// Ten splices over all lines in turn (a short clip may lack robots that face some line): different
// exits as far as possible, each at a random place in the clip. Empty if there is none.
std::vector<Splice> ten_splices(const std::vector<BallExit>& exits, const RefereedLog& clip) {
  std::vector<std::vector<std::vector<Splice>>> lines;
  for (const ExitLine line : kExitLines) {
    lines.push_back(splices_over(line, exits, clip));
    if (lines.back().empty()) lines.pop_back();
  }
  RandomStream chance(1);
  std::vector<Splice> chosen;
  for (std::size_t i = 0; i < 10 && !lines.empty(); ++i) {
    const auto& of_line = lines[i % lines.size()];
    const std::vector<Splice>& splices = of_line[i / lines.size() % of_line.size()];
    const double at = chance.uniform() * static_cast<double>(splices.size());
    chosen.push_back(splices[static_cast<std::size_t>(at)]);
  }
  return chosen;
}

bool is_call_of(const referee::Decision& decision, const Splice& splice) {
  constexpr double kSameTime_s = 0.1;
  return decision.finding.event == splice.event &&
         decision.restart().value_or(Command{}).side == splice.restart &&
         std::abs(decision.time_s - splice.call_s) < kSameTime_s;
}

// What was expected and what was decided after the kick.
std::string text_of(const Splice& splice, const RefereedLog& log) {
  std::string text =
      fmt::format("kick at {:.3f} s by {} {}, {} for {} at {:.3f} s; decided:", splice.from_s,
                  name_of(splice.kicker.side), splice.kicker.number, referee::name_of(splice.event),
                  name_of(splice.restart), splice.call_s);
  for (const referee::Decision& decision : log.decisions) {
    if (decision.time_s < splice.from_s) continue;
    text += fmt::format(" {} for {} at {:.3f} s;", referee::name_of(decision.finding.event),
                        name_of(decision.finding.restart.side), decision.time_s);
  }
  return text;
}

// The referee may not know who touched the ball last, and then decides another restart, or another
// foul may come first.
bool is_noticed_by(const referee::Decision& decision, const Splice& splice) {
  constexpr double kSameTime_s = 0.1;
  const referee::EventEntry& event = referee::entry_of(decision.finding.event);
  return (event.is_exit || decision.finding.event == referee::Event::kGoal ||
          decision.finding.event == referee::Event::kInvalidGoal) &&
         std::abs(decision.time_s - splice.call_s) < kSameTime_s;
}

// Expects that the exit is noticed in time; returns whether it is also called right.
bool expect_noticed(const Splice& splice, const fs::path& clip, const fs::path& spliced) {
  write_spliced(clip, splice, spliced);
  const RefereedLog log = refereed(spliced);
  const auto decided = [&](const auto& is_such) {
    return std::any_of(log.decisions.begin(), log.decisions.end(),
                       [&](const referee::Decision& d) { return is_such(d, splice); });
  };
  EXPECT_TRUE(decided(is_noticed_by)) << text_of(splice, log);
  return decided(is_call_of);
}

// Splices ten exits into the clip and expects that all are noticed and that at least `least` are
// called right. Returns the lines over which balls were spliced.
std::set<ExitLine> expect_exits_called_in(const fs::path& clip, const TemporaryFolder& folder,
                                          int least) {
  const std::vector<BallExit> exits = exits_of_our_games(folder);
  const std::vector<Splice> splices = ten_splices(exits, refereed(clip));
  EXPECT_EQ(splices.size(), 10U) << clip;
  std::set<ExitLine> lines;
  int right = 0;
  for (const Splice& splice : splices) {
    right += expect_noticed(splice, clip, folder / "spliced.log") ? 1 : 0;
    lines.insert(splice.exit->line);
  }
  EXPECT_GE(right, least) << clip;
  return lines;
}

void expect_no_exit_in(const fs::path& clip) {
  for (const referee::Decision& decision : refereed(clip).decisions) {
    const referee::EventEntry& event = referee::entry_of(decision.finding.event);
    EXPECT_FALSE(event.is_exit || event.event == referee::Event::kGoal)
        << clip << ": " << event.name << " at " << decision.time_s;
    EXPECT_EQ(decision.finding.card, referee::Card::kNone) << clip << ": " << event.name;
  }
}

TEST(SplicedExits, IntoAClipOfOurOwnAreCalled) {
  const TemporaryFolder folder;
  const fs::path clip = folder / "clip.log";
  write_game("2026-a", "200", 2, clip);
  // How often the last touch is known in such games is measured by autoref judge.
  EXPECT_EQ(expect_exits_called_in(clip, folder, 6).size(), kExitLines.size());
}

// Not among the discovered tests: CMake adds it if it knows the folder.
TEST(RealClips, WithSplicedExitsAreJudgedRight) {
  const char* const clips = std::getenv("AUTOREF_REAL_LOGS");
  if (clips == nullptr) GTEST_SKIP() << "skipped: AUTOREF_REAL_LOGS does not name a folder";
  const TemporaryFolder folder;
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(clips)) {
    if (entry.path().extension() != ".gz") continue;
    expect_no_exit_in(entry.path());
    expect_exits_called_in(entry.path(), folder, 10);
    ++count;
  }
  EXPECT_GT(count, 0) << "no clip in " << clips;
}

}  // namespace
}  // namespace autoref::logs
