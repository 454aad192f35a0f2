#pragma once

#include "PartRequests.h"
#include "Progress.h"

#include <functional>

namespace crossfield
{
/// The quads of one part, and what is needed to join them to those of others.
struct PartOfQuads
{
  QuadWorkflowResult quads;
  std::size_t loops = 0;         ///< Number of loops of its boundary.
  std::vector<std::size_t> rows; ///< Rows of the given singularities that are in the part.
};

/// Joins the quads of parts, made one after the other by `make`: points, quads, blocks, loops
/// and curves have numbers that continue from part to part, and sentences begin with the number of
/// their part, from 1. Throws Error as `make` does, with the number of the part. One part stays as it is.
QuadWorkflowResult JoinQuads(
  std::size_t parts, const std::function<PartOfQuads(std::size_t part)>& make);

/// Makes the quads of each part as MakeQuadMesh does and joins them. Throws Error as JoinQuads and
/// SplitRequest do.
QuadWorkflowResult MakeQuadsOfParts(
  const std::vector<DomainPart>& parts, const QuadRequest& request, const Progress& progress = {});
}
