#include "ndframe/equilibrium/cell_classes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <unordered_map>

#include "ndframe/algebra/exchanged_values.hpp"
#include "ndframe/base/mixed_hash.hpp"
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
      hash = mixedHash(hash, std::uint64_t(entry));
    return std::size_t(hash);
  }
};

/// Fills in the edge vectors of a shape; returns the longest coordinate difference.
double measureShape(const Mesh& mesh, int cell, Shape& shape)
{
  constexpr double units = 17592186044416.0; // 2^44
  const SortedCell sorted = sortedCell(mesh, cell);
  const double* origin = mesh.point(sorted.vertices[0]);
  std::array<double, 9> edges{};
  double length = 0.0;
  for (std::size_t at = 0; at < edges.size(); ++at) {
    edges[at] = mesh.point(sorted.vertices[at / 3 + 1])[at % 3] - origin[at % 3];
    length = std::max(length, std::abs(edges[at]));
  }
  for (std::size_t at = 0; at < edges.size(); ++at)
    shape[at] = std::llround(edges[at] / length * units);
  return length;
}

/// The same on all ranks, which number the laws of their cells differently.
std::int64_t hashOf(const Elasticity& law)
{
  std::uint64_t hash = std::uint64_t(law.dim);
  for (const double entry : law.D) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &entry, sizeof bits);
    hash = mixedHash(hash, bits);
  }
  return std::int64_t(hash);
}

/// What a rank says of a class, or hears: its hash, how many own cells, the number of the first one.
constexpr std::size_t perClass = 3;

/// The ranks' records of the same classes become those of all: cells are counted together, the first of all is first.
void join(std::vector<Vector>& records)
{
  std::unordered_map<std::int64_t, std::pair<double, double>> all; // count, first
  for (const Vector& ofRank : records)
    for (std::size_t at = 0; at < ofRank.size(); at += perClass) {
      auto& [count, first] = all.try_emplace(std::int64_t(ofRank[at]), 0.0, HUGE_VAL).first->second;
      count += ofRank[at + 1];
      first = std::min(first, ofRank[at + 2]);
    }
  for (Vector& ofRank : records)
    for (std::size_t at = 0; at < ofRank.size(); at += perClass)
      std::tie(ofRank[at + 1], ofRank[at + 2]) = all.at(std::int64_t(ofRank[at]));
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
}

CellClasses::CellClasses(const std::vector<const BodyPiece*>& pieces, const Comm& comm)
{
  agree(pieces, find(modelsOf(pieces)), comm);
}

std::vector<std::int64_t> CellClasses::find(const std::vector<const BodyModel*>& bodies)
{
  constexpr int exactBits = 53; // of a hash that is sent as a double
  std::vector<std::int64_t> hashes;
  std::unordered_map<Shape, int, HashOfShape> known;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int cell = 0; bodies[b] != nullptr && cell < bodies[b]->mesh.numCells(); ++cell) {
      Shape shape{};
      length_.push_back(measureShape(bodies[b]->mesh, cell, shape));
      shape[9] = std::int64_t(b);
      shape[10] = bodies[b]->laws.number(cell);
      const auto [place, isNew] = known.emplace(shape, size());
      if (isNew) {
        first_.push_back(int(of_.size()));
        count_.push_back(0);
        shape[10] = hashOf(bodies[b]->laws(cell));
        hashes.push_back(std::int64_t(HashOfShape()(shape) >> (64 - exactBits)));
      }
      of_.push_back(place->second);
      ++count_[std::size_t(place->second)];
    }
  hasOrigin_.assign(first_.size(), 1);
  return hashes;
}

/// Every class is looked after by the rank that its hash names.
void CellClasses::agree(const std::vector<const BodyPiece*>& pieces, const std::vector<std::int64_t>& hashes,
                        const Comm& comm)
{
  Vector counts(first_.size(), 0.0), firsts(first_.size(), HUGE_VAL);
  std::size_t at = 0;
  for (const BodyPiece* piece : pieces)
    for (int cell = 0; piece != nullptr && cell < piece->model.mesh.numCells(); ++cell, ++at)
      if (const auto number = std::size_t(of_[at]); piece->owns(cell) && counts[number]++ == 0.0)
        firsts[number] = double(piece->numbers[std::size_t(cell)]);
  std::vector<Vector> records(std::size_t(comm.size()));
  std::vector<std::vector<int>> asked(records.size());
  for (std::size_t number = 0; number < counts.size(); ++number) {
    const auto rank = std::size_t(hashes[number] % comm.size());
    records[rank].insert(records[rank].end(), {double(hashes[number]), counts[number], firsts[number]});
    asked[rank].push_back(int(number));
  }
  records = exchangedValues(records, comm);
  join(records);
  records = exchangedValues(records, comm);
  for (std::size_t rank = 0; rank < records.size(); ++rank)
    for (std::size_t i = 0; i < asked[rank].size(); ++i) {
      const auto number = std::size_t(asked[rank][i]);
      count_[number] = int(records[rank][i * perClass + 1]);
      hasOrigin_[number] = char(records[rank][i * perClass + 2] == firsts[number]);
    }
}

} // namespace ndframe
