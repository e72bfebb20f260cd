// Does each flavour have the property of its name, exactly? In scenes of short dyadics always, except where
// the test says how often.

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/entry_flavours.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

#include "exact_checks.hpp"

namespace groundtruth::cases {
namespace {

using testing::delta;
using testing::exactly;
using testing::minus;
using testing::point_at;
using testing::RationalVector;

constexpr int tries = 300;

using Make = EntryAsk(const Landmarks&, Random&);
using Property = std::function<bool(const EntryAsk&)>;

int count(Make* make, const Scene& scene, const Property& property) {
  const Landmarks landmarks = survey(scene);
  int having = 0;
  for (int i = 0; i < tries; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    having += property(make(landmarks, random));
  }
  return having;
}

std::vector<Scene> short_scenes() { return {house(), runway_of(9), hills_of(4), ramp()}; }

// The number of planes of the scene that hold the point.
int planes_at(const std::vector<HalfSpace>& planes, const RationalVector& point) {
  return static_cast<int>(std::count_if(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
    return plane.normal != Vector{} && delta(plane, point) == 0;
  }));
}

bool is_collinear(const EntryAsk& ask, const Vector& point) {
  const RationalVector along = minus(exactly(ask.to), exactly(ask.from));
  return testing::is_zero(testing::cross(along, minus(exactly(point), exactly(ask.from))));
}

TEST(EntryInFacePlane, BothEndsAreInOnePlane) {
  for (const Scene& scene : short_scenes()) {
    const std::vector<HalfSpace> planes = testing::half_spaces_of(scene.shape);
    const Property in_a_plane = [&](const EntryAsk& ask) {
      return std::any_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
        return delta(plane, exactly(ask.from)) == 0 && delta(plane, exactly(ask.to)) == 0;
      });
    };
    EXPECT_EQ(count(entry_in_face_plane, scene, in_a_plane), tries);
  }
}

TEST(EntryInFacePlane, IsExactForMostOfATownAndOfAFarTown) {
  const Scene town = town_of(40, 1);
  for (const Scene& scene : {town, find_builtin_scene("far-town")->build()[0]}) {
    const std::vector<HalfSpace> planes = testing::half_spaces_of(scene.shape);
    const Property in_a_plane = [&](const EntryAsk& ask) {
      return std::any_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
        return delta(plane, exactly(ask.from)) == 0 && delta(plane, exactly(ask.to)) == 0;
      });
    };
    EXPECT_GT(count(entry_in_face_plane, scene, in_a_plane), tries * 7 / 10);
  }
}

TEST(EntryThroughCorner, LineHitsACornerOfTheHouse) {
  const std::vector<Vector> corners{{3, 4, 0},  {-3, 4, 0}, {3, -4, 0},  {-3, -4, 0}, {3, 4, 4},
                                    {-3, 4, 4}, {3, -4, 4}, {-3, -4, 4}, {0, 4, 7},   {0, -4, 7}};
  const Property hits = [&](const EntryAsk& ask) {
    return std::any_of(corners.begin(), corners.end(),
                       [&](const Vector& corner) { return is_collinear(ask, corner); });
  };
  EXPECT_EQ(count(entry_through_corner, house(), hits), tries);
}

// Where the line meets the first plane, it meets another one too.
bool passes_an_edge(const std::vector<HalfSpace>& planes, const EntryAsk& ask) {
  const RationalVector from = exactly(ask.from);
  const RationalVector along = minus(exactly(ask.to), from);
  for (const HalfSpace& plane : planes) {
    const testing::Rational speed = testing::dot(exactly(plane.normal), along);
    if (speed == 0) continue;
    const testing::Rational lambda = -delta(plane, from) / speed;
    const RationalVector point{from[0] + lambda * along[0], from[1] + lambda * along[1],
                               from[2] + lambda * along[2]};
    const bool in_house = std::all_of(planes.begin(), planes.end(),
                                      [&](const HalfSpace& other) { return delta(other, point) <= 0; });
    if (in_house && planes_at(planes, point) >= 2) return true;
  }
  return false;
}

TEST(EntryThroughEdge, LineHitsAnEdgeOfTheHouse) {
  const std::vector<HalfSpace> planes = testing::half_spaces_of(house().shape);
  const Property hits = [&](const EntryAsk& ask) { return passes_an_edge(planes, ask); };
  EXPECT_EQ(count(entry_through_edge, house(), hits), tries);
}

TEST(EntryAlongEdge, BothEndsAreInTwoPlanes) {
  const std::vector<HalfSpace> planes = testing::half_spaces_of(house().shape);
  const Property along = [&](const EntryAsk& ask) {
    return std::count_if(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
             return delta(plane, exactly(ask.from)) == 0 && delta(plane, exactly(ask.to)) == 0;
           }) == 2;
  };
  EXPECT_EQ(count(entry_along_edge, house(), along), tries);
}

