#include "experiments/run/program_versions.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "game/settings/fields.hpp"
#include "io/csv.hpp"
#include "io/errors.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

class ProgramVersions : public testing::Test {
 protected:
  ProgramVersions() {
    fs::create_directories(folder_ / "team/lib");
    write("team/main.py", "import lib");
    write("team/lib/pass.py", "1");
  }

  void write(const std::string& name, const std::string& text) const {
    write_content(folder_ / name, text);
  }

  game::TeamSettings team(const std::vector<std::string>& files = {}) const {
    game::TeamSettings team;
    team.program.command = {"python3", "main.py", "--fast"};
    team.program.directory = (folder_ / "team").string();
    team.files = files;
    return team;
  }

  static std::string hash_of(const game::TeamSettings& team) {
    RoundRobin robin;
    robin.teams = {{"mine", team}, {"other", {}}};
    Scenario scenario{"", robin};
    note_program_versions(scenario);
    const Teams teams = scenario.as<RoundRobin>()->teams;
    EXPECT_EQ(teams.at("other").files_hash, "");
    return teams.at("mine").files_hash;
  }

  TemporaryFolder folder_;
};

TEST_F(ProgramVersions, AreThoseOfTheFilesThatTheCommandNames) {
  const std::string before = hash_of(team());
  EXPECT_EQ(before.size(), 16U);
  EXPECT_EQ(hash_of(team()), before);
  write("team/lib/pass.py", "2");
  EXPECT_EQ(hash_of(team()), before);
  write("team/main.py", "import lib ");
  EXPECT_NE(hash_of(team()), before);
}

TEST_F(ProgramVersions, AreThoseOfTheFilesAndFoldersThatTheScenarioNames) {
  const std::string before = hash_of(team({"lib"}));
  write("team/main.py", "changed");
  EXPECT_EQ(hash_of(team({"lib"})), before);
  write("team/lib/pass.py", "2");
  const std::string changed = hash_of(team({"lib"}));
  EXPECT_NE(changed, before);
  write("team/lib/shot.py", "");
  EXPECT_NE(hash_of(team({"lib"})), changed);
}

// What Python leaves behind when it runs, and what an editor or a repository hides, does not count.
TEST_F(ProgramVersions, DoNotDependOnWhatIsHidden) {
  const std::string before = hash_of(team({"lib"}));
  fs::create_directories(folder_ / "team/lib/__pycache__");
  fs::create_directories(folder_ / "team/lib/.git");
  write("team/lib/__pycache__/pass.cpython-311.pyc", "compiled");
  write("team/lib/.git/index", "x");
  write("team/lib/.pass.py.swp", "x");
  EXPECT_EQ(hash_of(team({"lib"})), before);
}

// The same bytes in other files are another version.
TEST_F(ProgramVersions, DependOnWhichFileContainsWhat) {
  write("team/lib/pass.py", "1");
  write("team/lib/shot.py", "2");
  const std::string before = hash_of(team({"lib"}));
  write("team/lib/pass.py", "2");
  write("team/lib/shot.py", "1");
  EXPECT_NE(hash_of(team({"lib"})), before);
}

TEST_F(ProgramVersions, OfAMissingFileAreAnErrorThatNamesTheSetting) {
  try {
    hash_of(team({"nowhere.py"}));
    FAIL();
  } catch (const io::InputError& error) {
    EXPECT_EQ(error.key(), "teams.mine.files");
    EXPECT_NE(std::string(error.what()).find("nowhere.py"), std::string::npos) << error.what();
  }
}

TEST_F(ProgramVersions, AreOneForAllValuesOfAFactor) {
  Sweep sweep;
  sweep.base.b = team();
  sweep.factors = {{"b.command", {std::string("python3 main.py"), std::string("python3 two.py")}}};
  const auto noted = [](Sweep of) {
    Scenario scenario{"", std::move(of)};
    note_program_versions(scenario);
    return scenario.as<Sweep>()->base.b.files_hash;
  };
  const std::string before = noted(sweep);
  write("team/two.py", "another");
  EXPECT_NE(noted(sweep), before);
}

