// Independent random streams, one for each source of randomness.
//
// Every source of randomness in a game (camera, the motors of a side, ...) has its own stream,
// identified by the game's seed, a purpose and a side, so that drawing more numbers from one stream
// does not change the numbers from another. A stream is counter-based: its n-th number is a hash of
// the stream's key and n.
#pragma once

#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <cstdint>
#include <limits>

#include "soccer/side.hpp"

namespace autoref {

// Steele, Lea and Flood's finaliser (SplitMix64): a bijection that spreads each bit over the word.
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

// These values identify streams, so changing a value changes the course of games.
enum class RandomPurpose : std::uint8_t {
  kCamera = 0,
  kRadio = 2,
  kMotors = 3,
  kKicker = 4,
  kStrategy = 5,
  kLatency = 6,
  kDribbler = 7,
  kCameraPhases = 8
};

class RandomStream {
 public:
  using result_type = std::uint64_t;

  // Streams with the same seed yield the same numbers.
  explicit RandomStream(std::uint64_t seed = 0) : key_(mix_bits(seed + kStep)) {}

  // The stream of a purpose, either shared by both sides or for `side`.
  static RandomStream of(std::uint64_t seed, RandomPurpose purpose) {
    return RandomStream(mix_bits(seed) + static_cast<std::uint64_t>(purpose) * 4);
  }
  static RandomStream of(std::uint64_t seed, RandomPurpose purpose, Side side) {
    return RandomStream(stream_seed(seed, purpose, side));
  }

  // The seed of the stream that of() returns.
  static std::uint64_t stream_seed(std::uint64_t seed, RandomPurpose purpose, Side side) {
    return mix_bits(seed) + static_cast<std::uint64_t>(purpose) * 4 + 1 +
           static_cast<std::uint64_t>(side);
  }

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }
  result_type operator()() { return mix_bits(key_ + ++counter_ * kStep); }

  // Random numbers: uniform() in [0, 1), and normal() with mean 0 and standard deviation 1.
  double uniform() { return boost::random::uniform_01<double>()(*this); }
  double normal() { return boost::random::normal_distribution<double>()(*this); }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio, odd
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace autoref
