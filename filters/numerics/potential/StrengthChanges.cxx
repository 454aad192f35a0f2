#include "StrengthChanges.h"

#include "AlignedPotential.h"
#include "DenseProduct.h"
#include "Parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Number of columns that are solved for together: enough for many parts, and few enough for the
/// memory.
constexpr std::size_t BatchSize = 256;
/// Minimum number of columns in a part.
constexpr std::ptrdiff_t MinimumColumns = 4;

/// Returns the factor of log|x − y| in W for two logarithms of unit strength.
double InteractionFactor(const LogSource& one, const LogSource& other)
{
  return -0.5 * (one.angle + other.angle);
}
}

StrengthChanges::StrengthChanges(
  std::shared_ptr<const PositionEnergy> energy, const Configuration& configuration)
  : Energy(std::move(energy))
{
  const PointPotential& potential = this->Energy->GetPotential();
  const PlanarTopology& topology = potential.GetProblem().Topology();
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    this->EntryOf[topology.mesh.boundary[i].vertices[0]] = i;
  }
  PositionEnergy::Value value = this->Energy->Evaluate(configuration, false);
  this->Coefficient = value.renormalized.logarithmCoefficient;
  this->SingleValued = value.renormalized.singleValuedEnergy;
  this->Logs = value.solution.logs;
  this->Given = std::move(value.flows);
  this->Regular = std::move(value.regular);
  const std::vector<BoundaryHalf>& halves = potential.GetHalves();
  this->Growth.resize(static_cast<Eigen::Index>(halves.size()));
  const Eigen::MatrixXd& basis = potential.GetPeriodBasis();
  this->PeriodBasis.resize(this->Growth.size(), basis.cols());
  for (std::size_t h = 0; h < halves.size(); ++h)
  {
    this->Growth[static_cast<Eigen::Index>(h)] = halves[h].growth;
    this->PeriodBasis.row(static_cast<Eigen::Index>(h)) = basis.row(halves[h].vertex);
  }
  const std::vector<double>& defects = value.solution.holonomyDefect;
  this->Defects =
    Eigen::Map<const Eigen::VectorXd>(defects.data(), static_cast<Eigen::Index>(defects.size()));
  for (Eigen::Index k = 0; k < this->Defects.size(); ++k)
  {
    this->Paths[0].push_back(potential.StripPath(k, false));
    this->Paths[1].push_back(potential.StripPath(k, true));
  }
  if (this->Defects.size() > 0)
  {
    this->DefectEnergy = 0.5 *
      (potential.GetProblem().potential->GetPeriodResponse().inverse +
        this->Energy->GetEdgePotential().CouplingOfIslands());
  }
}

StrengthChanges::Key StrengthChanges::KeyOf(const Place& place)
{
  return place.vertex >= 0 ? Key{ place.vertex, 0.0, 0.0 }
                           : Key{ -1, place.position.x(), place.position.y() };
}

StrengthChanges::Column StrengthChanges::MakeColumn(const Place& place) const
{
  const PointPotential& potential = this->Energy->GetPotential();
  PointPotential::BoundaryLog source{ { place.position, 1.0, 2.0 * Pi }, -1, false };
  if (place.vertex >= 0)
  {
    source = potential.QuarterAt(this->EntryOf.at(place.vertex));
  }
  auto [flux, mean] = potential.FlowOf(source);
  Column column;
  column.log = source.log;
  column.flux = std::move(flux);
  column.mean = std::move(mean);
  // All changes together have no flux, so it makes no difference where the flux of each ends.
  column.flux[0] -= column.flux.sum();
  column.defects.resize(this->Defects.size());
  for (Eigen::Index k = 0; k < column.defects.size(); ++k)
  {
    const std::vector<Point>& path = this->Paths[source.onCurve ? 1 : 0][k];
    double turn = 0.0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      turn += column.log.strength * column.log.Turn(path[i], path[i + 1]);
    }
    column.defects[k] = turn;
  }
  return column;
}

