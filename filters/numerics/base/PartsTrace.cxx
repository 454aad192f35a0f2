#include "PartsTrace.h"

#include <ctime>

#include <deque>
#include <map>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
thread_local PartsTrace* active = nullptr;

double ThreadSeconds()
{
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
}

PartsTrace::PartsTrace(const std::function<void()>& function, int processors)
  : ProcessorCount(processors)
{
  active = this;
  this->Begin = ThreadSeconds();
  try
  {
    function();
  }
  catch (...)
  {
    active = nullptr;
    throw;
  }
  this->EndSection();
  active = nullptr;
}

PartsTrace* PartsTrace::Active()
{
  return active;
}

void PartsTrace::EndSection()
{
  const double now = ThreadSeconds();
  this->Present->sections.push_back({ now - this->Begin, {} });
  this->Begin = now;
}

void PartsTrace::Run(std::size_t parts, const std::function<void(std::size_t)>& function)
{
  this->EndSection();
  Work* const before = this->Present;
  std::vector<Work> works(parts);
  for (std::size_t part = 0; part < parts; ++part)
  {
    this->Present = &works[part];
    function(part);
    this->EndSection();
  }
  this->Present = before;
  before->sections.back().parts = std::move(works);
}

double PartsTrace::TotalSeconds() const
{
  return this->SecondsOn(1);
}

double PartsTrace::SerialSeconds() const
{
  return std::accumulate(this->Root.sections.begin(), this->Root.sections.end(), 0.0,
    [](double sum, const Section& section) { return sum + section.seconds; });
}

/// List schedule: works that wait for a processor, and those that run, by the time at which their
/// present section ends.
struct PartsTrace::Schedule
{
  struct Running
  {
    const Work* work = nullptr;
    Running* parent = nullptr;
    std::size_t section = 0;
    std::size_t open = 0; ///< Number of parts of the present section that have not finished.
  };

  std::deque<Running> all; // addresses stay valid
  std::deque<Running*> ready;
  std::multimap<double, Running*> ends;

  Running* Add(const Work& work, Running* parent)
  {
    this->all.push_back({ &work, parent, 0, 0 });
    return &this->all.back();
  }
};

double PartsTrace::SecondsOn(int processors) const
{
  Schedule schedule;
  schedule.ready.push_back(schedule.Add(this->Root, nullptr));
  double now = 0.0;
  while (!schedule.ready.empty() || !schedule.ends.empty())
  {
    while (!schedule.ready.empty() && static_cast<int>(schedule.ends.size()) < processors)
    {
      Schedule::Running* const next = schedule.ready.front();
      schedule.ready.pop_front();
      schedule.ends.emplace(now + next->work->sections[next->section].seconds, next);
    }
    Schedule::Running* ended = schedule.ends.begin()->second;
    now = schedule.ends.begin()->first;
    schedule.ends.erase(schedule.ends.begin());
    const Section& section = ended->work->sections[ended->section];
    ended->open = section.parts.size();
    for (const Work& part : section.parts)
    {
      schedule.ready.push_back(schedule.Add(part, ended));
    }
    // Without parts it continues; a work that ends lets its parent continue after the last part.
    while (ended != nullptr && ended->open == 0)
    {
      if (++ended->section < ended->work->sections.size())
      {
        schedule.ready.push_front(ended);
        break;
      }
      ended = ended->parent;
      if (ended != nullptr)
      {
        --ended->open;
      }
    }
  }
  return now;
}
}
