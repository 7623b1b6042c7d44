#include "io/words.hpp"

#include <gtest/gtest.h>

#include <clocale>

namespace autoref::io {
namespace {

TEST(NumberIn, ReadsPlainDecimalNumbers) {
  EXPECT_EQ(number_in("0.5"), 0.5);
  EXPECT_EQ(number_in("-2"), -2.0);
  EXPECT_EQ(number_in("+3"), 3.0);
  EXPECT_EQ(number_in("1e-3"), 0.001);
}

TEST(NumberIn, RefusesTextThatIsNotEntirelyANumber) {
  for (const char* text : {"", " ", "1 ", " 1", "1,5", "1.5m", "0x10", "inf", "-inf", "nan",
                           "1e999", "ten", "+-1", "++1", "1_000"}) {
    EXPECT_FALSE(number_in(text)) << text;
  }
}

TEST(NumberIn, DoesNotDependOnTheLocale) {
  const std::string former = std::setlocale(LC_ALL, nullptr);
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // if this locale exists, its decimal separator is a comma
  EXPECT_EQ(number_in("0.5"), 0.5);
  EXPECT_EQ(text_of(0.5), "0.5");
  std::setlocale(LC_ALL, former.c_str());
}

TEST(WholeNumberIn, RefusesPointsExponentsAndOverflow) {
  EXPECT_EQ(whole_number_in("6"), 6);
  for (const char* text : {"6.0", "6e0", "99999999999", ""}) {
    EXPECT_FALSE(whole_number_in(text)) << text;
  }
}

TEST(SeedIn, ReadsEveryNonNegativeNumberOf64Bits) {
  EXPECT_EQ(seed_in("18446744073709551615"), 18446744073709551615ULL);
  EXPECT_FALSE(seed_in("18446744073709551616"));
  EXPECT_FALSE(seed_in("-1"));
}

TEST(TextOf, IsTheShortestThatReadsBackEqual) {
  EXPECT_EQ(text_of(0.1), "0.1");
  EXPECT_EQ(text_of(1.0), "1.0");
  for (const double number : {1.0 / 3.0, 6.05, 1e-9, 1e300}) {
    EXPECT_EQ(number_in(text_of(number)), number);
  }
}

TEST(NearestWord, HasTheSmallestEditDistance) {
  EXPECT_EQ(nearest_word("robot", {"strategy", "robots", "params"}), "robots");
  EXPECT_EQ(nearest_word("stratgey", {"strategy", "robots"}), "strategy");
  EXPECT_EQ(nearest_word("x", {}), "");
}

TEST(Suggestion, NamesAWordThatIsClose) {
  EXPECT_EQ(suggestion("zoen", {"basic", "zone"}), "; did you mean 'zone'?");
  EXPECT_EQ(suggestion("nwe", {"new", "play"}), "; did you mean 'new'?") << "two exchanged letters";
  EXPECT_EQ(suggestion("shot", {"pass_mps", "shot_mps"}), "; did you mean 'shot_mps'?");
}

TEST(Suggestion, NamesUpToThreeWordsThatBeginSo) {
  EXPECT_EQ(suggestion("2026", {"2014", "2026-b", "2026-a"}),
            "; did you mean '2026-b' or '2026-a'?");
  EXPECT_EQ(suggestion("r", {"rules", "teams", "run", "report", "replay"}),
            "; did you mean 'rules', 'run' or 'report'?");
  EXPECT_EQ(suggestion("game", {"autoref", "game-controller"}),
            "; did you mean 'game-controller'?");
  EXPECT_EQ(suggestion("mass", {"mass_kg", "mass_kg"}), "; did you mean 'mass_kg'?");
}

TEST(Suggestion, PrefersWordsThatLackOneLetter) {
  EXPECT_EQ(suggestion("b.robot", {"b.robots", "b.robot.mass_kg"}), "; did you mean 'b.robots'?");
  EXPECT_EQ(suggestion("rc2026-", {"rc2026-b", "rc2026-a", "rc2026-abc"}),
            "; did you mean 'rc2026-b' or 'rc2026-a'?");
}

TEST(Trimmed, HasNoSpacesAtItsEnds) {
  EXPECT_EQ(trimmed(" match.half_s\t "), "match.half_s");
  EXPECT_EQ(trimmed("python3 my_team.py"), "python3 my_team.py");
  EXPECT_EQ(trimmed("  "), "");
}

TEST(Suggestion, IsEmptyIfNoWordIsClose) {
  EXPECT_EQ(suggestion("factors", {"pairs", "seed"}), "");
  EXPECT_EQ(suggestion("c", {"a", "b"}), "");
  EXPECT_EQ(suggestion("", {"a"}), "");
  EXPECT_EQ(suggestion("a", {}), "");
}

}  // namespace
}  // namespace autoref::io
