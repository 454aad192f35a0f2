/**
 * @class   vtkQuadMeshWriter
 * @brief   writes quads or hexahedra with the names of their sides to files of solvers
 *
 * The ending of the file gives the format, in any case:
 * - .msh: Gmsh 4.1 or 2.2 (.msh2: 2.2) with a physical group for each side and one, domain, for the quads; orders 1 to 3
 * - .inp: Abaqus and CalculiX, with sets and a surface for each side; CPS4, or CPS8 without the nodes
 *   inside; orders 1 and 2
 * - .su2: SU2 with a marker for each side; order 1
 * - .cgns: structured zones with 1-to-1 connections, families and boundary conditions, if the library was built with
 *   CGNS; order 1, with the cell arrays `BlockId`, `I`, `J` and in three dimensions `K`
 * - .xyz: PLOT3D, formatted, with a neutral map file beside it; as .cgns
 * - .ex2, .exo, .e: Exodus with an element block and a side set for each side; orders 1 and 2
 * - .vtk: the legacy format of VTK with all arrays; orders 1 to 3
 * - .foam, or / at the end: the folder of the file, or the folder, is a case of OpenFOAM, with
 *   constant/polyMesh, system/blockMeshDict if the quads have `BlockId`, `I` and `J`, and an empty .foam file;
 *   folders are made; quads are one layer of cells; order 1
 *
 * Quads are counter-clockwise and sides have the domain on the left. Nodes count from 1 in the order of
 * the points that quads use; in .su2 from 0. Coordinates are exact, except that those of .inp have at most 20
 * characters, which are at least 13 digits. docs/formats.md describes names.
 *
 * Input port 0 (vtkUnstructuredGrid): quads and lines of one order, with the string array `Side` on the
 * lines: vtkQuadMesher::CopyMesh, vtkQuadsToHigherOrder or a .vtu file of `crossfield quads`; or output 0 of
 * vtkQuadMesher. Input port 1, optional: the boundary edges, output 5 of vtkQuadMesher, if port 0 has no
 * lines; without a connection, those of the vtkQuadMesher upstream whose points and cells port 0 has.
 *
 * If the writer fails, it sets an error code, and old files stay as they are. It fails if the
 * ending is unknown, the format cannot have the mesh, edges of the boundary are missing, or the file cannot be
 * written.
 *
 * @sa vtkQuadMesher, vtkQuadsToHigherOrder, crossfield::WriteMeshFiles
 */

#ifndef vtkQuadMeshWriter_h
#define vtkQuadMeshWriter_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkWriter.h"

#include <string>
#include <utility>
#include <vector>

class VTKCROSSFIELDFILTERS_EXPORT vtkQuadMeshWriter : public vtkWriter
{
public:
  static vtkQuadMeshWriter* New();
  vtkTypeMacro(vtkQuadMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Connects port 1, the boundary edges, or sets it to a data object. */
  vtkCrossFieldPortMacro(Boundary, 1);
  ///@}

  ///@{
  /** Sets the name of the file. Default: empty, which is an error. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}
  /** Sets the name of the file; overload for ParaView. */
  void SetFileName(const char* fileName)
  {
    this->SetFileName(std::string(fileName ? fileName : ""));
  }

  /** Versions of .msh files. */
  enum MshVersions
  {
    Msh22 = 22,
    Msh41 = 41
  };
  ///@{
  /** Sets the version of .msh files. Default: Msh41. */
  vtkSetMacro(MshVersion, int);
  vtkGetMacro(MshVersion, int);
  ///@}

  ///@{
  /**
   * Sets types of patches of a case of OpenFOAM: entries NAME:TYPE separated by semicolons, such as
   * "cylinder:wall;top:symmetry". Sides with a boundary layer are walls without it. Other formats have
   * no such types. Default: empty.
   */
  vtkSetMacro(PatchTypes, std::string);
  vtkGetMacro(PatchTypes, std::string);
  ///@}
  /** Sets types of patches; overload for ParaView. */
  void SetPatchTypes(const char* types) { this->SetPatchTypes(std::string(types ? types : "")); }

  ///@{
  /** Keeps names and contents of the files for GetOutputFiles instead of writing them. Default: off. */
  vtkSetMacro(WriteToOutputString, bool);
  vtkGetMacro(WriteToOutputString, bool);
  vtkBooleanMacro(WriteToOutputString, bool);
  ///@}
  /** Returns names and contents of the files after a run with WriteToOutputString. */
  const std::vector<std::pair<std::string, std::string>>& GetOutputFiles() const
  {
    return this->OutputFiles;
  }

  /** Returns whether the ending of a file is that of a format. */
  static bool CanWrite(const std::string& fileName);

  /** Returns whether the name of a file or folder stands for a case of OpenFOAM, which has types of patches. */
  static bool HasPatchTypes(const std::string& fileName);

  /** Returns the endings of all formats, separated by blanks, and / for the folder of a case. */
  static std::string GetEndings();

  /** Returns why a file of this name cannot have quads of an order, or an empty text if it can. */
  static std::string ReasonAgainst(const std::string& fileName, int order);

protected:
  vtkQuadMeshWriter();
  ~vtkQuadMeshWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkQuadMeshWriter(const vtkQuadMeshWriter&) = delete;
  void operator=(const vtkQuadMeshWriter&) = delete;

  std::string FileName;
  int MshVersion = Msh41;
  std::string PatchTypes;
  bool WriteToOutputString = false;
  std::vector<std::pair<std::string, std::string>> OutputFiles;
};

#endif
