#include "league/log_file.hpp"

#include <vector>

#include "tests/league/scratch_log.hpp"

namespace autoref::league {
namespace {

using namespace std::string_literals;

// The format written out by hand: signature, version, and a record of 7 bytes.
const std::string kHead = "SSL_LOG_FILE\0\0\0\1"s;
const std::string kRecord = "\0\0\0\0\0\0\1\2\0\0\0\4\0\0\0\7message"s;

struct TouchHypothesis {
  std::vector<LogRecord> records;
  std::optional<LogDamage> damage;
};

TouchHypothesis read_all(const std::filesystem::path& path) {
  LogReader reader(path);
  TouchHypothesis hypothesis;
  LogRecord record;
  while (reader.read(record)) hypothesis.records.push_back(record);
  hypothesis.damage = reader.damage();
  return hypothesis;
}

std::string error_of(const std::filesystem::path& path) {
  try {
    LogReader reader(path);
  } catch (const LogError& error) {
    return error.what();
  }
  return {};
}

void write_three(const std::filesystem::path& path) {
  LogWriter writer(path);
  for (int i = 0; i < 3; ++i)
    writer.write(1'000'000'000LL * i, MessageKind::kReferee2013, std::string(100 * i, 'x'));
  writer.close();
}

TEST(LogWriter, WritesTheFormatByteByByte) {
  const ScratchFile file(".log");
  LogWriter writer(file.path());
  writer.write(0x102, MessageKind::kVision2014, "message");
  writer.close();
  EXPECT_EQ(file.bytes(), kHead + kRecord);
}

TEST(LogWriter, CompressesFilesNamedGz) {
  const ScratchFile file(".log.gz");
  write_three(file.path());
  EXPECT_EQ(file.bytes().substr(0, 2), "\x1f\x8b");
  EXPECT_LT(file.bytes().size(), 150U);
}

TEST(LogWriter, NamesAFileThatCannotBeWritten) {
  EXPECT_THROW(LogWriter("/nowhere/game.log"), LogError);
}

void expect_three_read_back(const ScratchFile& file) {
  write_three(file.path());
  const TouchHypothesis hypothesis = read_all(file.path());
  ASSERT_EQ(hypothesis.records.size(), 3U) << file.path();
  EXPECT_EQ(hypothesis.records[2].time_ns, 2'000'000'000LL);
  EXPECT_EQ(hypothesis.records[2].message, std::string(200, 'x'));
  EXPECT_FALSE(hypothesis.damage.has_value()) << file.path();
}

TEST(LogReader, ReadsBackWhatWasWritten) {
  expect_three_read_back(ScratchFile(".log"));
  expect_three_read_back(ScratchFile(".log.gz"));
}

TEST(LogReader, KeepsRecordsBeforeATruncation) {
  const ScratchFile file(".log");
  const std::string whole = kHead + kRecord + kRecord;
  for (std::size_t size = kHead.size(); size <= whole.size(); ++size) {
    const TouchHypothesis hypothesis = read_all(file.fill(whole.substr(0, size)).path());
    const std::size_t complete = (size - kHead.size()) / kRecord.size();
    EXPECT_EQ(hypothesis.records.size(), complete) << size;
    const bool is_cut = (size - kHead.size()) % kRecord.size() != 0;
    ASSERT_EQ(hypothesis.damage.has_value(), is_cut) << size;
    if (!is_cut) continue;
    EXPECT_EQ(hypothesis.damage->offset, kHead.size() + complete * kRecord.size()) << size;
  }
}

TEST(LogReader, KeepsRecordsBeforeATruncationInACompressedLog) {
  const ScratchFile file(".log.gz");
  write_three(file.path());
  const std::string whole = file.bytes();
  const TouchHypothesis hypothesis = read_all(file.fill(whole.substr(0, whole.size() - 12)).path());
  EXPECT_LE(hypothesis.records.size(), 3U);
  EXPECT_TRUE(hypothesis.damage.has_value());
}

TEST(LogReader, RefusesAnOversizedMessageAndReportsItsOffset) {
  const ScratchFile file(".log");
  const std::string gigantic = "\0\0\0\0\0\0\0\0\0\0\0\4\x7f\xff\xff\xff"s;
  const TouchHypothesis hypothesis = read_all(file.fill(kHead + kRecord + gigantic).path());
  EXPECT_EQ(hypothesis.records.size(), 1U);
  ASSERT_TRUE(hypothesis.damage.has_value());
  EXPECT_EQ(hypothesis.damage->offset, 39);
  EXPECT_EQ(hypothesis.damage->what,
            "a message of 2147483647 bytes exceeds the maximum of 1048576");
}

TEST(LogReader, SaysWhyAFileIsNotALog) {
  const ScratchFile file(".log");
  EXPECT_NE(error_of(file.fill("").path()).find(": is empty"), std::string::npos);
  EXPECT_NE(error_of(file.fill("SSL_LOG_FIL").path()).find("first bytes are not SSL_LOG_FILE"),
            std::string::npos);
  EXPECT_NE(error_of(file.fill("SSL_LOG_FILE\0\0\0\2"s).path()).find("version 2, at byte 12"),
            std::string::npos);
  EXPECT_NE(error_of("/nowhere/game.log").find("No such file"), std::string::npos);
}

}  // namespace
}  // namespace autoref::league
