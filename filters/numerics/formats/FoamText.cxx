#include "FoamText.h"

namespace crossfield
{
void AddFoamHeader(MeshText& text, std::string_view type, std::string_view location,
  std::string_view object, std::string_view note)
{
  text.Add("FoamFile\n{\n    version 2.0;\n    format ascii;\n    class ").Add(type);
  if (!note.empty())
  {
    text.Add(";\n    note \"").Add(note).Add('"');
  }
  text.Add(";\n    location \"").Add(location).Add("\";\n    object ").Add(object).Add(";\n}\n");
}
}
