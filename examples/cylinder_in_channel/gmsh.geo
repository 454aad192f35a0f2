// Quads of Gmsh for comparison: gmsh -3 gmsh.geo -o gmsh.msh
SetFactory("OpenCASCADE");
DefineConstant[ near = 0.005 ]; // size at the cylinder
Rectangle(1) = {0, 0, 0, 2.2, 0.41};
Disk(2) = {0.2, 0.2, 0, 0.05};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Recombine Surface{3};
cylinder() = Curve In BoundingBox {0.1, 0.1, -1, 0.3, 0.3, 1};
Extrude {0, 0, 0.1} { Surface{3}; Layers{1}; Recombine; }
e = 1e-3;
inlet() = Surface In BoundingBox {-e, -e, -e, e, 0.41 + e, 0.1 + e};
outlet() = Surface In BoundingBox {2.2 - e, -e, -e, 2.2 + e, 0.41 + e, 0.1 + e};
bottom() = Surface In BoundingBox {-e, -e, -e, 2.2 + e, e, 0.1 + e};
top() = Surface In BoundingBox {-e, 0.41 - e, -e, 2.2 + e, 0.41 + e, 0.1 + e};
round() = Surface In BoundingBox {0.1, 0.1, -e, 0.3, 0.3, 0.1 + e};
back() = Surface In BoundingBox {-e, -e, -e, 2.2 + e, 0.41 + e, e};
front() = Surface In BoundingBox {-e, -e, 0.1 - e, 2.2 + e, 0.41 + e, 0.1 + e};
Physical Surface("inlet") = inlet();
Physical Surface("outlet") = outlet();
Physical Surface("wall") = {bottom(), top()};
Physical Surface("cylinder") = round();
Physical Surface("frontAndBack") = {back(), front()};
Physical Volume("domain") = Volume{:};
Field[1] = Distance;
Field[1].CurvesList = {cylinder()};
Field[1].NumPointsPerCurve = 200;
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = near;
Field[2].SizeMax = 4 * near;
Field[2].DistMin = 0.01;
Field[2].DistMax = 0.2;
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.RecombinationAlgorithm = 3; // full-quad Blossom
Mesh.MshFileVersion = 2.2;
