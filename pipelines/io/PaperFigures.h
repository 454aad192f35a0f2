#ifndef PaperFigures_h
#define PaperFigures_h

#include <array>
#include <string>
#include <vector>

/** Figure of the paper that shows a computation, and its parameters here. */
struct PaperFigure
{
  std::string name;   ///< Name of the file.
  std::string label;  ///< Label in the LaTeX source of the paper.
  std::string says;   ///< Statement of the paper about it.
  std::string domain; ///< Name of a built-in domain.
  double innerRadius; ///< Inner radius of a ring.
  std::string method; ///< Method of MethodRun, or "h" for vtkHField.
  double size;        ///< Edge length.
  double epsilon;     ///< Length in the penalty of methods that have one.
  /** Rows x, y, quarter index, radius; with `propose`, vtkConfigurationProposal is used instead. */
  std::vector<std::array<double, 4>> singularities;
  bool propose = false;
};

/** Returns the figures in the order of the paper. */
std::vector<PaperFigure> PaperFigures();

#endif
