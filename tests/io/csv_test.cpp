#include "io/csv.hpp"

#include <gtest/gtest.h>

namespace autoref::io {
namespace {

const std::string kRewritten = "\xef\xbb\xbfgame,a\r\n\r\nx,1\ny,2\r\nnot complete";

std::vector<std::string> lines_in_pieces(std::string_view text, std::size_t size) {
  std::vector<std::string> taken;
  LinesAsWritten lines([&taken](std::string_view line) { taken.emplace_back(line); });
  for (std::size_t begin = 0; begin < text.size(); begin += size) {
    lines.add(text.substr(begin, size));
  }
  return taken;
}

TEST(Csv, LinesOfARewrittenFileAreThoseThatWereWritten) {
  const std::vector<std::string_view> lines = lines_as_written(kRewritten);
  EXPECT_EQ(lines, (std::vector<std::string_view>{"game,a", "", "x,1", "y,2"}));
}

TEST(Csv, LinesInPiecesAreTheSame) {
  const std::vector<std::string> whole = {"game,a", "", "x,1", "y,2"};
  for (std::size_t size = 1; size <= kRewritten.size(); ++size) {
    EXPECT_EQ(lines_in_pieces(kRewritten, size), whole) << size;
  }
  EXPECT_TRUE(lines_in_pieces("", 1).empty());
}

}  // namespace
}  // namespace autoref::io
