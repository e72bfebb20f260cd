#include <groundtruth/campaign/tally.hpp>

#include <algorithm>

namespace groundtruth::campaign {
namespace {

void keep_worst(Worst& kept, const Worst& other) {
  if (other.ulps > kept.ulps || (other.ulps == kept.ulps && kept.ulps > 0 && other.place < kept.place))
    kept = other;
}

}  // namespace

void Tally::add(const judge::Comparison& comparison, Place place) {
  ++asks_;
  ++counts_[static_cast<std::size_t>(comparison.difference)];
  keep_worst(worst_lambda_, {comparison.lambda_ulps, place});
  keep_worst(worst_vector_, {comparison.vector_ulps, place});
  if (comparison.difference != judge::Difference::none && examples_.size() < most_examples) {
    examples_.push_back({comparison.difference, place});
  }
}

void Tally::merge(const Tally& other) {
  asks_ += other.asks_;
  left_out_ += other.left_out_;
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  keep_worst(worst_lambda_, other.worst_lambda_);
  keep_worst(worst_vector_, other.worst_vector_);
  examples_.insert(examples_.end(), other.examples_.begin(), other.examples_.end());
  std::sort(examples_.begin(), examples_.end(),
            [](const Disagreement& left, const Disagreement& right) { return left.place < right.place; });
  examples_.resize(std::min(examples_.size(), most_examples));
  seconds_ += other.seconds_;
}

}  // namespace groundtruth::campaign