// Two versions in two folders, which a sweep compares.
TEST_F(ProgramVersions, OfAFactorMayBeInFoldersOfTheirOwn) {
  fs::create_directories(folder_ / "new");
  write("new/main.py", "new");
  Sweep sweep;
  sweep.base.b.program.command = {"python3", "main.py"};
  sweep.base.b.files = {"main.py"};
  sweep.factors = {{"b.directory", {(folder_ / "team").string(), (folder_ / "new").string()}}};
  const auto noted = [&sweep] {
    Scenario scenario{"", sweep};
    note_program_versions(scenario);
    return scenario.as<Sweep>()->base.b.files_hash;
  };
  const std::string before = noted();
  EXPECT_EQ(before.size(), 16U);
  write("new/main.py", "newer");
  EXPECT_NE(noted(), before);
}

TEST_F(ProgramVersions, BelongToTheIdentityOfAGame) {
  game::GameSettings game;
  const std::uint64_t without = game::configuration_hash(game);
  game.a = team({"lib"});
  const std::uint64_t unknown = game::configuration_hash(game);
  game.a.files_hash = "0123456789abcdef";
  EXPECT_NE(game::configuration_hash(game), unknown);
  EXPECT_NE(unknown, without);
}

// The folder's scenario keeps what was noted, so that it can be read where the program is not.
TEST_F(ProgramVersions, AreKeptInTheFoldersScenario) {
  RoundRobin robin;
  robin.teams = {{"mine", team()}, {"other", {}}};
  Scenario scenario{"A test.", robin};
  note_program_versions(scenario);
  const std::string noted = scenario.as<RoundRobin>()->teams.at("mine").files_hash;
  write("team/main.py", "changed");
  const Scenario read = read_scenario_text(effective_text(scenario), "effective.yaml");
  EXPECT_EQ(read.as<RoundRobin>()->teams.at("mine").files_hash, noted);
}

class VersionedRun : public ProgramVersions {
 protected:
  Scenario scenario(int pairs) const {
    RoundRobin robin;
    robin.teams = {{"mine", team()}, {"other", {}}};
    robin.pairs = pairs;
    robin.seed = 7;
    Scenario scenario{"A test.", robin};
    note_program_versions(scenario);
    return scenario;
  }
  ExperimentReport run(int pairs) const {
    return run_experiment(scenario(pairs), fake_options(folder_ / "run"));
  }
};

TEST_F(VersionedRun, IsRefusedIfTheProgramWasChangedBefore) {
  EXPECT_EQ(run(2).played, 4);
  EXPECT_EQ(run(3).played, 2);
  write("team/main.py", "changed");
  try {
    run(4);
    FAIL();
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("teams.mine.files_hash is"), std::string::npos)
        << error.what();
  }
}

TEST_F(VersionedRun, GoesOnIfAFileIsOnlyTouched) {
  ExperimentOptions options = fake_options(folder_ / "run");
  options.play = [this](const game::GameConfiguration& game) {
    fs::last_write_time(folder_ / "team/main.py", fs::file_time_type::clock::now());
    return fake_game(game);
  };
  EXPECT_EQ(run_experiment(scenario(5), options).played, 10);
}

TEST_F(VersionedRun, StopsIfTheProgramIsChangedMeanwhile) {
  ExperimentOptions options = fake_options(folder_ / "run");
  options.workers = 1;
  const auto lines = [this] {
    return io::complete_lines(content_of(folder_ / "run/games/shard-0-of-1.csv")).size();
  };
  // The second game changes the file once the first one's row is there.
  options.play = [&](const game::GameConfiguration& game) {
    if (!fs::create_directory(folder_ / "played")) {
      for (int i = 0; i < 60'000 && lines() < 2; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      write("team/main.py", "changed meanwhile");
    }
    return fake_game(game);
  };
  EXPECT_THROW(run_experiment(scenario(5), options), io::InputError);
  const StoredRows rows = read_rows(folder_ / "run/games", row_format(scenario(5).experiment()));
  EXPECT_EQ(rows.rows.size(), 1U);
}

}  // namespace
}  // namespace autoref::experiments
