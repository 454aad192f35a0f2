#include "Candidates.h"
#include "Error.h"
#include "PartsTrace.h"
#include "Support.h"

#include <mutex>
#include <set>
#include <vector>

namespace crossfield::test
{
namespace
{
/// Searches for the first square above a bound; a square of `wrong` is an error.
struct Search
{
  std::size_t batch;
  int bound;
  std::size_t wrong;
  std::multiset<std::size_t> evaluated{};
  std::vector<std::size_t> offered{};

  bool Run()
  {
    std::mutex mutex;
    return AcceptFirst(
      9, this->batch,
      [&](std::size_t i)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        this->evaluated.insert(i);
        if (i == this->wrong)
        {
          throw Error("wrong");
        }
        return static_cast<int>(i * i);
      },
      [&](std::size_t i, int square)
      {
        EXPECT_EQ(square, static_cast<int>(i * i));
        this->offered.push_back(i);
        return square > this->bound;
      });
  }
};

TEST(Candidates, ResultDoesNotDependOnTheBatch)
{
  for (const std::size_t batch : { 1, 2, 4, 9, 20 })
  {
    Search search{ batch, 10, 9 };
    EXPECT_TRUE(search.Run());
    EXPECT_EQ(search.offered, (std::vector<std::size_t>{ 0, 1, 2, 3, 4 }));
    Search none{ batch, 1000, 9 };
    EXPECT_FALSE(none.Run());
    EXPECT_EQ(none.offered.size(), 9u);
    EXPECT_EQ(none.evaluated, (std::multiset<std::size_t>{ 0, 1, 2, 3, 4, 5, 6, 7, 8 }));
  }
}

TEST(Candidates, EvaluatesNoneAfterTheBatchOfTheAcceptedOne)
{
  for (const std::size_t batch : { 1, 2, 4 })
  {
    Search search{ batch, 10, 9 };
    search.Run();
    EXPECT_EQ(search.evaluated.size(), std::min<std::size_t>(9, (5 + batch - 1) / batch * batch));
  }
}

TEST(Candidates, OnlyErrorsBeforeTheAcceptedOneCount)
{
  for (const std::size_t batch : { 1, 2, 9 })
  {
    Search after{ batch, 10, 5 };
    EXPECT_TRUE(after.Run());
    Search before{ batch, 10, 3 };
    EXPECT_THROW(before.Run(), Error);
    EXPECT_EQ(before.offered.size(), 3u);
  }
}

TEST(Candidates, LargeOnesAreEvaluatedOneByOne)
{
  EXPECT_EQ(CandidateBatch(1000000), 1u);
  EXPECT_GE(CandidateBatch(1000), 1u);
  const PartsTrace trace([] { EXPECT_EQ(CandidateBatch(1000), 16u); }, 16);
}

TEST(Candidates, ProgressComesFromTheCreatingThreadAndGrows)
{
  const auto creator = std::this_thread::get_id();
  std::vector<double> reported;
  const Progress progress(
    [&](double fraction)
    {
      EXPECT_EQ(std::this_thread::get_id(), creator);
      reported.push_back(fraction);
      return true;
    });
  ProgressOfParts shared(progress);
  shared.Get().Part(0.5, 1.0).Report(0.5);
  std::thread([&] { shared.Get().Report(1.0); }).join();
  shared.Get().Report(0.25);
  EXPECT_EQ(reported, (std::vector<double>{ 0.75, 0.75 }));
}

TEST(Candidates, AbortEndsThePartsOfAllThreads)
{
  const Progress progress([](double) { return false; });
  ProgressOfParts shared(progress);
  const auto isAborted = [&]
  {
    bool aborted = false;
    std::thread(
      [&]
      {
        try
        {
          shared.Get().Report(0.1);
        }
        catch (const Aborted&)
        {
          aborted = true;
        }
      })
      .join();
    return aborted;
  };
  EXPECT_FALSE(isAborted());
  EXPECT_THROW(shared.Get().Report(0.2), Aborted);
  EXPECT_TRUE(isAborted());
}
}
}
