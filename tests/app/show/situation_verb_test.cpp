// autoref show situation.
#include <gtest/gtest.h>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/experiments/kinds/situations/small_situations.hpp"
#include "tests/support/has_part.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

class DrawnSituation : public testing::Test {
 protected:
  void SetUp() override { write_content(file_, experiments::kSmallSituations); }

  TemporaryFolder folder_;
  std::string file_ = folder_ / "x.yaml";
  std::string drawing_ = folder_ / "x.svg";
};

TEST_F(DrawnSituation, ShowsItsRobotsAndItsBall) {
  const Answer answer =
      answer_to({"show", "situation", file_.c_str(), "goal", "-o", drawing_.c_str()});
  ASSERT_EQ(answer.code, io::kDone) << answer.err;
  const std::string svg = content_of(drawing_);
  EXPECT_TRUE(has(svg, "class=\"ball\""));
  EXPECT_TRUE(has(svg, "attackers"));
  std::size_t robots = 0;
  for (std::size_t at = svg.find("class=\"robot\""); at != std::string::npos;
       at = svg.find("class=\"robot\"", at + 1))
    ++robots;
  EXPECT_EQ(robots, 3U);
}

TEST_F(DrawnSituation, NamesTheNearestSituation) {
  const Answer answer =
      answer_to({"show", "situation", file_.c_str(), "gaol", "-o", drawing_.c_str()});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_TRUE(has(answer.err, "did you mean 'goal'")) << answer.err;
}

}  // namespace
}  // namespace autoref::app
