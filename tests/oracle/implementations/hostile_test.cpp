// Whatever an implementation does: one reply an ask, of the right kind, in time, and no process left.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "command.hpp"

namespace groundtruth::implementations::test {
namespace {

constexpr std::size_t number_of_asks = 6;
constexpr std::size_t poison = 2;

struct Expected {
  std::string vice;
  std::string kinds;   // of six asks at once; the third is the poison
  std::string detail;  // of the first failure: a part of it
};

std::ostream& operator<<(std::ostream& out, const Expected& expected) { return out << expected.vice; }

std::string first_detail(const std::vector<Reply>& replies) {
  for (const Reply& reply : replies) {
    if (reply.kind != ReplyKind::answered) return reply.detail;
  }
  return {};
}

class Hostile : public testing::TestWithParam<Expected> {
 protected:
  void TearDown() override {
    EXPECT_EQ(processes_left(), std::vector<std::string>{});
    EXPECT_EQ(open_descriptors(), descriptors_before_);
    EXPECT_LT(std::chrono::steady_clock::now() - start_, std::chrono::seconds(20));
  }

 private:
  std::size_t descriptors_before_ = open_descriptors();
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

TEST_P(Hostile, GivesOneReplyAnAskAndLeavesNoProcess) {
  const auto hostile_one = subject(run_command(hostile(GetParam().vice), short_patience));
  const auto replies = hostile_one->ask(ground(), asks(number_of_asks, poison));
  EXPECT_EQ(kinds(replies), GetParam().kinds);
  EXPECT_NE(first_detail(replies).find(GetParam().detail), std::string::npos) << first_detail(replies);
  EXPECT_EQ(first_detail(replies).find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    AtOnce, Hostile,
    testing::Values(Expected{"none", "aaaaaa", ""},                                                 //
                    Expected{"exits-at-once", "cccccc", "exited with code 3"},                      //
                    Expected{"crashes-at-once", "cccccc", "signal 11"},                             //
                    Expected{"crashes-at-poison", "aacaaa", "signal 11 (Segmentation fault)"},      //
                    Expected{"crashes-at-third", "aacaca", "only with more asks in flight"},        //
                    Expected{"crashes-in-batches", "caaaaa", "only with more asks in flight"},      //
                    Expected{"crashes-in-mid-line", "aacaaa", "in the middle of a line: {\"id\""},  //
                    Expected{"hangs-at-once", "hhhhhh", "flush"},                                   //
                    Expected{"hangs-at-poison", "aahaaa", "no answer within 800 ms"},               //
                    Expected{"hangs-with-answers-kept", "aahaaa", "no answer within 800 ms"},
                    Expected{"hangs-in-batches", "haaaaa", "only with more asks in flight"},
                    Expected{"stops-at-poison", "aahaaa", "no answer within 800 ms"},            //
                    Expected{"answers-late", "aahaaa", "is it slow"},                            //
                    Expected{"never-flushes", "hhhhhh", "flush"},                                //
                    Expected{"floods-output", "aauaaa", "longer than"},                          //
                    Expected{"floods-lines", "aahaaa", "no answer"},                             //
                    Expected{"floods-errors", "aaaaaa", ""},                                     //
                    Expected{"says-garbage", "aauaaa", "not JSON"},                              //
                    Expected{"says-garbage-too", "aauaaa", "not JSON"},                          //
                    Expected{"says-utf16", "aauaaa", "NUL"},                                     //
                    Expected{"says-binary", "aauaaa", ""},                                       //
                    Expected{"says-nan", "aauaaa", "not JSON"},                                  //
                    Expected{"says-1e999", "aauaaa", "answer.lambda: 1e999 lies outside"},       //
                    Expected{"repeats-keys", "aauaaa", "answer"},                                //
                    Expected{"nests-deeply", "aauaaa", "nested deeper"},                         //
                    Expected{"names-no-leaf", "aauaaa", "answer.leaf: -1"},                      //
                    Expected{"gives-other-id", "aauaaa", "its id, \"b1\", is none of those"},    //
                    Expected{"refuses", "aaraaa", "too hard for me"},                            //
                    Expected{"swaps-answers", "uauaua", "out of order"},                         //
                    Expected{"skips-poison", "aauaaa", "out of order"},                          //
                    Expected{"answers-twice", "aauaaa", "answered again"},                       //
                    Expected{"answers-too-many", "aaauaa", "its id, \"c1\", is none of those"},  //
                    Expected{"stops-after-two", "aacaca", "exited with code 0"},                 //
                    Expected{"answers-before", "uaaaaa", "before it was asked came"},            //
                    Expected{"closes-output", "aacaaa", "closed its standard output"},           //
                    Expected{"closes-input", "aaahaa", "no answer"},                             //
                    Expected{"ignores-the-end", "aaaaaa", ""},                                   //
                    Expected{"drips", "aaaaaa", ""},                                             //
                    Expected{"claims-unknown-kinds", "aaaaaa", ""},                              //
                    Expected{"has-huge-name", "aaaaaa", ""},                                     //
                    Expected{"greets-strangely", "aaaaaa", ""},                                  //
                    Expected{"knows-no-hello", "aaaaaa", ""},                                    //
                    Expected{"prints-a-banner", "uaaaaa", "Welcome!"},                           //
                    Expected{"dies-of-hello", "aaaaaa", ""},                                     //
                    Expected{"leaves-daemons", "aaaaaa", ""},                                    //
                    Expected{"leaves-daemon-and-crashes", "aacaaa", "signal 11"},                //
                    Expected{"kills-its-parent", "aacaaa", "signal 9"}),
    [](const auto& test) {
      std::string name;
      for (const char character : test.param.vice) name += character == '-' ? '_' : character;
      return name;
    });

// Asked one by one, the vice is the poison's alone.
class HostileToOne : public testing::TestWithParam<const char*> {};

TEST_P(HostileToOne, IsBlamedForThePoisonOnly) {
  const auto hostile_one = subject(run_command(hostile(GetParam()), short_patience));
  const std::vector<Ask> all = asks(number_of_asks, poison);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto replies = hostile_one->ask(ground(), {&all[i], 1});
    ASSERT_EQ(replies.size(), 1U);
    EXPECT_EQ(replies[0].kind != ReplyKind::answered, i == poison) << i << ": " << replies[0].detail;
  }
}

INSTANTIATE_TEST_SUITE_P(OneByOne, HostileToOne,
                         testing::Values("crashes-at-poison", "hangs-at-poison", "answers-late",
                                         "floods-output", "says-garbage", "says-garbage-too", "answers-twice",
                                         "answers-too-many", "refuses", "skips-poison", "closes-output",
                                         "leaves-daemon-and-crashes"));

TEST(HostileMemory, StaysBoundedUnderFloods) {
  const auto peak_of_memory = [] {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;  // KiB
  };
  const auto before = peak_of_memory();
  for (const char* vice : {"floods-output", "floods-lines", "floods-errors"}) {
    const auto flooding = subject(run_command(hostile(vice), short_patience));
    flooding->ask(ground(), asks(number_of_asks, poison));
    EXPECT_LE(flooding->last_words().size(), std::size_t{1} << 16);
  }
  EXPECT_LT(peak_of_memory() - before, 64 * 1024);
}

}  // namespace
}  // namespace groundtruth::implementations::test
