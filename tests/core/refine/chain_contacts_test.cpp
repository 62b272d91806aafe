#include "core/refine/chain_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "core/base/infinity.h"
#include "core/collision/motion_free.h"
#include "tests/support/arc_chains.h"
#include "tests/support/free_plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// Kinds of places, in the order of the source: those of corners, then those of edges.
constexpr std::uint8_t kFirstOfEdges = 7, kKindsOfPlaces = 10;
constexpr double kContactError = 1e-6;  // [m]

// A cluttered world, and the free chains that a planner finds there.
class ContactCases {
 public:
  ContactCases(ClutterKind kind, std::uint64_t seed)
      : kind_(kind),
        world_(random_world({.kind = kind, .obstacles = 40, .vertices = 8, .fill = 0.25, .seed = seed})),
        outlines_(world_),
        queries_(make_reference_queries(world_)),
        planner_(world_, vehicle_, {.radii = {}, .refinement = {.max_trials = 0}}),
        random_(seed) {}

  // The body of the planner's vehicle among convex obstacles, else one that is narrower to the right.
  Footprint body() const {
    Footprint body = vehicle_.footprint(0.5 * vehicle_.safety_margin());
    if (kind_ == ClutterKind::kStar) body.right *= 0.5;
    return body;
  }

  // The chain of another query. Lines of a chain that become longer may make it touch; such chains are left out.
  ArcChain next() {
    ArcChain chain;
    for (;;) {
      const auto [request, path] = test::next_free_plan(planner_, random_);
      const auto circles = chain_of(path, request.start, request.goal);
      const auto lines = circles ? lines_of(*circles) : std::nullopt;
      if (lines && cut_turns(*circles, *lines, {3, 0.05, 72.0}, chain) && is_free(chain)) return chain;
    }
  }
  // @param growth  by which a smaller body is grown to this one on all parts.
  ChainContacts contacts_of(const ArcChain& chain, double growth = 0.0) const {
    ChainContacts contacts;
    const std::vector<double> growths(2 * chain.arcs.size() + 1, growth);
    EXPECT_TRUE(contacts.find(chain, around(), {body().grown(-growth), growths}));
    return contacts;
  }
  // @param clock  ends the search for contacts.
  ChainContacts::Around around(const StopClock& clock = {}) const {
    return {world_, outlines_, 4.0 * vehicle_.parameters().length, clock};
  }
  // Whether the body touches nothing along a chain, by the exact query.
  bool is_free(const ArcChain& chain) const { return motion_free(*queries_.sweep, body(), test::path_of(chain)); }
  test::RandomInputs& random() { return random_; }

 private:
  ClutterKind kind_;
  Vehicle vehicle_{{.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0}};
  World world_;
  Outlines outlines_;
  QuerySet queries_;
  Planner planner_;
  test::RandomInputs random_;
};

// The chain driven from its end to its start, backwards.
ArcChain backwards(const ArcChain& chain) {
  ArcChain result;
  EXPECT_TRUE(cut_turns(reversed(test::path_of(chain)), {1, 0.05, 72.0}, result));
  EXPECT_EQ(result.arcs.size(), chain.arcs.size());
  for (ArcChain::Line& line : result.lines) line.ahead = direction_of(line.heading);
  return result;
}

// The chain after a random step of all that can move; nothing if it has no such path.
std::optional<ArcChain> randomly_moved(const ArcChain& chain, double most, test::RandomInputs& random) {
  ArcChain moved = chain;
  for (ArcChain::Arc& arc : moved.arcs) {
    arc.center += random.point(-most, most);
    arc.radius = std::max(1.3, arc.radius + random.uniform(-most, most));
  }
  for (std::size_t i = 0; i < moved.lines.size(); ++i) {
    ArcChain::Line& line = moved.lines[i];
    if (i > 0 && i + 1 < moved.lines.size()) line.heading += random.uniform(-0.3, 0.3) * most;
    if (!line.is_tied) line.length = std::max(1e-3, line.length + random.uniform(-most, most));
  }
  if (!moved.join() || !moved.is_drivable()) return std::nullopt;
  return moved;
}

// The number of a part of a chain, with the directions that go with headings; false where it is given.
bool step_number(ArcChain& chain, const ChainContacts::Place& place, int number, double by) {
  const std::size_t i = place.index();
  const bool is_line = place.is_on_line();
  if (is_line && i == 0 && number <= kRadius) return false;
  ArcChain::Arc& arc = chain.arcs[is_line && i > 0 ? i - 1 : i];
  const auto turn = [&](ArcChain::Line& line) {
    line.heading += by;
    line.ahead = direction_of(line.heading);
  };
  if (number == kHeading) {
    turn(chain.lines[i]);
  } else if (number == kNextHeading && !is_line) {
    turn(chain.lines[i + 1]);
  } else if (number == kLength) {
    chain.lines[i].length += by;
  } else if (number == kRadius) {
    arc.radius += by;
  } else if (number <= kCenterY) {
    arc.center[number] += by;
  }
  return true;
}

