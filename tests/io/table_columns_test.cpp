#include "io/table_columns.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace autoref::io {
namespace {

struct Sprinter {
  std::string name;
  int goals = 0;
  std::optional<double> speed;
};

const TableColumns<Sprinter> kSprinterColumns = {{"name", &Sprinter::name, true},
                                                 {"goals", &Sprinter::goals},
                                                 {"speed", &Sprinter::speed, true}};

TEST(TableColumns, AreNamedInTheHeadAndFilledInEachRow) {
  EXPECT_EQ(table_rows(kSprinterColumns, {Sprinter{"fast", 3, 2.5}, Sprinter{"still", 0, {}}}),
            (std::vector<Cells>{
                {"name", "goals", "speed"}, {"fast", "3", "2.5000"}, {"still", "0", ""}}));
}

TEST(TableColumns, CanFollowOtherColumns) {
  std::vector<Cells> rows = {{"number"}, {"7"}};
  append_columns(rows, kSprinterColumns, {Sprinter{"fast", 3, 2.5}});
  EXPECT_EQ(csv_text(rows), "number,name,goals,speed\n7,fast,3,2.5000\n");
}

TEST(TableColumns, AreInJsonOnlyIfTheySaySo) {
  Json object = {{"number", 7}};
  add_members(object, kSprinterColumns, Sprinter{"fast", 3, 2.123456});
  EXPECT_EQ(json_text(object), R"({"number": 7, "name": "fast", "speed": 2.123456})");
}

TEST(TableColumns, HaveNullInJsonForAMissingNumber) {
  Json object = Json::object();
  add_members(object, kSprinterColumns, Sprinter{"still", 0, {}});
  EXPECT_EQ(json_text(object), R"({"name": "still", "speed": null})");
}

TEST(TableColumns, AreFoundByName) {
  EXPECT_EQ(columns_named({"a", "b", "c"}, {"c", "a"}), (std::vector<std::size_t>{2, 0}));
  EXPECT_EQ(columns_named({"a"}, {}), std::vector<std::size_t>{});
}

TEST(TableColumns, ThatATableDoesNotHaveAreAnError) {
  EXPECT_THROW(column_named({"a", "b"}, "c"), std::logic_error);
  EXPECT_THROW(column_named({}, "a"), std::logic_error);
  EXPECT_THROW(columns_named({"a", "b"}, {"a", "c"}), std::logic_error);
}

TEST(NumberCell, HasFourDecimalsOrIsEmpty) {
  EXPECT_EQ(number_cell(1.0 / 3), "0.3333");
  EXPECT_EQ(number_cell(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(number_cell(std::nullopt), "");
}

}  // namespace
}  // namespace autoref::io
