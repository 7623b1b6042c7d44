// Fuzzes everything that `autoref referee log` does, beside the recorded referee: the
// decisions must be finite. Most inputs are mutated packet by packet, the others byte by byte.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "io/errors.hpp"
#include "tests/fuzz/file_in_memory.hpp"
#include "tests/logs/mutated_log.hpp"
#include "tests/logs/refereed_log.hpp"

using namespace autoref;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  if (seed % 4 == 0) return LLVMFuzzerMutate(data, size, most);
  try {
    const std::string bytes = logs::mutated(logs::records_in(as_file(data, size)), seed);
    const std::size_t count = std::min(bytes.size(), most);
    std::copy_n(bytes.begin(), count, data);
    return count;
  } catch (const league::LogError&) {
    return LLVMFuzzerMutate(data, size, most);
  }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const logs::RefereedLog log = logs::refereed(as_file(data, size));
    if (!std::all_of(log.decisions.begin(), log.decisions.end(),
                     [](const referee::Decision& decision) { return logs::is_finite(decision); }))
      std::abort();
  } catch (const league::LogError&) {  // not a log
  } catch (const io::InputError&) {    // cannot be refereed
  }
  return 0;
}
