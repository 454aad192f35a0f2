#ifndef PaperFigures_h
#define PaperFigures_h

#include <array>
#include <string>
#include <vector>

/** A figure of the paper that shows a computation, and how it is computed here. */
struct PaperFigure
{
  std::string name;   ///< Of the file.
  std::string label;  ///< In the paper's LaTeX.
  std::string says;   ///< What the paper says about it.
  std::string domain; ///< Name of a built-in domain.
  double innerRadius; ///< Of a ring.
  std::string method; ///< One of MethodRun, or "h" for vtkHField.
  double size;        ///< Edge length.
  double epsilon;     ///< Of methods with a penalty.
  /** Rows x, y, quarter index, radius; with `propose` what vtkConfigurationProposal gives instead. */
  std::vector<std::array<double, 4>> singularities;
  bool propose = false;
};

/** In the order of the paper. */
std::vector<PaperFigure> PaperFigures();

#endif
