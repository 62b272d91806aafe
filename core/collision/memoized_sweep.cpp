#include "core/collision/memoized_sweep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "core/base/hash_of.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kMostRemembered = std::size_t{1} << 20;

// The numbers of a question, and the shape of the body.
struct Question {
  std::array<double, 8> numbers;
  const GrownBody* shape = nullptr;
};

Question question_of(const SweptRectangle& r) {
  return {{r[0].x(), r[0].y(), r[1].x(), r[1].y(), r[2].x(), r[2].y(), r[3].x(), r[3].y()}};
}

Question question_of(const StraightBody& b) { return {{b.from.x, b.from.y, b.from.heading, b.length}, b.body.shape}; }

Question question_of(const TurningBody& b) {
  return {{b.center.x(), b.center.y(), b.radius, b.side == Side::kLeft ? 1.0 : -1.0, b.body.front, b.body.rear,
           b.body.left, b.body.right},
          b.body.shape};
}

using Bits = std::array<std::uint64_t, 9>;

Bits bits_of(const Question& question) {
  Bits bits;
  const auto numbers = std::bit_cast<std::array<std::uint64_t, 8>>(question.numbers);
  std::copy(numbers.begin(), numbers.end(), bits.begin());
  bits.back() = reinterpret_cast<std::uintptr_t>(question.shape);
  return bits;
}

struct Hash {
  std::size_t operator()(const Bits& bits) const { return hash_of(bits); }
};

// Answers by question.
template <class Answer>
class Answers {
 public:
  template <class Ask>
  void get(const Question& question, Answer& answer, const Ask& ask) {
    const Bits key = bits_of(question);
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = known_.find(key); found != known_.end()) {
        answer = found->second;
        return;
      }
    }
    ask();
    const std::lock_guard lock(mutex_);
    if (known_.size() < kMostRemembered) known_.emplace(key, answer);
  }

 private:
  std::mutex mutex_;
  std::unordered_map<Bits, Answer, Hash> known_;
};

}  // namespace

struct MemoizedSweep::Memory {
  Answers<std::uint8_t> straights, shapes;
  Answers<HeadingSet> headings;
};

MemoizedSweep::MemoizedSweep(std::shared_ptr<const SweepQuery> base)
    : base_(std::move(base)), memory_(std::make_unique<Memory>()) {}
MemoizedSweep::~MemoizedSweep() = default;

void MemoizedSweep::do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const {
  for (std::size_t i = 0; i < rectangles.size(); ++i)
    memory_->straights.get(question_of(rectangles[i]), free[i],
                           [&] { base_->straight_free(rectangles.subspan(i, 1), free.subspan(i, 1)); });
}

void MemoizedSweep::do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    memory_->shapes.get(question_of(bodies[i]), free[i],
                        [&] { base_->straight_free(bodies.subspan(i, 1), free.subspan(i, 1)); });
}

void MemoizedSweep::do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    memory_->headings.get(question_of(bodies[i]), result[i],
                          [&] { base_->free_headings(bodies.subspan(i, 1), result.subspan(i, 1)); });
}

}  // namespace arcway::internal
