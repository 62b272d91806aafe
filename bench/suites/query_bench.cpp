#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "arcway/angle.h"
#include "arcway/vehicle.h"
#include "bench/suites/backends.h"
#include "bench/suites/suite.h"
#include "bench/suites/work.h"
#include "datasets/io/random.h"

// What the graphs ask of a map, by every backend, over growing maps of constant density.
namespace arcway::internal::bench::query_suite {
namespace {

constexpr std::size_t kQuestions = 1024;
constexpr std::size_t kChecked = 64;

/// Thousands of distinct questions about places all over the map, of the size of what a planner asks.
struct Questions {
  explicit Questions(const World& world) {
    Random random(1);
    const Box& box = world.box();
    const Footprint body = Vehicle().footprint(1e-3);
    for (std::size_t i = 0; i < kQuestions; ++i) {
      const Vec2 p(random.uniform(box.min.x(), box.max.x()), random.uniform(box.min.y(), box.max.y()));
      const double length = random.uniform(0.0, 20.0);
      const Vec2 along = random.unit_vector();
      points.push_back(p);
      segments.push_back({p, p + length * along});
      rectangles.push_back(swept_rectangle({p.x(), p.y(), std::atan2(along.y(), along.x())}, length, body));
      bodies.push_back({p, 1.3, random.below(2) == 0 ? Side::kLeft : Side::kRight, body});
    }
  }
  std::vector<Vec2> points;
  std::vector<LineSegment> segments;
  std::vector<SweptRectangle> rectangles;
  std::vector<TurningBody> bodies;
};

/// Fills answers about the first questions.
using Ask = std::function<void(const QuerySet&, const Questions&, std::size_t count)>;

void time_questions(benchmark::State& state, const QueryBackend& backend, const std::string& world_name,
                    const std::function<bool(const QuerySet&, const QuerySet&, const Questions&)>& same,
                    const Ask& ask) {
  const World& world = shared_world(world_name);
  const Questions questions(world);
  const QuerySet queries = backend.queries(world);
  if (!require(state, same(queries, make_reference_queries(world), questions), "answers differ from the reference"))
    return;
  ask(queries, questions, kQuestions);
  const LoopWork work;
  for ([[maybe_unused]] auto _ : state) ask(queries, questions, kQuestions);
  work.count(state, "question", kQuestions);
  state.counters["vertices"] = static_cast<double>(world.vertices().size());
  set_batch(state, kQuestions);
}

template <class Answer, class Question>
bool same_answers(const std::vector<Question>& questions, const auto& ask_ours, const auto& ask_reference) {
  const std::span<const Question> asked(questions.data(), kChecked);
  std::vector<Answer> ours(kChecked), reference(kChecked);
  ask_ours(asked, std::span<Answer>(ours));
  ask_reference(asked, std::span<Answer>(reference));
  return std::ranges::equal(ours, reference, [](const Answer& a, const Answer& b) {
    if constexpr (std::is_same_v<Answer, HeadingSet>) {
      return std::ranges::equal(a.intervals(), b.intervals(),
                                [](auto x, auto y) { return x.low == y.low && x.high == y.high; });
    } else if constexpr (std::is_same_v<Answer, ClosestPoint>) {
      return a.distance == b.distance && a.edge == b.edge;
    } else {
      return a == b;
    }
  });
}

struct Stage {
  std::string name;
  std::function<bool(const QuerySet&, const QuerySet&, const Questions&)> same;
  Ask ask;
};

std::vector<Stage> stages() {
  std::vector<Stage> all;
  all.push_back(
      {"LinesOfSight",
       [](const QuerySet& a, const QuerySet& b, const Questions& q) {
         return same_answers<std::uint8_t>(
             q.segments, [&](auto s, auto out) { a.visibility->visible(s, out); },
             [&](auto s, auto out) { b.visibility->visible(s, out); });
       },
       [out = std::vector<std::uint8_t>(kQuestions)](const QuerySet& s, const Questions& q, std::size_t n) mutable {
         s.visibility->visible(std::span(q.segments).first(n), std::span(out).first(n));
         benchmark::DoNotOptimize(out.data());
       }});
  all.push_back(
      {"SweptRectangles",
       [](const QuerySet& a, const QuerySet& b, const Questions& q) {
         return same_answers<std::uint8_t>(
             q.rectangles, [&](auto s, auto out) { a.sweep->straight_free(s, out); },
             [&](auto s, auto out) { b.sweep->straight_free(s, out); });
       },
       [out = std::vector<std::uint8_t>(kQuestions)](const QuerySet& s, const Questions& q, std::size_t n) mutable {
         s.sweep->straight_free(std::span(q.rectangles).first(n), std::span(out).first(n));
         benchmark::DoNotOptimize(out.data());
       }});
  all.push_back(
      {"TurningIntervals",
       [](const QuerySet& a, const QuerySet& b, const Questions& q) {
         return same_answers<HeadingSet>(
             q.bodies, [&](auto s, auto out) { a.sweep->free_headings(s, out); },
             [&](auto s, auto out) { b.sweep->free_headings(s, out); });
       },
       [out = std::vector<HeadingSet>(kQuestions)](const QuerySet& s, const Questions& q, std::size_t n) mutable {
         s.sweep->free_headings(std::span(q.bodies).first(n), std::span(out).first(n));
         benchmark::DoNotOptimize(out.data());
       }});
  all.push_back(
      {"ClosestPoints",
       [](const QuerySet& a, const QuerySet& b, const Questions& q) {
         return same_answers<ClosestPoint>(
             q.points, [&](auto s, auto out) { a.distance->closest(s, out); },
             [&](auto s, auto out) { b.distance->closest(s, out); });
       },
       [out = std::vector<ClosestPoint>(kQuestions)](const QuerySet& s, const Questions& q, std::size_t n) mutable {
         s.distance->closest(std::span(q.points).first(n), std::span(out).first(n));
         benchmark::DoNotOptimize(out.data());
       }});
  return all;
}

void add(Study study) {
  for (const Stage& stage : stages()) {
    for (const QueryBackend& backend : query_backends()) {
      const bool reference = backend.name == "reference";
      Series series(study, stage.name + "/" + backend.name, "obstacles",
                    reference ? "O(n) a question" : "O(log n + edges near by) a question", reference ? 1.0 : 0.2);
      for (const std::size_t n : sizes(study, {10, 100, 1000, 10000, 100000}, 10, 10000)) {
        series.add(static_cast<double>(n), [&backend, stage, n](benchmark::State& state) {
          time_questions(state, backend, clutter_name("convex", n, 10, 30), stage.same, stage.ask);
        });
      }
    }
  }
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::query_suite
