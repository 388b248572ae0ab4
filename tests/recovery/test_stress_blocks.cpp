// The blocks that precondition the recovery of solids: they are the diagonal blocks of the energy that its steps see.

#include <gtest/gtest.h>

#include "admissibility/sample_problems.hpp"
#include "fem/sample_meshes.hpp"
#include "stress_matrices.hpp"
#include "stress_unknowns.hpp"

namespace ndframe
{
namespace
{

/// The energy of a body's tractions as the steps of the descent see it.
class Energy
{
public:
  explicit Energy(const test::Problem& problem)
      : body_(problem.body, problem.data), cells_({&body_}), faces_(cells_), edges_(stressEdges(faces_)),
        matrices_(body_, 0, StressMatrices::numBatches(body_)), blocks(faces_, edges_),
        unknowns_(faces_, edges_, blocks)
  {
    CellBlocks work(body_.facetData());
    matrices_.find(0, matrices_.last(), [&](const CellMatrices& found) {
      const auto parts = blocks.parts(found.cell, found, work);
      for (int c = 0; c < found.count; ++c)
        blocks.add(found.cell + c, parts[std::size_t(c)]);
    });
    blocks.invert(Comm::single(), 1);
  }

  /// Half its derivative.
  Vector times(const Vector& y) const
  {
    const auto size = std::size_t(body_.facetData());
    const Vector T = unknowns_.tractions(y, 1);
    Vector sums(T.size(), 0.0);
    for (int batch = 0; batch < matrices_.last(); ++batch) {
      Vector own(4 * size * StressMatrices::lanes, 0.0), forces(own.size(), 0.0);
      each(batch, [&](const StressFace& face, std::size_t side, std::size_t at, std::size_t place) {
        face.toSide(side, T.data() + at * size, int(size), own.data() + place * size);
      });
      matrices_.multiply(batch, own.data(), forces.data());
      each(batch, [&](const StressFace& face, std::size_t side, std::size_t at, std::size_t place) {
        face.fromSide(side, forces.data() + place * size, int(size), sums.data() + at * size);
      });
    }
    return unknowns_.gradient(sums, 1);
  }

  int numFaces() const { return faces_.size(); }
  std::size_t numEdges() const { return edges_.size(); }

private:
  template <class Visit>
  void each(int batch, const Visit& visit) const
  {
    for (int c = 0; c < matrices_.sizeOf(batch); ++c)
      for (int facet = 0; facet < 4; ++facet) {
        const int cell = batch * StressMatrices::lanes + c, f = faces_.of(cell, facet);
        visit(faces_[f], faces_[f].sideOf(cell), std::size_t(f), std::size_t(4 * c + facet));
      }
  }

  StarBody body_;
  StressCells cells_;
  StressFaces faces_;
  std::vector<StressEdge> edges_;
  StressMatrices matrices_;

public:
  StressBlocks blocks;

private:
  StressUnknowns unknowns_;
};

} // namespace

TEST(StressBlocks, AreTheDiagonalBlocksOfTheEnergy)
{
  for (const int degree : {1, 2})
    for (const char* kind : {"clamped", "rollers", "corner"}) {
      const test::Problem problem =
          test::solved(test::makeBody(test::sampleMesh(3, 35.0), 1, test::conditions(3, kind)), degree);
      const Energy energy(problem);
      const StressBlocks& blocks = energy.blocks;
      std::vector<int> begin;
      for (int f = 0; f < energy.numFaces(); ++f)
        begin.push_back(blocks.ofFace(f));
      for (std::size_t e = 0; e < energy.numEdges(); ++e)
        begin.push_back(blocks.ofEdge(e));
      begin.push_back(blocks.size());
      test::Random random(7);
      for (std::size_t b = 0; b + 1 < begin.size(); b += 11) {
        Vector y(std::size_t(blocks.size()), 0.0);
        for (int i = begin[b]; i < begin[b + 1]; ++i)
          y[std::size_t(i)] = random();
        const Vector same = blocks.precondition(energy.times(y), std::vector<char>(begin.size() - 1, 0), 1);
        for (int i = begin[b]; i < begin[b + 1]; ++i)
          EXPECT_NEAR(same[std::size_t(i)], y[std::size_t(i)], 1e-9) << kind << ", block " << b;
      }
    }
}

} // namespace ndframe
