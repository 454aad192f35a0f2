#include "DrawingLayers.h"

#include "Error.h"

#include <algorithm>
#include <set>

namespace crossfield
{
namespace
{
std::string LayerOf(const DrawingPiece& piece)
{
  return piece.name.empty() ? "0" : piece.name;
}
}

void KeepLayers(const std::vector<std::string>& names, Drawing& drawing)
{
  if (names.empty())
  {
    return;
  }
  std::set<std::string> layers;
  for (const DrawingPiece& piece : drawing.pieces)
  {
    layers.insert(LayerOf(piece));
  }
  for (const std::string& name : names)
  {
    if (layers.count(name) == 0)
    {
      std::string list;
      for (const std::string& layer : layers)
      {
        list += (list.empty() ? "'" : ", '") + layer + "'";
      }
      throw Error(
        "The drawing has no curves on the layer '" + name + "'; its layers are " + list + ".");
    }
  }
  const auto other = std::remove_if(drawing.pieces.begin(), drawing.pieces.end(),
    [&](const DrawingPiece& piece)
    { return std::find(names.begin(), names.end(), LayerOf(piece)) == names.end(); });
  const auto count = drawing.pieces.end() - other;
  drawing.pieces.erase(other, drawing.pieces.end());
  if (count > 0)
  {
    drawing.warnings.push_back(std::to_string(count) +
      (count == 1 ? " curve on another layer was left out."
                  : " curves on other layers were left out."));
  }
}
}
