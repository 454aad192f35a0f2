#ifndef QuadReport_h
#define QuadReport_h

#include "DomainPlane.h"
#include "QuadWorkflow.h"

#include <string>

class vtkFieldData;

/** Numbers and sentences about a quad mesh. */
namespace QuadReport
{
/** Adds the field data of vtkQuadMesher. */
void Write(
  const crossfield::QuadResult& result, const crossfield::DomainPlane& plane, vtkFieldData* data);

/** Writes the numbers of blocks that were computed. */
void WriteBlockCounts(const crossfield::BlockCounts& counts, vtkFieldData* data);

/** Writes the measures of layers, one tuple for each; nothing if there are none. */
void WriteLayers(const std::vector<crossfield::LayerReport>& layers, vtkFieldData* data);

/** Writes the measures of curves, one tuple for each; nothing if there are none. */
void WriteCurves(const crossfield::QuadWorkflowResult& result, vtkFieldData* data);

/** Writes the meshes of the configurations that were chosen, if there are several. */
void WriteAlternatives(
  const std::vector<crossfield::Alternative>& alternatives, vtkFieldData* data);

/** Writes how closely target sizes are met; nothing if there are none. */
void WriteSizes(const std::optional<crossfield::SizeReport>& sizes, vtkFieldData* data);

/** Writes the attempts, two texts for each. */
void WriteAttempts(const std::vector<crossfield::AttemptReport>& attempts, vtkFieldData* data);

/** Writes the moves of given singularities. */
void WriteMoves(const crossfield::QuadWorkflowResult& result, const crossfield::DomainPlane& plane,
  vtkFieldData* data);

/** Returns, without a full stop, the numbers of quads and blocks and the minimum angle. */
std::string DescribeQuads(const crossfield::QuadResult& result);

/** Returns the text that vtkQuadMesher writes for the view. */
std::string Summary(const crossfield::QuadWorkflowResult& result);
}

#endif
