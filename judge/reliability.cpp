#include "judge/reliability.hpp"

namespace autoref::judge {

void Reliability::add(const experiments::CallVerdict& verdict) {
  if (!verdict.confidence) return;
  std::size_t index = kFrom.size() - 1;
  while (index > 0 && *verdict.confidence < kFrom[index]) --index;
  ReliabilityBand& band = bands_[index];
  ++band.calls;
  band.right += verdict.outcome == experiments::CallOutcome::kRight ? 1 : 0;
  band.confidence_sum += *verdict.confidence;
}

void Reliability::add(const Reliability& other) {
  for (std::size_t i = 0; i < bands_.size(); ++i) {
    bands_[i].calls += other.bands_[i].calls;
    bands_[i].right += other.bands_[i].right;
    bands_[i].confidence_sum += other.bands_[i].confidence_sum;
  }
}

}  // namespace autoref::judge
