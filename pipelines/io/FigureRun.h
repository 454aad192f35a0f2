#ifndef FigureRun_h
#define FigureRun_h

#include <string>

class OutputTransaction;
struct PaperFigure;

/** Numbers of a figure that was computed. */
struct FigureResult
{
  double energy;
  int iterations;
  bool converged;
  int unwanted;      ///< Number of unwanted singularities.
  std::string found; ///< Singularities of the field, as "4 x +1, 1 x -1".
};

/** Computes a figure and writes its field to FOLDER/NAME.vtu. Throws PipelineRun::Error. */
FigureResult ComputeFigure(
  const PaperFigure& figure, const std::string& folder, OutputTransaction& outputs);

#endif
