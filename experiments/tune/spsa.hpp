// Simultaneous perturbation stochastic approximation: Spall, Implementation of the simultaneous
// perturbation algorithm for stochastic optimization, IEEE Trans. Aerosp. Electron. Syst. 34
// (1998).
//
// Each iteration scores only two points, regardless of the number of parameters: the centre plus
// and minus a random perturbation of all parameters.
#pragma once

#include <vector>

#include "experiments/tune/optimiser.hpp"

namespace autoref::experiments {

// Gain sequences of Spall's section III, with his exponents: in iteration k, counted from 0, the
// perturbation is c_k = 1 / (k + 1)^0.101 steps, and the gain is a_k = a / (k + 1 + A)^0.602, where
// A is a tenth of the number of iterations. Differences between scores are divided by their root
// mean square so far, so that a good gain does not depend on the number of goals per game.
struct SpsaGains {
  int iterations = 100;
  // Determines a. If the difference between the two scores is as large as usual, the centre moves
  // by this many steps in the first iteration. In later iterations it moves as far, apart from the
  // decay of the sequences.
  double gain = 0.3;

  double perturbation(int k) const;
  double gain_in(int k) const;  // a_k
};

class Spsa : public Optimiser {
 public:
  Spsa(const SpsaGains& gains, std::vector<Axis> axes, std::uint64_t seed);

  // The candidates "plus" and "minus". At the edge of the box they are clipped, and the estimate
  // uses the remaining difference between them.
  std::vector<Candidate> ask() const override;

  // Moves the centre along the estimated gradient, by at most twice the perturbation, or not at all
  // if a score is unknown.
  void tell(std::span<const Score> scores) override;

  Point centre() const override { return centre_; }

  // The mean of the centres in the last half of the iterations so far.
  Point best() const override { return tail_.value(); }

  double reach() const override { return gains_.perturbation(iteration_); }

 private:
  void move_by(double difference);

  // The difference between "plus" and the centre, before clipping.
  Point perturbation() const;

  SpsaGains gains_;
  std::vector<Axis> axes_;
  std::uint64_t seed_;
  Point centre_;
  int iteration_ = 0;
  double squares_ = 0;   // sum of the squared differences between scores,
  int differences_ = 0;  // and the number of these differences
  TailMean tail_;
};

}  // namespace autoref::experiments
