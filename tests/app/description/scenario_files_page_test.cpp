// docs/reference/scenario-files.md and other-files.md list the keys that each kind of file accepts.
#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <sstream>

#include "experiments/kinds/all_kinds.hpp"
#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/schema_tables.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

using Names = std::set<std::string>;

// A file with the unknown key `zzz` in the part that a section describes.
struct Part {
  std::string section;
  std::string_view verb;
  std::string yaml;
};

const std::vector<Part> kParts = {
    {"game", "play", "kind: game\nzzz: 1\n"},
    {"compare: the test", "run",
     "kind: compare\nseed: 1\nteams: {old: {}, new: {}}\ntest: {zzz: 1}\n"},
    {"sprt: the test", "run",
     "kind: sprt\nseed: 1\nteams: {x: {strategy: basic}, y: {strategy: zone}}\nsprt: {zzz: 1}\n"},
    {"situations: one situation", "run",
     "kind: situations\nattackers: {x: {strategy: basic}}\ndefenders: {y: {strategy: basic}}\n"
     "situations: {corner: {zzz: 1}}\n"},
    {"tune: a parameter", "run",
     "kind: tune\nseed: 1\nteam: {strategy: basic}\niterations: 1\npairs: 1\n"
     "tune: {shot_mps: {zzz: 1}}\n"},
    {"tune: the test", "run",
     "kind: tune\nseed: 1\nteam: {strategy: basic}\niterations: 1\npairs: 1\n"
     "tune: {shot_mps: {start: 5}}\ntest: {zzz: 1}\n"},
    {"judge: seeds", "judge",
     "kind: judge\nrules: [paper]\ncameras: [none]\nteams: [basic]\ngames: 2\nseeds: {zzz: 1}\n"},
    {"lab", "experiment lab", "kind: lab\nzzz: 1\n"},
    {"lab: the ball", "experiment lab", "kind: lab\nduration_s: 1\nball: {zzz: 1}\n"},
    {"lab: a robot", "experiment lab", "kind: lab\nduration_s: 1\nrobots: [{zzz: 1}]\n"},
    {"lab: a command", "experiment lab",
     "kind: lab\nduration_s: 1\nrobots: [{side: west, commands: [{zzz: 1}]}]\n"}};

// Those, and each kind of experiment.
std::vector<Part> all_parts() {
  std::vector<Part> parts = kParts;
  for (const experiments::Kind* kind : experiments::kinds_of_experiments()) {
    const std::string name(kind->name);
    parts.push_back({name, kind->verb, "kind: " + name + "\nzzz: 1\n"});
  }
  return parts;
}

std::vector<SchemaSection> page_sections() {
  std::vector<SchemaSection> sections = sections_of("docs/reference/scenario-files.md");
  for (SchemaSection& section : sections_of("docs/reference/other-files.md"))
    sections.push_back(std::move(section));
  return sections;
}

// The words after `label` in a message: "label a, b, c".
Names listed_after(const std::string& label, const std::string& message) {
  const std::size_t begin = message.find(label);
  EXPECT_NE(begin, std::string::npos) << message;
  if (begin == std::string::npos) return {};
  std::string list = message.substr(begin + label.size());
  std::istringstream words(list.substr(0, list.find_first_of("\n;")));
  Names names;
  for (std::string word; std::getline(words >> std::ws, word, ',');) names.insert(word);
  return names;
}

// What the program says about a file with this text.
std::string complaint(std::string_view verb, const std::string& text) {
  const TemporaryFolder folder;
  const std::string file = (folder / "file.yaml").string();
  write_content(file, "schema: 1\n" + text);
  const Answer answer = answer_to(std::string(verb), {file.c_str()});
  EXPECT_EQ(answer.code, io::kBadInput) << text;
  return answer.err;
}

Names accepted(const Part& part) {
  Names names = listed_after("Known here: ", complaint(part.verb, part.yaml));
  for (const char* common : {"schema", "kind", "about"}) names.erase(common);
  return names;
}

class ScenarioFilesPage : public testing::TestWithParam<Part> {};

TEST_P(ScenarioFilesPage, ListsTheKeysThatAreAccepted) {
  for (const SchemaSection& section : page_sections()) {
    if (section.title != GetParam().section) continue;
    const std::vector<std::string> described = section.names();
    EXPECT_EQ(Names(described.begin(), described.end()), accepted(GetParam()));
    return;
  }
  FAIL() << "no section " << GetParam().section;
}

INSTANTIATE_TEST_SUITE_P(Of, ScenarioFilesPage, testing::ValuesIn(all_parts()),
                         [](const auto& test) {
                           std::string name;
                           for (const char c : test.param.section)
                             name += std::isalpha(c) != 0 ? std::string(1, c) : "";
                           return name;
                         });

TEST(ScenarioFilesPages, HaveASectionForEveryKind) {
  Names kinds = listed_after("expected one of ", complaint("run", "kind: zzz\n"));
  kinds.erase("found 'zzz'");
  kinds.insert({"lab", "measured", "robot"});  // read by verbs and scenarios of their own
  Names sections;
  for (const SchemaSection& section : page_sections())
    if (section.title.find(':') == std::string::npos) sections.insert(section.title);
  EXPECT_EQ(sections, kinds);
}

// A robot type is read by the scenario that names it.
TEST(ScenarioFilesPages, ListTheKeysOfRobotTypes) {
  const TemporaryFolder folder;
  write_content(folder / "type.yaml", "schema: 1\nkind: robot\nzzz: 1\n");
  const std::string type = (folder / "type.yaml").string();
  const std::string game = "kind: game\nteams: {a: {type: " + type + "}}\n";
  const Names known = listed_after("Known here: ", complaint("play", game));
  EXPECT_EQ(known, (Names{"schema", "kind", "about", "robot", "kicker", "dribbler"}));
}

// A preset is read by the scenario that names it.
TEST(ScenarioFilesPages, ListTheKeysOfMeasuredPresets) {
  const TemporaryFolder folder;
  write_content(folder / "mine.yaml", "schema: 1\nkind: measured\nzzz: 1\n");
  const std::string game = "kind: game\nsim: {ball: " + (folder / "mine.yaml").string() + "}\n";
  Names keys = {"schema", "kind", "about"};
  for (const SchemaSection& section : page_sections()) {
    if (section.title != "measured") continue;
    for (const std::string& name : section.names()) keys.insert(name);
  }
  EXPECT_EQ(listed_after("Known here: ", complaint("play", game)), keys);
}

}  // namespace
}  // namespace autoref::app
