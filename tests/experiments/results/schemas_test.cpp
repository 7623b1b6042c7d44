// docs/schemas.md describes exactly the columns and keys that the program writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "tests/support/schema_tables.hpp"
#include "tests/support/written_names.hpp"

namespace autoref::experiments {
namespace {

std::vector<Artefact> artefacts() {
  std::vector<Artefact> all = written_csv();
  for (const auto& more : {written_plots(), written_json()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

WrittenNames described_names(const Artefact& artefact) {
  for (const SchemaSection& section : schema_sections()) {
    if (section.title != artefact.section) continue;
    WrittenNames names = section.names();
    if (artefact.is_json) std::sort(names.begin(), names.end());
    return names;
  }
  return {};
}

// Turns a section's title into a test name: "results.csv" into "ResultsCsv".
std::string test_name(const std::string& section) {
  std::string name;
  bool starts_word = true;
  for (const char c : section) {
    const bool is_letter = std::isalpha(static_cast<unsigned char>(c)) != 0;
    if (is_letter) name += starts_word ? static_cast<char>(std::toupper(c)) : c;
    starts_word = !is_letter;
  }
  return name;
}

class Schema : public testing::TestWithParam<Artefact> {};

TEST_P(Schema, DescribesWhatTheProgramWrites) {
  const WrittenNames written = GetParam().names();
  ASSERT_FALSE(written.empty());
  EXPECT_EQ(described_names(GetParam()), written)
      << "docs/schemas.md, section '" << GetParam().section << "'";
}

INSTANTIATE_TEST_SUITE_P(Of, Schema, testing::ValuesIn(artefacts()),
                         [](const auto& test) { return test_name(test.param.section); });

TEST(Schemas, HaveATestForEverySection) {
  std::set<std::string> compared;
  for (const Artefact& artefact : artefacts()) compared.insert(artefact.section);
  std::set<std::string> described;
  for (const SchemaSection& section : schema_sections()) {
    EXPECT_TRUE(described.insert(section.title).second) << section.title << " appears twice";
  }
  EXPECT_EQ(described, compared);
}

TEST(Schemas, FindEveryCallOnTheReferencePage) {
  WrittenNames described;
  for (const SchemaSection& section : sections_of("docs/reference/rules.md")) {
    if (section.title == "Events") described = section.names();
  }
  for (const std::string& column : calls_columns()) {
    const std::string event = column.substr(std::string("calls_").size());
    EXPECT_NE(std::find(described.begin(), described.end(), event), described.end()) << column;
  }
}

TEST(Schemas, GiveEachNameAMeaningAndItsValues) {
  for (const SchemaSection& section : schema_sections()) {
    for (const std::vector<std::string>& row : section.rows) {
      ASSERT_EQ(row.size(), 3U) << section.title << ": " << row.front();
      EXPECT_EQ(row.front().front(), '`') << section.title << ": " << row.front();
      EXPECT_FALSE(row[1].empty()) << section.title << ": " << row.front();
      EXPECT_FALSE(row[2].empty()) << section.title << ": " << row.front();
    }
  }
}

}  // namespace
}  // namespace autoref::experiments
