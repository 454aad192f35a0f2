#include "ReadCad.h"

#include "Error.h"
#include "FaceDrawing.h"
#include "FaceSurface.h"
#include "ModelFile.h"

#include <Standard_Failure.hxx>

#include <exception>

void crossfieldReadCad(const std::string& file, const CadRequest& request,
  crossfield::Drawing& drawing, std::string& error)
{
  const auto fail = [&](const std::string& reason)
  {
    error = "The model '" + file + "' cannot be read by Open CASCADE" +
      (reason.empty() ? "" : " (" + reason + ")") + "; export it again.";
  };
  try
  {
    const ModelFile model(file);
    drawing = request.allFaces || !HasPlanarFace(model) ? TriangulateFaces(model, request.angle)
                                                        : DrawLargestFace(model);
  }
  catch (const crossfield::Error& problem)
  {
    error = problem.what();
  }
  catch (const Standard_Failure& failure)
  {
    fail(failure.DynamicType()->Name());
  }
  catch (const std::exception& failure)
  {
    fail(failure.what());
  }
  catch (...)
  {
    fail("");
  }
}
