#ifndef vtkCrossFieldArrayNames_h
#define vtkCrossFieldArrayNames_h

/**
 * Names of the arrays that the filters read and write. Shapes and meanings are in the class
 * comments of the filters that write the arrays; vtkCrossFieldReport.cxx lists those that reports contain.
 */
namespace vtkCrossFieldArrayNames
{
// Drilled mesh, cells: vtkDrillHoles.
constexpr const char* BoundaryKind = "BoundaryKind";
constexpr const char* BoundaryId = "BoundaryId";
// Materials of a domain and of its quads, cells: vtkQuadMesher.
constexpr const char* Material = "Material";
constexpr const char* Region = "Region";
constexpr const char* RegionName = "RegionName";
constexpr const char* RegionMaterial = "RegionMaterial";
constexpr const char* RegionLeft = "RegionLeft";
constexpr const char* RegionRight = "RegionRight";
constexpr const char* InterfaceName = "InterfaceName";
constexpr const char* InterfaceEdges = "InterfaceEdges";
constexpr const char* InterfaceSizeRatio = "InterfaceSizeRatio";
constexpr const char* RegionQuads = "RegionQuads";
constexpr const char* RegionRequiredInteriorQuarters = "RegionRequiredInteriorQuarters";
constexpr const char* RegionGivenInteriorQuarters = "RegionGivenInteriorQuarters";
// Singularities and corners, points; drilled mesh, cells.
constexpr const char* QuarterIndex = "QuarterIndex";
constexpr const char* Radius = "Radius";
// Field data: vtkBoundarySimplifier.
constexpr const char* BoundaryMoved = "BoundaryMoved";
constexpr const char* BoundaryPoints = "BoundaryPoints";
constexpr const char* BoundaryRemovedCorners = "BoundaryRemovedCorners";
// Field: vtkPerforatedCrossField.
constexpr const char* CrossFieldCR = "CrossFieldCR";
constexpr const char* Representation = "Representation";
constexpr const char* Cross = "Cross";
constexpr const char* Cross2 = "Cross2";
constexpr const char* CrossNorm = "CrossNorm";
// Field data: vtkPerforatedCrossField.
constexpr const char* Energy = "Energy";
constexpr const char* Iterations = "Iterations";
constexpr const char* Residual = "Residual";
constexpr const char* Converged = "Converged";
constexpr const char* StartedFromUnitNorm = "StartedFromUnitNorm";
constexpr const char* UnitHoles = "UnitHoles";
constexpr const char* HoleDegree = "HoleDegree";
constexpr const char* HoleDegreeReliable = "HoleDegreeReliable";
constexpr const char* HoleNormRange = "HoleNormRange";
constexpr const char* DegreesReached = "DegreesReached";
constexpr const char* UnwantedSingularities = "UnwantedSingularities";
constexpr const char* EulerCharacteristic = "EulerCharacteristic";
constexpr const char* Valence = "Valence";
constexpr const char* TangentTurning = "TangentTurning";
constexpr const char* TotalCurvature = "TotalCurvature";
constexpr const char* RequiredInteriorQuarters = "RequiredInteriorQuarters";
constexpr const char* GivenInteriorQuarters = "GivenInteriorQuarters";
constexpr const char* Consistent = "Consistent";
constexpr const char* HolonomyDefect = "HolonomyDefect";
// Points and field data: vtkHField.
constexpr const char* H = "H";
constexpr const char* SizeMap = "SizeMap";
constexpr const char* RenormalizedEnergy = "RenormalizedEnergy";
// Table and points of alternatives: vtkConfigurationProposal.
constexpr const char* Alternative = "Alternative";
constexpr const char* Origin = "Origin";
constexpr const char* Singularities = "Singularities";
constexpr const char* CoreRadius = "CoreRadius";
constexpr const char* EnergyAtCoreRadius = "EnergyAtCoreRadius";
constexpr const char* PointSingularities = "PointSingularities";
// Field data: vtkDrillHoles.
constexpr const char* BoundarySingularities = "BoundarySingularities";
// Table and points: vtkSingularityEnergy.
constexpr const char* Configuration = "Configuration";
constexpr const char* EnergyLowerBound = "EnergyLowerBound";
constexpr const char* EnergyUpperBound = "EnergyUpperBound";
constexpr const char* EnergyDegreeOnly = "EnergyDegreeOnly";
constexpr const char* EnergyDegreeOnlyLowerBound = "EnergyDegreeOnlyLowerBound";
constexpr const char* EnergyDegreeOnlyUpperBound = "EnergyDegreeOnlyUpperBound";
constexpr const char* LogarithmCoefficient = "LogarithmCoefficient";
constexpr const char* Gradient = "Gradient";
// Field data and history: vtkSingularityOptimizer; Events also: vtkConfigurationProposal.
constexpr const char* RenormalizedEnergyBefore = "RenormalizedEnergyBefore";
constexpr const char* RenormalizedEnergyAfter = "RenormalizedEnergyAfter";
constexpr const char* SizeSpread = "SizeSpread";
constexpr const char* SizeSpreadBefore = "SizeSpreadBefore";
constexpr const char* SizeSpreadAfter = "SizeSpreadAfter";
constexpr const char* FrontSingularities = "FrontSingularities";
constexpr const char* FrontSizeSpread = "FrontSizeSpread";
constexpr const char* FrontRenormalizedEnergy = "FrontRenormalizedEnergy";
constexpr const char* FrontHolonomyDefect = "FrontHolonomyDefect";
constexpr const char* Annihilation = "Annihilation";
constexpr const char* Events = "Events";
constexpr const char* Warnings = "Warnings";
constexpr const char* Attempts = "Attempts"; // vtkQuadMesher
constexpr const char* SizeTargetAreaShare = "SizeTargetAreaShare";
constexpr const char* SizeTargetQuadShare = "SizeTargetQuadShare";
constexpr const char* SizeTargetFineMedian = "SizeTargetFineMedian";
constexpr const char* SizeTargetLargestJump = "SizeTargetLargestJump";
constexpr const char* SizeTargetNodesAdded = "SizeTargetNodesAdded";
constexpr const char* SizeTargetFactor = "SizeTargetFactor";
constexpr const char* SizeTargetSideName = "SizeTargetSideName";
constexpr const char* SizeTargetSideMedian = "SizeTargetSideMedian";
constexpr const char* AlternativeNodes = "AlternativeNodes";
constexpr const char* AlternativeBlocks = "AlternativeBlocks";
constexpr const char* AlternativeScaledJacobian = "AlternativeScaledJacobian";
constexpr const char* AlternativeSizeVariation = "AlternativeSizeVariation";
constexpr const char* Iteration = "Iteration";
constexpr const char* GradientNorm = "GradientNorm";
constexpr const char* StepLength = "StepLength";
// Field data: vtkGinzburgLandauCrossField.
constexpr const char* Epsilon = "Epsilon";
constexpr const char* GradientEnergy = "GradientEnergy";
constexpr const char* PenaltyEnergy = "PenaltyEnergy";
constexpr const char* ConvexifiedSteps = "ConvexifiedSteps";
// Corners, points: vtkBoundaryCornerClassifier and vtkPoincareHopfCheck.
constexpr const char* Angle = "Angle";
constexpr const char* QuarterIndexScarce = "QuarterIndexScarce";
constexpr const char* QuarterIndexBalanced = "QuarterIndexBalanced";
constexpr const char* QuarterIndexExcess = "QuarterIndexExcess";
constexpr const char* QuarterIndexConventional = "QuarterIndexConventional";
constexpr const char* CornerEnergy = "CornerEnergy";
constexpr const char* Cancellable = "Cancellable";
constexpr const char* Tied = "Tied";
constexpr const char* Overridden = "Overridden";
// Scenario table and field data: vtkBoundaryCornerClassifier.
constexpr const char* Scenario = "Scenario";
constexpr const char* Sum = "Sum";
constexpr const char* Feasible = "Feasible";
constexpr const char* Chosen = "Chosen";
constexpr const char* InteriorQuarters = "InteriorQuarters";
// Also in vtkPoincareHopfCheck and vtkQuadMesher.
constexpr const char* AmbiguousCorners = "AmbiguousCorners";
// Points, cells and field data: vtkCrossFieldMap.
constexpr const char* UV = "UV";
constexpr const char* VertexId = "VertexId";
constexpr const char* Cone = "Cone";
constexpr const char* Seam = "Seam";
constexpr const char* Direction = "Direction";
constexpr const char* SeamRotation = "SeamRotation";
constexpr const char* SeamTranslation = "SeamTranslation";
constexpr const char* ConeRow = "ConeRow";
constexpr const char* Flips = "Flips";
constexpr const char* MapResidual = "MapResidual";
constexpr const char* RepairDistance = "RepairDistance";
constexpr const char* RepairedPositions = "RepairedPositions";
constexpr const char* DefectBefore = "DefectBefore";
constexpr const char* PredictedStretch = "PredictedStretch";
constexpr const char* StretchReason = "StretchReason";
// Lines, faces and field data: vtkSeparatrices.
constexpr const char* Line = "Line";
constexpr const char* Singularity = "Singularity";
constexpr const char* EndsAt = "EndsAt";
constexpr const char* Seed = "Seed";
constexpr const char* Length = "Length";
constexpr const char* NodeKind = "NodeKind";
constexpr const char* FaceId = "FaceId";
constexpr const char* USize = "USize";
constexpr const char* VSize = "VSize";
constexpr const char* Lines = "Lines";
constexpr const char* Faces = "Faces";
constexpr const char* Arcs = "Arcs";
constexpr const char* ExtraLines = "ExtraLines";
constexpr const char* HeadOn = "HeadOn";
constexpr const char* Longest = "Longest";
constexpr const char* Mismatch = "Mismatch";
// Texts for a view, and their field data: vtkPoincareHopfCheck, vtkPerforatedCrossField,
// vtkLayoutDesigner.
constexpr const char* Alarm = "Alarm";
// Field data of singularities that are not in z = const: origin and axes of their plane.
constexpr const char* Plane = "Plane";
// Field data, Shade of lines, and Colour of patches: vtkLayoutDesigner.
constexpr const char* Colour = "Colour";
constexpr const char* MovedNodes = "MovedNodes";
constexpr const char* Summary = "Summary";
constexpr const char* Stale = "Stale";
constexpr const char* Shade = "Shade";
constexpr const char* ShortestArc = "ShortestArc";
constexpr const char* MinimumAngle = "MinimumAngle";
// Field data: vtkExtrudeQuads.
constexpr const char* SweepAngle = "SweepAngle";
constexpr const char* SweepEnds = "SweepEnds";
constexpr const char* SweepHeight = "SweepHeight";
constexpr const char* SweepLayers = "SweepLayers";
constexpr const char* Hexahedra = "Hexahedra";
// Points, cells and field data: vtkQuadMesher.
constexpr const char* BlockId = "BlockId";
constexpr const char* Part = "Part";
constexpr const char* Parts = "Parts";
constexpr const char* I = "I";
constexpr const char* J = "J";
constexpr const char* K = "K";
constexpr const char* ScaledJacobian = "ScaledJacobian";
constexpr const char* SizeRatio = "SizeRatio";
constexpr const char* Irregular = "Irregular";
constexpr const char* BoundarySide = "BoundarySide";
constexpr const char* Side = "Side";
constexpr const char* SideName = "SideName";
constexpr const char* SideNames = "SideNames";
constexpr const char* SideEdges = "SideEdges";
constexpr const char* SideLengths = "SideLengths";
constexpr const char* Edges = "Edges";
constexpr const char* Quads = "Quads";
constexpr const char* Blocks = "Blocks";
constexpr const char* BlocksUnmerged = "BlocksUnmerged";
constexpr const char* BlocksClean = "BlocksClean";
constexpr const char* BlocksCoarse = "BlocksCoarse";
constexpr const char* IrregularValence = "IrregularValence";
constexpr const char* IrregularObtained = "IrregularObtained";
constexpr const char* IrregularRequested = "IrregularRequested";
constexpr const char* ScaledJacobianRange = "ScaledJacobianRange";
constexpr const char* ScaledJacobianRangeBefore = "ScaledJacobianRangeBefore";
constexpr const char* ScaledJacobianBound = "ScaledJacobianBound";
constexpr const char* ScaledJacobianBySurface = "ScaledJacobianBySurface";
constexpr const char* SurfaceDistance = "SurfaceDistance";
constexpr const char* EtaRange = "EtaRange";
constexpr const char* SizeRange = "SizeRange";
constexpr const char* SizeVariation = "SizeVariation";
constexpr const char* Size = "Size";
constexpr const char* Symmetries = "Symmetries";
constexpr const char* ZeroArcs = "ZeroArcs";
constexpr const char* IntegerVariables = "IntegerVariables";
constexpr const char* IntegerGap = "IntegerGap";
constexpr const char* IntegerOptimal = "IntegerOptimal";
constexpr const char* Inverted = "Inverted";
constexpr const char* InvertedPlace = "InvertedPlace";
constexpr const char* Released = "Released";
constexpr const char* Moved = "Moved";
constexpr const char* MoveSingularity = "MoveSingularity";
constexpr const char* MoveFrom = "MoveFrom";
constexpr const char* MoveTo = "MoveTo";
constexpr const char* MoveDistance = "MoveDistance";
constexpr const char* LayerSide = "LayerSide";
constexpr const char* LayerReplaced = "LayerReplaced";
constexpr const char* LayerRows = "LayerRows";
constexpr const char* LayerFirst = "LayerFirst";
constexpr const char* LayerThickness = "LayerThickness";
constexpr const char* LayerHeightRange = "LayerHeightRange";
constexpr const char* LayerInBounds = "LayerInBounds";
constexpr const char* LayerGrowth = "LayerGrowth";
constexpr const char* LayerRatio = "LayerRatio";
constexpr const char* LayerRatio99 = "LayerRatio99";
constexpr const char* PeriodicSides = "PeriodicSides";
constexpr const char* PeriodicMotion = "PeriodicMotion";
constexpr const char* PeriodicKind = "PeriodicKind";
constexpr const char* PeriodicVector = "PeriodicVector";
constexpr const char* PeriodicCentre = "PeriodicCentre";
constexpr const char* PeriodicAngle = "PeriodicAngle";
constexpr const char* PeriodicEdges = "PeriodicEdges";
constexpr const char* PeriodicMismatch = "PeriodicMismatch";
constexpr const char* NeighbourBlock = "NeighbourBlock";
constexpr const char* NeighbourSide = "NeighbourSide";
constexpr const char* NeighbourOrientation = "NeighbourOrientation";
// Cells and field data of domains with curves: CurveConversion.h.
constexpr const char* Curve = "Curve";
constexpr const char* CurveKind = "CurveKind";
constexpr const char* CurveOffset = "CurveOffset";
constexpr const char* CurveValues = "CurveValues";
// Field data: vtkDrawingReader.
constexpr const char* DrawingUnit = "DrawingUnit";
constexpr const char* LargestGap = "LargestGap";
// Field data of curves in quad meshes: vtkQuadMesher, vtkQuadsToHigherOrder.
constexpr const char* CurveSides = "CurveSides";
constexpr const char* CurveEdges = "CurveEdges";
constexpr const char* CurveMoved = "CurveMoved";
constexpr const char* CurveSagitta = "CurveSagitta";
constexpr const char* Order = "Order";
constexpr const char* JacobianRatio = "JacobianRatio";
constexpr const char* JacobianRatioMin = "JacobianRatioMin";
constexpr const char* CurvedRows = "CurvedRows";
constexpr const char* CurvedInverted = "CurvedInverted";
// Loop table and field data: vtkPoincareHopfCheck.
constexpr const char* BoundaryLoop = "BoundaryLoop";
constexpr const char* CornerQuarters = "CornerQuarters";
constexpr const char* RequiredPart = "RequiredPart";
constexpr const char* Reason = "Reason";
}

#endif
