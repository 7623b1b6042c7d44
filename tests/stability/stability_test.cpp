// The program still has everything that 1.0 promised. Names may be added, but not removed.
//
// Before a release that adds some, write the lists anew and check that only lines were added:
//   build/release/bin/test_stability --gtest_also_run_disabled_tests
//   --gtest_filter='*WritesTheLists'
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>

#include "experiments/kinds/scenario_reader.hpp"
#include "game/lab/lab.hpp"
#include "game/settings/robot_types.hpp"
#include "tests/checkout.hpp"
#include "tests/stability/promised_names.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::stability {
namespace {

std::vector<PromisedList> promised_lists() {
  return {{"settings", setting_names},     {"written", written_names},
          {"events", event_names},         {"command-line", command_line_names},
          {"exit-codes", exit_code_names}, {"messages", message_names},
          {"network", network_names}};
}

std::string path_of(const PromisedList& list) {
  return in_checkout("tests/stability/" + list.file + ".txt");
}

// The lines of a list, without comments.
Names promised(const PromisedList& list) {
  Names names;
  std::istringstream text(content_of(path_of(list)));
  for (std::string line; std::getline(text, line);)
    if (!line.empty() && line.front() != '#') names.push_back(line);
  return names;
}

class Promise : public testing::TestWithParam<PromisedList> {};

TEST_P(Promise, IsKept) {
  const Names names = GetParam().names();
  const std::set<std::string> present(names.begin(), names.end());
  const Names expected = promised(GetParam());
  ASSERT_FALSE(expected.empty());
  for (const std::string& name : expected)
    EXPECT_TRUE(present.contains(name))
        << name << " is gone, which 1.x promises to keep (docs/stability.md)";
}

TEST_P(Promise, DISABLED_WritesTheLists) {
  std::string text = "# Kept by every 1.x: see docs/stability.md.\n";
  for (const std::string& name : GetParam().names()) text += name + "\n";
  write_content(path_of(GetParam()), text);
}

INSTANTIATE_TEST_SUITE_P(Of, Promise, testing::ValuesIn(promised_lists()), [](const auto& test) {
  std::string name = test.param.file;
  std::erase(name, '-');
  return name;
});

// One file of each kind, as 1.0 read them.
TEST(FilesOf10, AreStillRead) {
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(in_checkout("tests/stability/scenarios"))) {
    const std::filesystem::path& file = entry.path();
    if (!entry.is_regular_file()) continue;
    ++files;
    if (file.stem() == "lab") {
      EXPECT_NO_THROW(game::read_lab_scene(file)) << file;
    } else if (file.stem() == "robot") {
      EXPECT_NO_THROW(game::read_robot_type_text(content_of(file), file)) << file;
    } else {
      EXPECT_NO_THROW(experiments::read_scenario(file)) << file;
    }
  }
  EXPECT_EQ(files, 11);
}

}  // namespace
}  // namespace autoref::stability