TEST(ChainContacts, FreeChainsTouchNothing) {
  for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar}) {
    ContactCases cases(kind, 3);
    std::size_t near = 0;
    for (int i = 0; i < 20; ++i) {
      const ArcChain chain = cases.next();
      const ChainContacts contacts = cases.contacts_of(chain);
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        const double distance = contacts.look(chain, k).distance;
        EXPECT_GE(distance, -1e-9) << "chain " << i << " contact " << k;
        near += distance < 2e-3;
      }
    }
    // Paths pass corners by the safety margin, the wide side of the narrower body as well.
    EXPECT_GT(near, 5u);
  }
}

TEST(ChainContacts, AreNotAllFoundOnceTheClockIsOver) {
  ContactCases cases(ClutterKind::kConvex, 3);
  const ArcChain chain = cases.next();
  ChainContacts contacts;
  EXPECT_FALSE(contacts.find(chain, cases.around(StopClock(0.0)), cases.body()));
  EXPECT_LT(contacts.size(), cases.contacts_of(chain).size());
}

TEST(ChainContacts, OfASmallerBodyThatIsGrownOnAllPartsAreTheSame) {
  constexpr double kGrowth = 0.02;
  ContactCases cases(ClutterKind::kStar, 4);
  std::size_t compared = 0;
  for (int i = 0; i < 10; ++i) {
    const ArcChain chain = cases.next();
    const ChainContacts contacts = cases.contacts_of(chain), grown = cases.contacts_of(chain, kGrowth);
    ASSERT_EQ(grown.size(), contacts.size()) << "chain " << i;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const ChainContacts::Place place = contacts.look(chain, k), other = grown.look(chain, k);
      ASSERT_EQ(other.kind, place.kind) << "chain " << i << " contact " << k;
      if (place.distance == kInfinity) continue;
      EXPECT_NEAR(other.distance, place.distance, 1e-12) << "chain " << i << " contact " << k;
      const Term term = contacts.term(chain, k, place), of_grown = grown.term(chain, k, other);
      EXPECT_LT((term.gradient - of_grown.gradient).norm(), 1e-9) << "chain " << i << " contact " << k;
      ++compared;
    }
  }
  EXPECT_GT(compared, 500u);
}

TEST(ChainContacts, AreAsFarBackwards) {
  ContactCases cases(ClutterKind::kStar, 7);
  std::size_t compared = 0;
  for (int i = 0; i < 10; ++i) {
    const ArcChain chain = cases.next(), back = backwards(chain);
    const auto distances = [&](const ArcChain& of) {
      const ChainContacts contacts = cases.contacts_of(of);
      std::vector<double> all;
      for (std::size_t k = 0; k < contacts.size(); ++k)
        if (const double distance = contacts.look(of, k).distance; distance < kInfinity) all.push_back(distance);
      std::ranges::sort(all);
      return all;
    };
    const std::vector<double> there = distances(chain), here = distances(back);
    ASSERT_EQ(here.size(), there.size()) << "chain " << i;
    for (std::size_t k = 0; k < here.size(); ++k) EXPECT_NEAR(here[k], there[k], 1e-9) << "chain " << i;
    compared += here.size();
  }
  EXPECT_GT(compared, 500u);
}

// Whether a contact is where it was, after a step of a number, in a place that stays smooth.
bool stays(const ChainContacts& contacts, const ArcChain& chain, std::size_t contact,
           const ChainContacts::Place& place) {
  const ChainContacts::Place now = contacts.look(chain, contact);
  return now.part == place.part && now.kind == place.kind;
}

// Compares the derivatives by one number with differences. Returns whether they can be compared.
bool expect_contact_derivatives(const ChainContacts& contacts, const ArcChain& chain, std::size_t contact, int number) {
  constexpr double kStep = 1e-5;
  const ChainContacts::Place place = contacts.look(chain, contact);
  const Term term = contacts.term(chain, contact, place);
  EXPECT_EQ(term.value, place.distance);
  std::array<ArcChain, 2> moved{chain, chain};
  std::array<Term, 2> terms;
  for (const std::size_t side : {0u, 1u}) {
    if (!step_number(moved[side], place, number, side == 0 ? -kStep : kStep)) return false;
    if (!stays(contacts, moved[side], contact, place)) return false;
    terms[side] = contacts.term(moved[side], contact, contacts.look(moved[side], contact));
  }
  EXPECT_NEAR(term.gradient[number], (terms[1].value - terms[0].value) / (2.0 * kStep), 1e-7)
      << "kind " << int{place.kind} << " number " << number;
  for (int other = 0; other < kLocalNumbers; ++other) {
    if (ArcChain given = chain; !step_number(given, place, other, 0.0)) continue;
    EXPECT_NEAR(term.hessian(other, number), (terms[1].gradient[other] - terms[0].gradient[other]) / (2.0 * kStep),
                1e-6)
        << "kind " << int{place.kind} << " numbers " << other << " and " << number;
  }
  return true;
}

