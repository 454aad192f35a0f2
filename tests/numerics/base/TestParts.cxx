#include "Parts.h"
#include "PartsTrace.h"
#include "Support.h"
#include "ThreadLimit.h"

#include <omp.h>

#include <atomic>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>
#include <thread>

namespace crossfield::test
{
namespace
{
/// Sets the number of threads of OpenMP in a scope.
class WithThreads
{
public:
  explicit WithThreads(int count)
    : Before(omp_get_max_threads())
  {
    omp_set_num_threads(count);
  }
  ~WithThreads() { omp_set_num_threads(this->Before); }
  WithThreads(const WithThreads&) = delete;
  WithThreads& operator=(const WithThreads&) = delete;

private:
  int Before;
};

TEST(Parts, RangesCoverAllItemsOnce)
{
  for (const int items : { 0, 1, 9999, 10000, 20000, 123457, 1000000 })
  {
    const std::size_t parts = PartCount(items);
    EXPECT_GE(parts, 1u);
    EXPECT_LE(parts, MaximumPartCount);
    int next = 0;
    for (std::size_t part = 0; part < parts; ++part)
    {
      const auto [begin, end] = PartRange(items, part, parts);
      EXPECT_EQ(begin, next);
      EXPECT_TRUE(parts == 1 || end - begin >= MinimumPartSize);
      next = end;
    }
    EXPECT_EQ(next, items);
  }
  // The bound of a part does not overflow.
  EXPECT_EQ(PartRange(2000000000, 31, 32).second, 2000000000);
}

TEST(Parts, EveryPartRunsOnceAlsoInsideOfParts)
{
  for (const int threads : { 1, 2, 3, 8 })
  {
    const WithThreads with(threads);
    std::vector<std::atomic<int>> calls(20 * 30);
    ForParts(20, [&](std::size_t i) { ForParts(30, [&](std::size_t j) { ++calls[30 * i + j]; }); });
    WithAllThreads([&] { ForParts(600, [&](std::size_t i) { ++calls[i]; }); });
    for (const std::atomic<int>& count : calls)
    {
      EXPECT_EQ(count, 2);
    }
  }
}

TEST(Parts, SumsAreEqualForAnyNumberOfThreads)
{
  Random random(700);
  std::vector<double> numbers(300001);
  for (double& number : numbers)
  {
    number = std::exp(random.Uniform(-20.0, 20.0));
  }
  std::set<double> sums;
  for (const int threads : { 1, 2, 3, 4, 8, 16 })
  {
    const WithThreads with(threads);
    for (int repetition = 0; repetition < 10; ++repetition)
    {
      sums.insert(SumOfRanges(static_cast<std::ptrdiff_t>(numbers.size()),
        [&](int begin, int end)
        { return std::accumulate(numbers.begin() + begin, numbers.begin() + end, 0.0); }));
    }
  }
  EXPECT_EQ(sums.size(), 1u);
}

TEST(Parts, TheExceptionOfTheFirstFailingPartIsThrown)
{
  for (const int threads : { 1, 4 })
  {
    const WithThreads with(threads);
    std::atomic<int> calls = 0;
    try
    {
      ForParts(16,
        [&](std::size_t part)
        {
          ++calls;
          if (part >= 5)
          {
            throw part;
          }
        });
      ADD_FAILURE() << "nothing was thrown";
    }
    catch (const std::size_t& part)
    {
      EXPECT_EQ(part, 5u);
    }
    EXPECT_EQ(calls, 16); // the others run to their end
    EXPECT_THROW(WithAllThreads([] { throw 1; }), int);
  }
}

TEST(Parts, TheCallingThreadCallsWithAllThreads)
{
  const WithThreads with(4);
  const std::thread::id caller = std::this_thread::get_id();
  for (int repetition = 0; repetition < 20; ++repetition)
  {
    WithAllThreads([&] { EXPECT_EQ(std::this_thread::get_id(), caller); });
  }
}

TEST(Parts, RunInSeveralThreadsOfTheHost)
{
  const WithThreads with(2);
  std::vector<std::thread> hosts;
  std::vector<double> sums(4);
  for (std::size_t host = 0; host < sums.size(); ++host)
  {
    hosts.emplace_back(
      [&sums, host]
      {
        for (int repetition = 0; repetition < 50; ++repetition)
        {
          sums[host] = SumOfRanges(100000, [](int begin, int end) { return 1.0 * (end - begin); });
        }
      });
  }
  for (std::thread& host : hosts)
  {
    host.join();
  }
  EXPECT_EQ(sums, std::vector<double>(4, 100000.0));
}

/// Uses the processor for some seconds.
void Work(double seconds)
{
  const auto now = []
  {
    timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  for (const double end = now() + seconds; now() < end;)
  {
  }
}

TEST(PartsTrace, SchedulesPartsOnProcessors)
{
  // 10 ms alone, 8 parts of 10 ms, the last of which has 4 parts of 10 ms itself, and 10 ms alone.
  const PartsTrace trace(
    []
    {
      Work(0.01);
      ForParts(8,
        [](std::size_t part)
        {
          Work(0.01);
          if (part == 7)
          {
            ForParts(4, [](std::size_t) { Work(0.01); });
          }
        });
      Work(0.01);
    });
  constexpr double Tolerance = 0.004; // of the clock, and of other programs on the processor
  EXPECT_NEAR(trace.TotalSeconds(), 0.14, Tolerance);
  EXPECT_NEAR(trace.SerialSeconds(), 0.02, Tolerance);
  EXPECT_NEAR(trace.SecondsOn(2), 0.08, Tolerance);
  EXPECT_NEAR(trace.SecondsOn(4), 0.05, Tolerance);
  EXPECT_NEAR(trace.SecondsOn(8), 0.04, Tolerance);
  EXPECT_NEAR(trace.SecondsOn(1000), 0.04, Tolerance);
  EXPECT_EQ(PartsTrace::Active(), nullptr);
  EXPECT_THROW(PartsTrace([] { ForParts(2, [](std::size_t) { throw 1; }); }), int);
  EXPECT_EQ(PartsTrace::Active(), nullptr);
}

/// Writes files that describe control groups below a temporary folder.
class GroupFiles
{
public:
  GroupFiles()
  {
    std::filesystem::create_directories(this->Folder / "self");
    this->Files.process = this->Folder;
    this->Files.controlGroups = this->Folder;
  }
  ~GroupFiles() { std::filesystem::remove_all(this->Folder); }
  GroupFiles(const GroupFiles&) = delete;
  GroupFiles& operator=(const GroupFiles&) = delete;

  void Write(const std::string& file, const std::string& text) const
  {
    std::filesystem::create_directories((this->Folder / file).parent_path());
    std::ofstream(this->Folder / file) << text;
  }

  SystemFiles Files;

private:
  std::filesystem::path Folder =
    std::filesystem::temp_directory_path() / ("crossfield-groups-" + std::to_string(getpid()));
};

TEST(ThreadLimit, IsAtMostTheNumberThatTheUserSets)
{
  for (const int threads : { 1, 2, 5 })
  {
    const WithThreads with(threads);
    EXPECT_LE(ThreadLimit(), threads);
    EXPECT_GE(ThreadLimit(), 1);
  }
}

TEST(ThreadLimit, IsAtMostTheNumbersOfTheScopes)
{
  const WithThreads with(5);
  const int before = ThreadLimit();
  {
    const WithThreadLimit three(3);
    EXPECT_EQ(ThreadLimit(), std::min(before, 3));
    {
      const WithThreadLimit one(1);
      const WithThreadLimit four(4);
      EXPECT_EQ(ThreadLimit(), 1);
      // Other threads of the host have limits of their own.
      std::thread(
        [before]
        {
          omp_set_num_threads(5);
          EXPECT_EQ(ThreadLimit(), before);
        })
        .join();
      const std::thread::id caller = std::this_thread::get_id();
      ForParts(20, [caller](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), caller); });
    }
    EXPECT_EQ(ThreadLimit(), std::min(before, 3));
  }
  EXPECT_EQ(ThreadLimit(), before);
}

TEST(ThreadLimit, ReadsQuotasOfVersion2)
{
  const GroupFiles groups;
  EXPECT_EQ(ProcessorQuota(groups.Files), 0);
  groups.Write("self/cgroup", "0::/slice/container\n");
  EXPECT_EQ(ProcessorQuota(groups.Files), 0);
  groups.Write("slice/container/cpu.max", "max 100000\n");
  EXPECT_EQ(ProcessorQuota(groups.Files), 0);
  groups.Write("slice/container/cpu.max", "350000 100000\n");
  EXPECT_EQ(ProcessorQuota(groups.Files), 4);
  groups.Write("slice/cpu.max", "20000 100000\n");
  EXPECT_EQ(ProcessorQuota(groups.Files), 1);
}

TEST(ThreadLimit, ReadsQuotasOfVersion1)
{
  const GroupFiles groups;
  groups.Write("self/cgroup", "4:memory:/a\n3:cpu,cpuacct:/a\n");
  groups.Write("cpu/a/cpu.cfs_quota_us", "-1\n");
  groups.Write("cpu/a/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(ProcessorQuota(groups.Files), 0);
  groups.Write("cpu/cpu.cfs_quota_us", "200000\n");
  groups.Write("cpu/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(ProcessorQuota(groups.Files), 2);
}
}
}
