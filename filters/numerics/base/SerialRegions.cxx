#include "SerialRegions.h"

#include <omp.h>

namespace crossfield
{
SerialRegions::SerialRegions()
  : SavedLevels(omp_get_max_active_levels())
{
  omp_set_max_active_levels(omp_get_active_level());
}

SerialRegions::~SerialRegions()
{
  omp_set_max_active_levels(this->SavedLevels);
}
}
