#pragma once

namespace crossfield
{
/// Gives OpenBLAS the kernels of this processor where it does not know them by itself; later calls do nothing.
///
/// OpenBLAS chooses by lists of processors when it is loaded. One that is newer than the lists gets those of
/// Prescott, of 2004, though it has AVX2 or AVX-512: dense factorisations then take more than twice as long.
/// Nothing is changed where OPENBLAS_CORETYPE is set or OpenBLAS has found other kernels.
///
/// The kernels of the process change: no other thread may be inside OpenBLAS at the first call.
void ChooseBlasKernels();
}
