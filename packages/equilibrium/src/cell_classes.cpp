#include "ndframe/equilibrium/cell_classes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{
namespace
{

using Shape = std::array<std::int64_t, 11>; ///< edge vectors in units of a cell's size, body, law

struct HashOfShape
{
  std::size_t operator()(const Shape& shape) const
  {
    std::uint64_t hash = 0;
    for (const std::int64_t entry : shape)
      hash = (hash ^ std::uint64_t(entry)) * 0x9E3779B97F4A7C15U ^ hash >> 29;
    return std::size_t(hash);
  }
};

/// Returns the longest coordinate difference.
double measureEdges(const Mesh& mesh, int cell, CellClasses::Edges& edges)
{
  const SortedCell sorted = sortedCell(mesh, cell);
  const double* origin = mesh.point(sorted.vertices[0]);
  double length = 0.0;
  for (std::size_t at = 0; at < edges.size(); ++at) {
    edges[at] = mesh.point(sorted.vertices[at / 3 + 1])[at % 3] - origin[at % 3];
    length = std::max(length, std::abs(edges[at]));
  }
  for (double& edge : edges)
    edge /= length;
  return length;
}

/// What a rank says of a class, or hears: its hash, how many own cells, the number of the first one, that one's edges.
constexpr std::size_t perClass = 3 + std::tuple_size_v<CellClasses::Edges>;

/// The ranks' records of the same classes become those of all: cells are counted together, the first of all is first.
void join(std::vector<Vector>& records)
{
  std::unordered_map<std::int64_t, std::array<double, perClass>> all;
  for (const Vector& ofRank : records)
    for (auto at = ofRank.begin(); at != ofRank.end(); at += perClass) {
      std::array<double, perClass> record{};
      std::copy_n(at, perClass, record.begin());
      const auto [known, isNew] = all.emplace(std::int64_t(record[0]), record);
      if (isNew)
        continue;
      const double count = known->second[1] + record[1];
      if (record[2] < known->second[2])
        known->second = record;
      known->second[1] = count;
    }
  for (Vector& ofRank : records)
    for (auto at = ofRank.begin(); at != ofRank.end(); at += perClass) {
      const auto& record = all.at(std::int64_t(*at));
      std::copy(record.begin(), record.end(), at);
    }
}

std::vector<const BodyModel*> modelsOf(const std::vector<const BodyPiece*>& pieces)
{
  std::vector<const BodyModel*> models;
  for (const BodyPiece* piece : pieces)
    models.push_back(piece == nullptr ? nullptr : &piece->model);
  return models;
}

} // namespace

CellClasses::CellClasses(const std::vector<const BodyModel*>& bodies)
{
  find(bodies);
  hashes_ = {};
}

CellClasses::CellClasses(const std::vector<const BodyPiece*>& pieces, const Comm& comm)
{
  find(modelsOf(pieces));
  agree(pieces, comm);
  hashes_ = {};
}

void CellClasses::find(const std::vector<const BodyModel*>& bodies)
{
  constexpr double units = 17592186044416.0; // 2^44
  constexpr int exactBits = 53;              // of a hash that is sent as a double
  std::unordered_map<Shape, int, HashOfShape> known;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int cell = 0; bodies[b] != nullptr && cell < bodies[b]->mesh.numCells(); ++cell) {
      Shape shape{};
      Edges edges{};
      length_.push_back(measureEdges(bodies[b]->mesh, cell, edges));
      std::transform(edges.begin(), edges.end(), shape.begin(), [](double edge) { return std::llround(edge * units); });
      shape[9] = std::int64_t(b);
      shape[10] = bodies[b]->laws.number(cell);
      const auto [place, isNew] = known.emplace(shape, size());
      if (isNew) {
        first_.push_back(int(of_.size()));
        count_.push_back(0);
        hashes_.push_back(std::int64_t(HashOfShape()(shape) >> (64 - exactBits)));
      }
      of_.push_back(place->second);
      ++count_[std::size_t(place->second)];
    }
}

CellClasses::Edges CellClasses::edges(int number, const Mesh& mesh, int cell) const
{
  if (const auto other = origins_.find(number); other != origins_.end())
    return other->second;
  Edges edges{};
  measureEdges(mesh, cell, edges);
  return edges;
}

/// Every class is looked after by the rank that its hash names.
void CellClasses::agree(const std::vector<const BodyPiece*>& pieces, const Comm& comm)
{
  std::vector<std::array<double, perClass>> own(first_.size());
  for (std::size_t number = 0; number < own.size(); ++number)
    own[number] = {double(hashes_[number]), 0.0, HUGE_VAL};
  std::size_t at = 0;
  for (const BodyPiece* piece : pieces)
    for (int cell = 0; piece != nullptr && cell < piece->model.mesh.numCells(); ++cell, ++at) {
      auto& record = own[std::size_t(of_[at])];
      if (!piece->owns(cell) || ++record[1] > 1.0)
        continue;
      record[2] = double(piece->numbers[std::size_t(cell)]);
      Edges edges{};
      measureEdges(piece->model.mesh, cell, edges);
      std::copy(edges.begin(), edges.end(), record.begin() + 3);
    }
  std::vector<Vector> records(std::size_t(comm.size()));
  std::vector<std::vector<int>> asked(records.size());
  for (std::size_t number = 0; number < own.size(); ++number) {
    const auto rank = std::size_t(hashes_[number] % comm.size());
    records[rank].insert(records[rank].end(), own[number].begin(), own[number].end());
    asked[rank].push_back(int(number));
  }
  records = exchangedValues(records, comm);
  join(records);
  records = exchangedValues(records, comm);
  for (std::size_t rank = 0; rank < records.size(); ++rank)
    for (std::size_t i = 0; i < asked[rank].size(); ++i) {
      const auto number = std::size_t(asked[rank][i]);
      const double* record = records[rank].data() + i * perClass;
      count_[number] = int(record[1]);
      if (record[2] == own[number][2])
        continue;
      std::copy_n(record + 3, std::tuple_size_v<Edges>, origins_[int(number)].begin());
    }
}

} // namespace ndframe
