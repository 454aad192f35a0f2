#include "CrossFieldReport.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "Support.h"

#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
/// The cross field along one axis, on a mesh whose boundary asks for nothing else.
CrossField ConstantField(const TriangleMesh& mesh)
{
  CrossField field;
  field.edges = NumberEdges(mesh);
  field.u = ComplexVector::Ones(field.edges.Count());
  field.count = CountMeshQuarters(mesh, FindBoundaryLoops(mesh));
  return field;
}

TEST(CrossFieldReport, CornersMayTakeWhatTheyLike)
{
  for (const char* name : { "square", "l-shape" })
  {
    const TriangleMesh mesh = DrillHoles(Builtin(name), { { { 0.25, 0.2 }, 0, 0.05 } });
    CrossField field = ConstantField(mesh);
    ReadReport(mesh, FindBoundaryLoops(mesh), field);
    EXPECT_EQ(field.unwantedSingularities, 0) << name;
    ASSERT_EQ(field.holes.size(), 1u);
    EXPECT_EQ(field.holes[0].degree, 0);
    EXPECT_TRUE(field.holes[0].Reliable());
  }
}

TEST(CrossFieldReport, CountsEverySingularityOutsideTheCorners)
{
  // Turning one interior value by an angle beyond π makes singularities around its edge, in pairs.
  const TriangleMesh mesh = DrillHoles(Builtin("square"), {});
  CrossField field = ConstantField(mesh);
  const std::vector<BoundaryLoop> loops = FindBoundaryLoops(mesh);
  Random random(60);
  for (Complex& value : field.u)
  {
    value = random.UnitComplex();
  }
  for (int edge : field.edges.ofBoundary)
  {
    field.u[edge] = 1.0;
  }
  ReadReport(mesh, loops, field);
  const FieldIndices indices = ReadIndices(mesh, field.edges, field.u);
  int expected = 0;
  for (int index : indices.ofTriangle)
  {
    expected += index != 0;
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    const Point& p = mesh.points[v];
    const bool corner = (p.x() == 0.0 || p.x() == 1.0) && (p.y() == 0.0 || p.y() == 1.0);
    expected += indices.ofVertex[v] != 0 && !corner;
  }
  EXPECT_GT(expected, 100);
  EXPECT_EQ(field.unwantedSingularities, expected);
}

TEST(CrossFieldReport, InnerLoopsHaveCornersToo)
{
  const PlanarDomain domain = MakePlanarDomain(
    { { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } }, { { 1, 1 }, { 3, 1 }, { 3, 2 }, { 1, 2 } } });
  const TriangleMesh mesh = DrillHoles(domain, {});
  CrossField field = ConstantField(mesh);
  ReadReport(mesh, FindBoundaryLoops(mesh), field);
  EXPECT_EQ(field.unwantedSingularities, 0);
  EXPECT_EQ(field.count.requiredInteriorQuarters, 0);
}

TEST(CrossFieldReport, RefusesAFieldThatIsNotFinite)
{
  const TriangleMesh mesh = DrillHoles(Builtin("square"), {});
  CrossField field = ConstantField(mesh);
  field.u[field.u.size() / 2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(Refuses([&] { ReadReport(mesh, FindBoundaryLoops(mesh), field); }, { "non-finite" }));
}
}
}
