// Logs with random errors.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "league/log_file.hpp"

namespace autoref::logs {

std::vector<league::LogRecord> records_in(const std::filesystem::path& log);

// The bytes of a log with these records.
std::string bytes_of(const std::vector<league::LogRecord>& records);

// The bytes of a log with up to eight errors: packets are dropped, repeated,
// reordered or cut short, bytes are flipped, sizes, kinds and times are changed, and fields of
// packets have values that are not finite, huge, unknown or missing.
std::string mutated(std::vector<league::LogRecord> records, std::uint64_t seed);

}  // namespace autoref::logs
