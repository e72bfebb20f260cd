// Asks in bulk: the answers of one by one, whatever the order and the threads.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>
#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/fast/nearby_order.hpp>

namespace groundtruth::fast {
namespace {

constexpr int houses_along = 500;
constexpr double plot = 24;  // m, the side of the square that a house stands in

const Scene& large_town() {
  static const Scene town = compile(cases::town_of(std::size_t{houses_along} * houses_along, 1));
  return town;
}

// Short ranges, and one in sixteen is long.
std::vector<EntryAsk> scattered_asks(std::size_t count) {
  std::mt19937_64 random(1);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<EntryAsk> asks(count);
  for (EntryAsk& ask : asks) {
    ask.from = {between(0, houses_along * plot), between(0, houses_along * plot), between(0, 9)};
    const double reach = random() % 16 == 0 ? 300 : 1;
    ask.to = {ask.from[0] + between(-reach, reach), ask.from[1] + between(-reach, reach),
              ask.from[2] - between(0, 3)};
  }
  return asks;
}

std::vector<EntryAsk> hostile_asks(const groundtruth::Scene& scene, std::size_t count) {
  cases::AskSource source(scene, 5, {1, 0, 0});
  std::vector<EntryAsk> asks;
  while (asks.size() < count) asks.push_back(std::get<EntryAsk>(source.next().ask));
  return asks;
}

void expect_the_answers_of_one_by_one(const Scene& scene, const std::vector<EntryAsk>& asks,
                                      Threads threads) {
  std::vector<EntryAnswer> answers(asks.size());
  entry_points(scene, asks, answers, threads);
  for (std::size_t i = 0; i < asks.size(); ++i)
    ASSERT_EQ(answers[i], entry_point(scene, asks[i])) << i << " of " << asks.size();
}

TEST(FastBulk, GivesTheAnswersOfOneByOneInAnyScene) {
  for (const groundtruth::Scene& scene :
       {cases::house(), cases::town_of(60, 1), cases::hills_of(6), cases::runway_of(50)})
    expect_the_answers_of_one_by_one(compile(scene), hostile_asks(scene, 1003), {});
}

TEST(FastBulk, GivesTheAnswersOfOneByOneByAnyNumberOfThreads) {
  const std::vector<EntryAsk> asks = scattered_asks(20011);
  for (const unsigned count : {0U, 1U, 2U, 3U, 7U, 64U})
    expect_the_answers_of_one_by_one(large_town(), asks, {count});
  expect_the_answers_of_one_by_one(large_town(), asks, Threads::all());
}

TEST(FastBulk, BearsAnyNumberOfAsks) {
  const std::vector<EntryAsk> asks = scattered_asks(4097);
  for (const std::ptrdiff_t count : {0, 1, 255, 256, 2048, 4097})
    expect_the_answers_of_one_by_one(large_town(), {asks.begin(), asks.begin() + count}, {2});
}

TEST(NearbyOrders, NameEachOfSomeScatteredAsksOnce) {
  const std::vector<EntryAsk> asks = scattered_asks(5000);
  NearbyOrder nearby(large_town());
  const auto order = nearby.of(asks);
  std::vector<std::uint32_t> places(order.begin(), order.end()), all(asks.size());
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_NE(places, all);
  std::sort(places.begin(), places.end());
  EXPECT_EQ(places, all);
}

TEST(NearbyOrders, PutAsksOfOnePlaceTogether) {
  std::vector<EntryAsk> asks;
  for (int i = 0; i < 6400; ++i)
    asks.push_back({{plot * (i * 137 % houses_along), plot * (i * 391 % houses_along), 9}, {}});
  const auto way = [&](auto place) {
    double sum = 0;
    for (std::size_t i = 1; i < asks.size(); ++i)
      for (std::size_t axis = 0; axis < 2; ++axis)
        sum += std::abs(asks[place(i)].from[axis] - asks[place(i - 1)].from[axis]);
    return sum;
  };
  NearbyOrder nearby(large_town());
  const auto order = nearby.of(asks);
  ASSERT_EQ(order.size(), asks.size());
  EXPECT_LT(way([&](std::size_t i) { return order[i]; }), 0.1 * way([](std::size_t i) { return i; }));
}

TEST(NearbyOrders, LeaveAsksThatFollowEachOtherAndThoseOfSmallScenes) {
  std::vector<EntryAsk> wheels;
  for (int i = 0; i < 3000; ++i)
    wheels.push_back({{0.01 * i + 6.0 * (i % 3), 5.0 * (i % 2), 1}, {0.01 * i, 0, 0}});
  EXPECT_TRUE(NearbyOrder(large_town()).of(wheels).empty());
  const Scene small = compile(cases::town_of(60, 1));
  EXPECT_TRUE(NearbyOrder(small).of(scattered_asks(5000)).empty());
}

TEST(NearbyOrders, BearAsksFromAnywhere) {
  std::vector<EntryAsk> asks;
  for (int i = 0; i < 1000; ++i) {
    const double far = i % 2 == 0 ? 1e308 : -1e308;
    asks.push_back(
        {{i % 3 == 0 ? far : plot * (i * 37 % houses_along), plot * (i * 91 % houses_along), far}, {}});
  }
  EXPECT_EQ(NearbyOrder(large_town()).of(asks).size(), asks.size());
}

}  // namespace
}  // namespace groundtruth::fast
