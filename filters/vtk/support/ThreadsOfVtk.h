#ifndef ThreadsOfVtk_h
#define ThreadsOfVtk_h

/**
 * Returns the number of threads that VTK's filters may use: that of the SMP backend
 * (`vtkSMPTools::Initialize`, `VTK_SMP_MAX_THREADS`), and 1 inside of a parallel loop of VTK. Where
 * the backend is Sequential because VTK was built so, as in Debian's ParaView, it is not a limit:
 * then the result is the largest int, unless one of the variables of the environment
 * `VTK_SMP_BACKEND_IN_USE` and `VTK_SMP_MAX_THREADS` is set.
 */
int ThreadsOfVtk();

#endif
