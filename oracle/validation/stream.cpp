#include <groundtruth/validation/stream.hpp>

#include <utility>

#include <groundtruth/text/scene_text.hpp>

namespace groundtruth::validation {
namespace {

constexpr std::size_t largest_batch = 16;

class GivenCases : public Stream {
 public:
  GivenCases(std::vector<cases::Case> given, Listen listen)
      : given_(std::move(given)), listen_(std::move(listen)) {}

  std::optional<Batch> next() override {
    if (next_ == given_.size()) return std::nullopt;
    const std::string scene = write_scene(given_[next_].scene);
    Batch batch{std::make_shared<const Scene>(given_[next_].scene), {}, {}};
    do {
      batch.ids.push_back(given_[next_].id);
      batch.asks.push_back(given_[next_].ask);
      ++next_;
    } while (next_ < given_.size() && batch.asks.size() < largest_batch &&
             write_scene(given_[next_].scene) == scene);
    return batch;
  }

  void learn(std::span<const Finding> findings) override {
    const std::size_t first = next_ - findings.size();
    for (std::size_t i = 0; i < findings.size(); ++i) listen_(given_[first + i].id, findings[i]);
  }

 private:
  std::vector<cases::Case> given_;
  Listen listen_;
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<Stream> stream_of(std::vector<cases::Case> given, Listen listen) {
  return std::make_unique<GivenCases>(std::move(given), std::move(listen));
}

}  // namespace groundtruth::validation