void StrengthChanges::ComputeResponses(
  const std::vector<Column*>& columns, Eigen::MatrixXd* atVertices) const
{
  const PointPotential& points = this->Energy->GetPotential();
  const PotentialSolver& potential = *points.GetProblem().potential;
  const std::vector<BoundaryHalf>& halves = points.GetHalves();
  const auto count = static_cast<Eigen::Index>(columns.size());
  // 1. At vertices; the sources that keep the periods zero change the phase that R carries.
  Eigen::MatrixXd sources = Eigen::MatrixXd::Zero(potential.Rows(), count);
  Eigen::MatrixXd fluxes = Eigen::MatrixXd::Zero(this->Growth.size() / 2, count);
  for (Eigen::Index c = 0; c < count; ++c)
  {
    const Eigen::VectorXd& flux = columns[c]->flux;
    for (Eigen::Index h = 0; h < flux.size(); ++h)
    {
      sources(halves[h].vertex, c) += flux[h];
      fluxes(h / 2, c) += flux[h];
    }
  }
  const Eigen::MatrixXd solution = potential.Solve(sources, PotentialSolver::Periods::Islands);
  const PeriodResponse& response = potential.GetPeriodResponse();
  const Eigen::Index periods = response.basis.cols();
  const Eigen::MatrixXd carried = DenseProduct(-response.schur, solution.bottomRows(periods));
  const Eigen::MatrixXd correction = DenseProduct(this->PeriodBasis, carried);

  // 2. On edges.
  const Eigen::MatrixXd atEdges = this->Energy->GetEdgePotential().Solve(fluxes);
  ForRanges(
    count,
    [&](int begin, int end)
    {
      for (Eigen::Index c = begin; c < end; ++c)
      {
        Column& column = *columns[c];
        column.response.resize(this->Growth.size());
        for (Eigen::Index h = 0; h < column.response.size(); ++h)
        {
          column.response[h] =
            0.5 * (solution(halves[h].vertex, c) + correction(h, c) + atEdges(h / 2, c));
        }
        column.defects += carried.col(c);
      }
    },
    MinimumColumns);
  if (atVertices != nullptr)
  {
    const Eigen::Index vertices = points.GetProblem().Topology().VertexCount();
    *atVertices = solution.topRows(vertices);
    if (periods > 0)
    {
      *atVertices += DenseProduct(points.GetPeriodBasis().topRows(vertices), carried);
    }
  }
}

StrengthChanges::Form StrengthChanges::FormAt(
  const std::vector<Place>& places, double coreRadius, Eigen::MatrixXd* regular) const
{
  const auto count = static_cast<Eigen::Index>(places.size());
  const double core = -std::log(coreRadius);
  Form form{ Eigen::VectorXd(count), Eigen::MatrixXd(), this->Defects,
    Eigen::MatrixXd(this->Defects.size(), count), this->DefectEnergy };
  Eigen::MatrixXd fluxes(this->Growth.size(), count);
  Eigen::MatrixXd responses(this->Growth.size(), count); // less the means
  std::vector<LogSource> logs(places.size());
  for (std::size_t begin = 0; begin < places.size(); begin += BatchSize)
  {
    const std::size_t size = std::min(BatchSize, places.size() - begin);
    std::vector<Column> columns(size);
    std::vector<Column*> pointers(size);
    ForRanges(
      static_cast<std::ptrdiff_t>(size),
      [&](int first, int last)
      {
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
        {
          columns[i] = this->MakeColumn(places[begin + i]);
          pointers[i] = &columns[i];
        }
      },
      MinimumColumns);
    Eigen::MatrixXd atVertices;
    this->ComputeResponses(pointers, regular != nullptr ? &atVertices : nullptr);
    if (regular != nullptr)
    {
      regular->conservativeResize(atVertices.rows(), count);
      regular->middleCols(static_cast<Eigen::Index>(begin), atVertices.cols()) = -atVertices;
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      const auto c = static_cast<Eigen::Index>(begin + i);
      const Column& column = columns[i];
      const LogSource& log = column.log;
      logs[begin + i] = log;
      fluxes.col(c) = column.flux;
      responses.col(c) = column.response - column.mean;
      form.defectChanges.col(c) = column.defects;
      double interaction = 0.0;
      for (const LogSource& other : this->Logs)
      {
        if (other.position != log.position)
        {
          interaction += InteractionFactor(other, log) * other.strength * log.strength *
            std::log((other.position - log.position).norm());
        }
      }
      form.linear[c] = interaction - column.flux.dot(this->Regular) +
        column.mean.dot(this->Growth - 0.5 * this->Given.flux) -
        0.5 * this->Given.mean.dot(column.flux) +
        core * log.angle * log.strength * this->StrengthAt(log.position);
    }
  }
  form.matrix = AdjointProduct(fluxes, responses);
  form.matrix = (0.5 * (form.matrix + form.matrix.transpose())).eval();
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const LogSource& log = logs[static_cast<std::size_t>(i)];
    form.matrix(i, i) += core * log.angle * log.strength * log.strength;
    for (Eigen::Index j = 0; j < i; ++j)
    {
      const LogSource& other = logs[static_cast<std::size_t>(j)];
      const double interaction = InteractionFactor(log, other) * log.strength * other.strength *
        std::log((log.position - other.position).norm());
      form.matrix(i, j) += interaction;
      form.matrix(j, i) += interaction;
    }
  }
  return form;
}

