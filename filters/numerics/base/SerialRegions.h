#pragma once

namespace crossfield
{
/// While it exists, parallel regions of OpenMP that this thread opens have one thread. CHOLMOD asks for four in every small
/// loop, whatever OMP_NUM_THREADS says, and on fewer processors these wait for each other: with
/// OMP_NUM_THREADS=1, where no region of ours is around them, a second became minutes.
class SerialRegions
{
public:
  SerialRegions();
  ~SerialRegions();
  SerialRegions(const SerialRegions&) = delete;
  SerialRegions& operator=(const SerialRegions&) = delete;

private:
  int Before;
};
}
