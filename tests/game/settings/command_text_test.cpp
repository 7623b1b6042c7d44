#include "game/settings/command_text.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace autoref::game {
namespace {

using Words = std::vector<std::string>;

TEST(CommandText, IsSplitAtSpaces) {
  EXPECT_EQ(words_of_command("python3  my_team.py\t-v "), (Words{"python3", "my_team.py", "-v"}));
  EXPECT_EQ(words_of_command(""), Words{});
}

TEST(CommandText, KeepsQuotedSpaces) {
  EXPECT_EQ(words_of_command(R"(a 'b c' "d 'e'" f\ g '' x"y z"w)"),
            (Words{"a", "b c", "d 'e'", "f g", "", "xy zw"}));
  EXPECT_EQ(words_of_command(R"('a\b' "a\"b" a\\b)"), (Words{R"(a\b)", "a\"b", R"(a\b)"}));
}

TEST(CommandText, KnowsNoShell) {
  EXPECT_EQ(words_of_command("echo $HOME *.py; ls | cat"),
            (Words{"echo", "$HOME", "*.py;", "ls", "|", "cat"}));
}

TEST(CommandText, IsRefusedIfAQuoteIsOpen) {
  EXPECT_THROW(words_of_command("python3 'my team.py"), std::invalid_argument);
  EXPECT_THROW(words_of_command("python3 \"my team.py"), std::invalid_argument);
}

TEST(CommandText, ReadsBack) {
  for (const Words& words :
       {Words{"python3", "my_team.py"}, Words{"a b", "", "'", "\"", "\\", "$x"},
        Words{"it's 'here'", "--x=1"}, Words{}}) {
    EXPECT_EQ(words_of_command(text_of_command(words)), words) << text_of_command(words);
  }
  EXPECT_EQ(text_of_command({"python3", "my team.py"}), "python3 'my team.py'");
}

}  // namespace
}  // namespace autoref::game
