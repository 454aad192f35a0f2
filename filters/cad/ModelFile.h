#ifndef ModelFile_h
#define ModelFile_h

#include <STEPControl_Reader.hxx>
#include <TopoDS_Shape.hxx>

#include <memory>
#include <string>

/** A model read from a .step, .stp or .brep file. */
class ModelFile
{
public:
  /** Reads a file. Throws crossfield::Error if that fails. */
  explicit ModelFile(const std::string& file);

  const std::string& File() const { return this->Name; }
  const TopoDS_Shape& Shape() const { return this->Model; }
  /** Returns the unit of the coordinates, empty if the file has none. */
  const std::string& Unit() const { return this->UnitOfFile; }
  /** Returns the name of an edge or a face, empty if it has none. */
  std::string NameOf(const TopoDS_Shape& shape) const;

private:
  void ReadStep();
  void ReadBrep();

  std::string Name;
  std::unique_ptr<STEPControl_Reader> Reader; ///< Null for .brep files.
  TopoDS_Shape Model;
  std::string UnitOfFile;
};

#endif
