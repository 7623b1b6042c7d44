#include "league/team/team_codec.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "tests/checkout.hpp"
#include "tests/league/team/described.hpp"
#include "tests/league/team/program_side.hpp"
#include "tests/league/team/random_messages.hpp"

namespace autoref::league {
namespace {

using Result = OutputDecoder::Result;

struct EncodingCase {
  const char* name;
  TeamEncoding encoding;
  std::unique_ptr<ProgramSide> (*make_side)();
};

class Encoding : public testing::TestWithParam<EncodingCase> {
 protected:
  template <typename Message>
  std::string encoded(const Message& message) const {
    std::string bytes = "before";
    codec->append(message, bytes);
    EXPECT_EQ(bytes.substr(0, 6), "before");
    return bytes.substr(6);
  }

  std::unique_ptr<TeamCodec> codec = make_team_codec(GetParam().encoding);
  std::unique_ptr<ProgramSide> program = GetParam().make_side();
  RandomMessages random{7};
};

INSTANTIATE_TEST_SUITE_P(Of, Encoding,
                         testing::Values(EncodingCase{"Json", TeamEncoding::kJson, make_json_side},
                                         EncodingCase{"Flat", TeamEncoding::kFlat, make_flat_side}),
                         [](const auto& test) { return test.param.name; });

TEST_P(Encoding, KeepsEveryBitOfAStart) {
  for (int i = 0; i < 50; ++i) {
    const TeamStart start = random.start();
    const TeamStart read = program->read_start(encoded(start));
    ASSERT_EQ(described(read), described(start));
    EXPECT_EQ(read.rules, start.rules);
  }
}

TEST_P(Encoding, KeepsEveryBitOfTrackedMotion) {
  for (int i = 0; i < 300; ++i) {
    const TeamFrame frame = random.frame();
    ASSERT_EQ(described(program->read_frame(encoded(frame))), described(frame));
  }
}

TEST_P(Encoding, KeepsEveryBitOfDetections) {
  for (int i = 0; i < 300; ++i) {
    const TeamFrame frame = random.frame_with_detections();
    ASSERT_EQ(described(program->read_frame(encoded(frame))), described(frame));
  }
}

TEST_P(Encoding, KeepsTheEnd) {
  const TeamEnd end = random.end();
  EXPECT_EQ(described(program->read_end(encoded(end))), described(end));
}

TEST_P(Encoding, CutsALongReason) {
  const TeamEnd end{std::string(1000, 'x'), 1, 2};
  EXPECT_EQ(program->read_end(encoded(end)).reason, std::string(kLongestName, 'x'));
}

TEST_P(Encoding, RefusesALongParameterName) {
  TeamStart start;
  start.params[std::string(kLongestName + 1, 'x')] = 1;
  std::string bytes;
  EXPECT_THROW(codec->append(start, bytes), std::invalid_argument);
}

TEST_P(Encoding, KeepsEveryBitOfAnOutput) {
  OutputDecoder decoder(*codec);
  TeamOutput read;
  for (int i = 0; i < 300; ++i) {
    const TeamOutput output = random.output();
    decoder.add(program->written(output));
    ASSERT_EQ(decoder.next(read), Result::kOutput) << decoder.fault();
    ASSERT_EQ(described(read), described(output));
    ASSERT_EQ(decoder.bytes_left(), 0U);
  }
}

TEST_P(Encoding, TakesAnOutputByteByByte) {
  const TeamOutput output = random.output();
  const std::string bytes = program->written(output);
  OutputDecoder decoder(*codec);
  TeamOutput read;
  for (const char byte : bytes.substr(0, bytes.size() - 1)) {
    decoder.add(std::string_view(&byte, 1));
    ASSERT_EQ(decoder.next(read), Result::kNeedsMore);
  }
  decoder.add(bytes.substr(bytes.size() - 1));
  ASSERT_EQ(decoder.next(read), Result::kOutput);
  EXPECT_EQ(described(read), described(output));
}

TEST_P(Encoding, TakesSeveralOutputsAtOnce) {
  const TeamOutput first = random.output();
  const TeamOutput second = random.output();
  OutputDecoder decoder(*codec);
  decoder.add(program->written(first) + program->written(second));
  TeamOutput read;
  ASSERT_EQ(decoder.next(read), Result::kOutput);
  EXPECT_EQ(described(read), described(first));
  EXPECT_GT(decoder.bytes_left(), 0U);
  ASSERT_EQ(decoder.next(read), Result::kOutput);
  EXPECT_EQ(described(read), described(second));
  EXPECT_EQ(decoder.next(read), Result::kNeedsMore);
}

TEST_P(Encoding, ForgetsThePreviousOutput) {
  TeamOutput read = random.output();
  read.requests.leaves = 3;
  TeamOutput still;
  still.frame = 8;
  OutputDecoder decoder(*codec);
  decoder.add(program->written(still));
  ASSERT_EQ(decoder.next(read), Result::kOutput);
  EXPECT_EQ(described(read), described(still));
}

TEST(JsonEncoding, AcceptsMembersInAnyOrderAndIntegersAsNumbers) {
  const std::unique_ptr<TeamCodec> codec = make_team_codec(TeamEncoding::kJson);
  OutputDecoder decoder(*codec);
  decoder.add(
      R"({"commands": [{"vx_mps": 2, "robot": 4}, {"robot": 5, "chip": null}], "frame": 1})");
  decoder.add("\n");
  TeamOutput output;
  ASSERT_EQ(decoder.next(output), Result::kOutput) << decoder.fault();
  EXPECT_EQ(output.commands[4].velocity_mps, Vec2(2, 0));
  EXPECT_EQ(output.commands[5].velocity_mps, Vec2(0, 0));
}

TEST(TeamProgramsPage, HasAnExampleThatIsUnderstood) {
  const std::unique_ptr<TeamCodec> codec = make_team_codec(TeamEncoding::kJson);
  OutputDecoder decoder(*codec);
  std::ifstream page(in_checkout("docs/team-programs.md"));
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("{\"frame\"")) decoder.add(line + "\n");
  }
  TeamOutput output;
  ASSERT_EQ(decoder.next(output), Result::kOutput) << decoder.fault();
  EXPECT_EQ(output.frame, 118);
  EXPECT_EQ(output.commands[3].kick_mps, 6.5);
}

}  // namespace
}  // namespace autoref::league