TEST(ChainContacts, DerivativesAreThoseOfTheDistances) {
  std::array<int, kKindsOfPlaces> compared{};
  for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar}) {
    ContactCases cases(kind, 4);
    for (int i = 0; i < 10; ++i) {
      const ArcChain free = cases.next();
      const ArcChain moved = randomly_moved(free, 0.2, cases.random()).value_or(free);
      const bool is_back = i % 2 == 1;
      const ArcChain chain = is_back ? backwards(moved) : moved;
      ChainContacts contacts = cases.contacts_of(is_back ? backwards(free) : free);
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        const ChainContacts::Place place = contacts.look_around(chain, k);
        if (place.distance == kInfinity) continue;
        EXPECT_NEAR(
            (contacts.term(chain, k, place).hessian - contacts.term(chain, k, place).hessian.transpose()).norm(), 0.0,
            1e-14);
        for (int number = 0; number < kLocalNumbers; ++number)
          compared[place.kind] += expect_contact_derivatives(contacts, chain, k, number);
      }
    }
  }
  // All kinds but the first one, which is none.
  for (std::size_t kind = 1; kind < compared.size(); ++kind) EXPECT_GT(compared[kind], 20) << "kind " << kind;
}

// What is moved by less than the room is not near.
TEST(ChainContacts, AreNotReachedWithinTheirRoom) {
  constexpr double kNear = 1.0;
  int moved = 0;
  for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar}) {
    ContactCases cases(kind, 6);
    for (int i = 0; i < 10; ++i) {
      const ArcChain chain = cases.next();
      const ChainContacts contacts = cases.contacts_of(chain);
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        const double room = contacts.room(chain, k, kNear);
        if (contacts.look(chain, k).distance < kInfinity || room <= 0.0) continue;
        ++moved;
        ArcChain other = chain;
        const double length = 0.999 * room;
        const Vec2 step = length * direction_of(cases.random().uniform(0.0, kTwoPi));
        for (ArcChain::Arc& arc : other.arcs) arc.center += step;
        EXPECT_GE(contacts.look(other, k).distance, kNear) << "chain " << i << " contact " << k;
      }
    }
  }
  EXPECT_GT(moved, 1000);
}

// How far the joints of arcs and lines move.
double joint_movement(const ArcChain& from, const ArcChain& to) {
  double most = 0.0;
  for (std::size_t i = 0; i < from.arcs.size(); ++i)
    for (const std::size_t line : {i, i + 1})
      most = std::max(most, (test::place_on(to, i, line) - test::place_on(from, i, line)).norm());
  return most;
}

TEST(ChainContacts, AgreeWithTheExactQuery) {
  int free = 0, touching = 0;
  for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar}) {
    ContactCases cases(kind, 5);
    for (int i = 0; i < 20; ++i) {
      const ArcChain chain = cases.next();
      for (int k = 0; k < 60; ++k) {
        const double most = std::pow(10.0, cases.random().uniform(-3.0, -0.5));
        const auto moved = randomly_moved(chain, most, cases.random());
        // Edges that the body overlaps by much are not seen.
        if (!moved || joint_movement(chain, *moved) > 0.45) continue;
        ChainContacts contacts = cases.contacts_of(chain);
        double least = kInfinity, least_of_corners = kInfinity;
        for (std::size_t c = 0; c < contacts.size(); ++c) {
          const ChainContacts::Place place = contacts.look_around(*moved, c);
          least = std::min(least, place.distance);
          if (place.kind < kFirstOfEdges) least_of_corners = std::min(least_of_corners, place.distance);
        }
        const bool is_free = cases.is_free(*moved);
        if (least > kContactError) {
          ++free;
          EXPECT_TRUE(is_free) << "chain " << i << " step " << k << " of " << most << " m, distance " << least;
        }
        // Edges count as endless behind them, corners are where they are.
        if (least_of_corners < -kContactError) {
          ++touching;
          EXPECT_FALSE(is_free) << "chain " << i << " step " << k << " of " << most << " m, distance "
                                << least_of_corners;
        }
      }
    }
  }
  EXPECT_GT(free, 300);
  EXPECT_GT(touching, 300);
}

}  // namespace
}  // namespace arcway::internal
