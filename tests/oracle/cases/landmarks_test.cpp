#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <groundtruth/cases/aim.hpp>
#include <groundtruth/cases/landmarks.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

#include "exact_checks.hpp"

namespace groundtruth::cases {
namespace {

using testing::delta;
using testing::exactly;

std::set<Vector> corner_points(const DetailedPiece& piece) {
  std::set<Vector> points;
  for (const Corner& corner : piece.corners) points.insert(corner.point);
  return points;
}

TEST(Landmarks, CornersOfTheHouseAreItsTenCorners) {
  const std::set<Vector> expected{{3, 4, 0},  {-3, 4, 0}, {3, -4, 0},  {-3, -4, 0}, {3, 4, 4},
                                  {-3, 4, 4}, {3, -4, 4}, {-3, -4, 4}, {0, 4, 7},   {0, -4, 7}};
  EXPECT_EQ(corner_points(detail(survey(house()), 0)), expected);
}

TEST(Landmarks, BoundsOfTheHouseAreAMetreWider) {
  const Landmarks landmarks = survey(house());
  EXPECT_EQ(landmarks.low, (Vector{-4, -5, -1}));
  EXPECT_EQ(landmarks.high, (Vector{4, 5, 8}));
}

TEST(Landmarks, RunwayHasTwoSeamsBetweenNeighbours) {
  const Landmarks landmarks = survey(runway_of(10));
  EXPECT_EQ(landmarks.pieces.size(), 11u);  // the patch counts
  EXPECT_EQ(landmarks.seams.size(), 18u);
  for (const Seam& seam : landmarks.seams) {
    const auto apart = static_cast<long>(seam.piece) - static_cast<long>(seam.other_piece);
    EXPECT_EQ(std::abs(apart), 1);
  }
}

TEST(Landmarks, EveryHouseOnTheGroundIsASeamSeenFromTheHouse) {
  const std::size_t houses = 50;
  const Landmarks landmarks = survey(town_of(houses, 1));
  std::set<std::size_t> floors;
  for (const Seam& seam : landmarks.seams) {
    const HalfSpace& plane = landmarks.pieces[seam.piece][seam.plane];
    if (plane.normal == Vector{0, 0, -1}) floors.insert(seam.piece);
    EXPECT_GT(landmarks.pieces[seam.piece].size(), 1u) << "seen from the ground, which has no corners there";
  }
  EXPECT_EQ(floors.size(), houses);
}

TEST(Landmarks, InnerHillsHaveThreeNeighbours) {
  const std::size_t cells = 4;
  const Landmarks landmarks = survey(hills_of(cells));
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const Seam& seam : landmarks.seams) pairs.insert({seam.piece, seam.other_piece});
  // Touching bounds let in pairs that meet in a point, so this is a floor: 16 diagonals, 24 sides, both ways.
  EXPECT_GE(pairs.size(), 2 * (cells * cells + 2 * cells * (cells - 1)));
}

TEST(Landmarks, ASceneWithoutPlanesStillHasATarget) {
  for (const Shape& shape : {union_of({}), intersection_of({}), half_space(0, 0, 0, 1)}) {
    const Landmarks landmarks = survey({{}, shape});
    ASSERT_FALSE(landmarks.pieces.empty());
    EXPECT_FALSE(detail(landmarks, 0).corners.empty());
  }
}

TEST(Landmarks, PlanesOfExtremeLengthMeetWhereTheirUnitPlanesDo) {
  const Shape cube = intersection_of({half_space(-0x1p-1000, 0, 0, 0), half_space(0x1p1000, 0, 0, 0x1p1000),
                                      half_space(0, -0x1p-1060, 0, 0), half_space(0, 1, 0, 1),
                                      half_space(0, 0, -0x1p1000, 0), half_space(0, 0, 3, 3)});
  const std::set<Vector> expected{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1},
                                  {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}};
  EXPECT_EQ(corner_points(detail(survey({{}, cube}), 0)), expected);
}

TEST(Aim, PointsAreExactlyOnTheirFacesWhereScenesAreShort) {
  Random random(1);
  for (const Scene& scene : {house(), runway_of(9), hills_of(5), ramp()}) {
    const Landmarks landmarks = survey(scene);
    for (int i = 0; i < 300; ++i) {
      const DetailedPiece piece = pick_piece(landmarks, random);
      const FacePoint face = on_a_face(piece, random);
      EXPECT_EQ(delta(face.plane, exactly(face.point)), 0);
      const FacePoint corner = at_a_corner(piece, random);
      EXPECT_EQ(delta(corner.plane, exactly(corner.point)), 0);
      const EdgePoint edge = on_an_edge(piece, random);
      EXPECT_EQ(delta(edge.plane, exactly(edge.point)), 0);
      EXPECT_EQ(testing::dot(exactly(edge.plane.normal), exactly(edge.direction)), 0);
    }
  }
}

TEST(Aim, EdgesOfTheHouseLieInTwoOfItsPlanesAndInTheHouse) {
  Random random(2);
  const Landmarks landmarks = survey(house());
  const DetailedPiece piece = detail(landmarks, 0);
  for (int i = 0; i < 300; ++i) {
    const EdgePoint edge = on_an_edge(piece, random);
    int touched = 0;
    for (const HalfSpace& plane : landmarks.pieces[0]) {
      EXPECT_LE(delta(plane, exactly(edge.point)), 0);
      touched += delta(plane, exactly(edge.point)) == 0;
    }
    EXPECT_GE(touched, 2);
  }
}

TEST(Aim, FootholdsMostlyFaceUp) {
  Random random(3);
  const Landmarks landmarks = survey(town_of(100, 1));
  int up = 0;
  for (int i = 0; i < 500; ++i) up += foothold(landmarks, random).plane.normal[2] > 0;
  EXPECT_GT(up, 400);
}

TEST(Aim, DirectionsInAPlaneAreExactAndNotZero) {
  Random random(4);
  for (const Vector& normal : {Vector{0, 0, 1}, Vector{3, -4, 5}, Vector{0, 2, 0}, Vector{1, 0, 1}}) {
    for (int i = 0; i < 5000; ++i) {
      const Vector direction = direction_in_plane(normal, random);
      EXPECT_NE(direction, Vector{});
      EXPECT_EQ(testing::dot(exactly(normal), exactly(direction)), 0);
    }
  }
}

}  // namespace
}  // namespace groundtruth::cases
