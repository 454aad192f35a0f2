#include "Candidates.h"

namespace crossfield
{
std::size_t CandidateBatch(std::size_t elements)
{
  return elements >= 2 * MinimumPartSize ? 1 : static_cast<std::size_t>(ThreadsOfParts());
}

ProgressOfParts::ProgressOfParts(const Progress& progress)
  : Whole(progress)
{
}

Progress ProgressOfParts::Get()
{
  return Progress(
    [this](double fraction)
    {
      if (std::this_thread::get_id() != this->Creator || this->IsAborted)
      {
        return !this->IsAborted;
      }
      try
      {
        this->Last = std::max(this->Last, fraction);
        this->Whole.Report(this->Last);
      }
      catch (const Aborted&)
      {
        this->IsAborted = true;
      }
      return !this->IsAborted;
    });
}
}