TEST(EntryStarts, RangeStartsOnAPlaneAnEdgeOrACorner) {
  for (const Scene& scene : {house(), ramp()}) {
    const std::vector<HalfSpace> planes = testing::half_spaces_of(scene.shape);
    const auto starts_on = [&](int at_least) {
      return Property([&planes, at_least](const EntryAsk& ask) {
        return planes_at(planes, point_at(ask, ask.lambda_first)) >= at_least;
      });
    };
    EXPECT_EQ(count(entry_start_on_face, scene, starts_on(1)), tries);
    EXPECT_EQ(count(entry_start_on_edge, scene, starts_on(2)), tries);
    EXPECT_EQ(count(entry_start_on_corner, scene, starts_on(3)), tries);
    EXPECT_EQ(count(entry_instant, scene, starts_on(1)), tries);
  }
}

TEST(EntryStarts, InsideTheHouseIsInTheHouse) {
  const std::vector<HalfSpace> planes = testing::half_spaces_of(house().shape);
  const Property in_house = [&](const EntryAsk& ask) {
    return std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
      return delta(plane, point_at(ask, ask.lambda_first)) <= 0;
    });
  };
  EXPECT_EQ(count(entry_start_inside, house(), in_house), tries);
}

TEST(EntryEnds, RangeEndsOnAPlane) {
  const std::vector<HalfSpace> planes = testing::half_spaces_of(house().shape);
  const Property ends = [&](const EntryAsk& ask) {
    return planes_at(planes, point_at(ask, ask.lambda_last)) >= 1;
  };
  EXPECT_GE(count(entry_end_on_border, house(), ends), tries * 9 / 10);  // crossings may be inexact
}

TEST(EntrySeams, AlongASeamOfTheRunwayBothEndsAreInAPlaneBetweenBoxes) {
  const Property between_boxes = [](const EntryAsk& ask) {
    const double x = ask.from[0];
    return x == ask.to[0] && x > 0 && x < 90 && x == 10 * std::round(x / 10);
  };
  EXPECT_EQ(count(entry_along_seam, runway_of(9), between_boxes), tries);
}

TEST(EntrySeams, OverASeamOfTheRunwayTheFaceIsNotLeft) {
  const Scene runway = runway_of(9);
  const std::vector<HalfSpace> planes = testing::half_spaces_of(runway.shape);
  const Property in_face = [&](const EntryAsk& ask) {
    return std::any_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
      return plane.normal[0] == 0 && delta(plane, exactly(ask.from)) == 0 &&
             delta(plane, exactly(ask.to)) == 0;
    });
  };
  EXPECT_EQ(count(entry_over_seam, runway, in_face), tries);
}

TEST(EntryPoint, IsAPoint) {
  EXPECT_EQ(count(entry_point, house(), [](const EntryAsk& ask) { return ask.from == ask.to; }), tries);
}

TEST(EntryInstant, IsAnInstant) {
  const Property is_instant = [](const EntryAsk& ask) { return ask.lambda_first == ask.lambda_last; };
  EXPECT_EQ(count(entry_instant, house(), is_instant), tries);
}

TEST(EntryStrut, IsAboutVerticalAndOneToThreeMetresLong) {
  const Property is_strut = [](const EntryAsk& ask) {
    const double drop = ask.from[2] - ask.to[2];
    return drop > 0.99 && drop < 3.01 &&
           std::hypot(ask.from[0] - ask.to[0], ask.from[1] - ask.to[1]) < drop / 3;
  };
  EXPECT_EQ(count(entry_strut, hills_of(4), is_strut), tries);
}

TEST(EntryFromAfar, StartsFarAwayAndAimsAtTheHouse) {
  const Property is_far = [](const EntryAsk& ask) {
    return std::hypot(ask.from[0], ask.from[1], ask.from[2]) > 1e4;
  };
  EXPECT_EQ(count(entry_from_afar, house(), is_far), tries);
}

TEST(EntryRanges, AreNegativeBeyondOneOrTinyNowAndThen) {
  const Landmarks landmarks = survey(house());
  int negative = 0, beyond = 0, tiny = 0, usual = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Random random(i);
    const EntryAsk ask = entry_through_corner(landmarks, random);
    negative += ask.lambda_first < 0;
    beyond += ask.lambda_last > 1;
    tiny += ask.lambda_last > ask.lambda_first && ask.lambda_last - ask.lambda_first < 1e-3;
    usual += ask.lambda_first == 0 && ask.lambda_last == 1;
  }
  EXPECT_GT(negative, 100);
  EXPECT_GT(beyond, 50);
  EXPECT_GT(tiny, 20);
  EXPECT_GT(usual, 2000);
}

}  // namespace
}  // namespace groundtruth::cases
