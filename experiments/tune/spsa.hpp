// Simultaneous perturbation stochastic approximation: Spall, Implementation of the simultaneous
// perturbation algorithm for stochastic optimization, IEEE Trans. Aerosp. Electron. Syst. 34
// (1998).
//
// Each iteration scores two points only, however many parameters there are: the centre plus and
// minus a random perturbation of all parameters at once.
#pragma once

#include <vector>

#include "experiments/tune/optimiser.hpp"

namespace autoref::experiments {

// Gain sequences of Spall's section III, with his exponents: in iteration k, counted from 0, the
// perturbation is c_k = 1 / (k + 1)^0.101 steps, and the gain is a_k = a / (k + 1 + A)^0.602, with
// A a tenth of the iterations. Differences between scores are divided by their root mean square so
// far, so that a good gain does not depend on how many goals fall in a game.
struct SpsaGains {
  int iterations = 100;
  // Moves the centre by this many steps in the first iteration, and as far in later ones, but for
  // the sequences, if the difference is as large as usual; sets a.
  double gain = 0.3;

  double perturbation(int k) const;
  double gain_in(int k) const;  // a_k
};

class Spsa : public Optimiser {
 public:
  Spsa(const SpsaGains& gains, std::vector<Axis> axes, std::uint64_t seed);

  // "plus" and "minus". At the edge of the box they are clipped, and the difference between them
  // that remains counts.
  std::vector<Candidate> ask() const override;

  // Moves the centre along the estimated gradient, at most by twice the perturbation; not at all if
  // a score is unknown.
  void tell(std::span<const Score> scores) override;

  Point centre() const override { return centre_; }

  // The mean of the centres after the last half of the iterations so far.
  Point best() const override { return tail_.value(); }

  double reach() const override { return gains_.perturbation(iteration_); }

 private:
  void move_by(double difference);

  // By how much the parameters differ from the centre in "plus", before clipping.
  Point perturbation() const;

  SpsaGains gains_;
  std::vector<Axis> axes_;
  std::uint64_t seed_;
  Point centre_;
  int iteration_ = 0;
  double squares_ = 0;   // sum of the squared differences between scores,
  int differences_ = 0;  // and their number
  TailMean tail_;
};

}  // namespace autoref::experiments