double StrengthChanges::StrengthAt(const Point& position) const
{
  double strength = 0.0;
  for (const LogSource& log : this->Logs)
  {
    strength += log.position == position ? log.strength : 0.0;
  }
  return strength;
}

std::size_t StrengthChanges::Prepare(const std::vector<Place>& places)
{
  std::vector<Column*> added;
  std::vector<Place> newPlaces;
  for (const Place& place : places)
  {
    const auto [found, isNew] = this->Columns.insert({ KeyOf(place), Column() });
    if (isNew)
    {
      added.push_back(&found->second);
      newPlaces.push_back(place);
    }
  }
  ForRanges(
    static_cast<std::ptrdiff_t>(added.size()),
    [&](int begin, int end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        *added[i] = this->MakeColumn(newPlaces[i]);
      }
    },
    MinimumColumns);
  for (std::size_t begin = 0; begin < added.size(); begin += BatchSize)
  {
    const auto first = added.begin() + static_cast<std::ptrdiff_t>(begin);
    this->ComputeResponses(
      { first, first + static_cast<std::ptrdiff_t>(std::min(BatchSize, added.size() - begin)) });
  }
  return added.size();
}

StrengthChanges::Sum StrengthChanges::Add(const std::vector<Change>& changes) const
{
  Sum sum;
  sum.column.flux = Eigen::VectorXd::Zero(this->Growth.size());
  sum.column.mean = sum.column.flux;
  sum.column.response = sum.column.flux;
  sum.column.defects = Eigen::VectorXd::Zero(this->Defects.size());
  std::vector<LogSource> added;
  for (const Change& change : changes)
  {
    const Column& column = this->Columns.at(KeyOf(change.place));
    const double count = change.quarters;
    LogSource log = column.log;
    log.strength *= count;
    double present = 0.0; // strength of the logarithm that is there already
    for (const std::vector<LogSource>* others : { &this->Logs, &std::as_const(added) })
    {
      for (const LogSource& other : *others)
      {
        if (other.position == log.position)
        {
          present += other.strength;
        }
        else
        {
          sum.interaction += InteractionFactor(other, log) * other.strength * log.strength * 0.5 *
            std::log((other.position - log.position).squaredNorm());
        }
      }
    }
    sum.coefficient += 0.5 * log.angle * log.strength * (log.strength + 2.0 * present);
    added.push_back(log);
    sum.column.flux += count * column.flux;
    sum.column.mean += count * column.mean;
    sum.column.response += count * column.response;
    sum.column.defects += count * column.defects;
  }
  return sum;
}

double StrengthChanges::EnergyOf(const Sum& sum) const
{
  // W has the terms ½ (s − F) 𝓡(s − F) + L (s − ½F) in fluxes F and means L.
  return sum.interaction + sum.column.flux.dot(0.5 * sum.column.response - this->Regular) +
    sum.column.mean.dot(this->Growth - 0.5 * (this->Given.flux + sum.column.flux)) -
    0.5 * this->Given.mean.dot(sum.column.flux);
}

StrengthChanges::Value StrengthChanges::Evaluate(const std::vector<Change>& changes) const
{
  const Sum sum = this->Add(changes);
  Value value{ this->SingleValued + this->EnergyOf(sum), this->Coefficient + sum.coefficient, 0.0 };
  if (this->Defects.size() > 0)
  {
    // The harmonic field of the defects.
    const Eigen::VectorXd defects = (this->Defects + sum.column.defects)
                                      .unaryExpr([](double defect) { return WrapAngle(defect); });
    value.largestDefect = defects.lpNorm<Eigen::Infinity>();
    const Eigen::VectorXd offsets = NearestOffsets(
      defects, this->Energy->GetPotential().GetProblem().potential->GetPeriodResponse().inverse);
    value.energy += 0.5 * offsets.dot(this->DefectEnergy * offsets);
  }
  return value;
}

void StrengthChanges::Accept(const std::vector<Change>& changes)
{
  const Sum sum = this->Add(changes);
  this->SingleValued += this->EnergyOf(sum);
  this->Coefficient += sum.coefficient;
  this->Given.flux += sum.column.flux;
  this->Given.mean += sum.column.mean;
  this->Regular -= sum.column.response;
  this->Defects += sum.column.defects;
  for (const Change& change : changes)
  {
    LogSource log = this->Columns.at(KeyOf(change.place)).log;
    log.strength *= change.quarters;
    const auto present = std::find_if(this->Logs.begin(), this->Logs.end(),
      [&](const LogSource& other) { return other.position == log.position; });
    if (present == this->Logs.end())
    {
      this->Logs.push_back(log);
    }
    else
    {
      present->strength += log.strength;
    }
  }
}
}
