// The blocks that precondition the recovery of solids: they are the diagonal blocks of the energy that its steps see.

#include <gtest/gtest.h>

#include "admissibility/sample_problems.hpp"
#include "fem/sample_meshes.hpp"
#include "ndframe/simd/stress_matrices.hpp"
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
        ofClasses(cells_), matrices_(cells_, ofClasses), blocks(faces_, edges_, ofClasses),
        unknowns_(faces_, edges_, blocks)
  {
    CellBlocks work(faces_);
    Vector space;
    for (int batch = 0; batch < matrices_.numBatches(); ++batch)
      if (matrices_.isOfClass(batch))
        for (int c = 0; c < matrices_.sizeOf(batch); ++c)
          blocks.add(matrices_.cells(batch)[c], blocks.partsOfClass(matrices_.cells(batch)[c]));
      else
        matrices_.find(batch, space, [&](const CellFacets& found) {
          work.compute(found);
          for (int c = 0; c < found.count; ++c)
            blocks.add(found.cells[c], blocks.parts(work, c, found.cells[c]));
        });
    blocks.invert(StressSharing(faces_, edges_, Comm::single()), 1);
  }

  /// Half its derivative.
  Vector times(const Vector& y, bool rounded = false) const
  {
    constexpr std::size_t lanes = StressMatrices::lanes;
    const auto size = std::size_t(body_.facetData());
    Vector T, gradient;
    unknowns_.tractions(y, 1, T);
    Vector sums(T.size(), 0.0);
    for (int batch = 0; batch < matrices_.numBatches(); ++batch) {
      Vector x(StressMatrices::mostNumbers, 0.0), forces(x), own(size);
      each(batch, [&](const StressFace& face, std::size_t side, std::size_t f, std::size_t facet, std::size_t lane) {
        face.toSide(side, T.data() + f * size, int(size), own.data());
        for (std::size_t i = 0; i < size; ++i)
          x[(facet * size + i) * lanes + lane] = own[i];
      });
      if (rounded) {
        const double unit = blocks.unit();
        std::vector<float> few(x.size(), 0.0F), result(x.size(), 0.0F); // cell after cell
        const std::size_t numbers = 4 * size;
        for (std::size_t i = 0; i < numbers * lanes; ++i)
          few[i % lanes * numbers + i / lanes] = float(x[i]);
        matrices_.multiplyRounded(batch, unit, few.data(), result.data());
        for (std::size_t i = 0; i < numbers * lanes; ++i)
          forces[i] = result[i % lanes * numbers + i / lanes] / unit;
      } else
        matrices_.multiply(batch, x.data(), forces.data());
      each(batch, [&](const StressFace& face, std::size_t side, std::size_t f, std::size_t facet, std::size_t lane) {
        for (std::size_t i = 0; i < size; ++i)
          own[i] = forces[(facet * size + i) * lanes + lane];
        face.fromSide(side, own.data(), int(size), sums.data() + f * size);
      });
    }
    Vector room;
    unknowns_.gradient(
        [&](int face, double* forces) { std::copy_n(sums.data() + std::size_t(face) * size, size, forces); }, 1, room,
        gradient);
    return gradient;
  }

  int numFaces() const { return faces_.size(); }
  std::size_t numEdges() const { return edges_.size(); }

private:
  template <class Visit>
  void each(int batch, const Visit& visit) const
  {
    for (int c = 0; c < matrices_.sizeOf(batch); ++c)
      for (int facet = 0; facet < 4; ++facet) {
        const int cell = matrices_.cells(batch)[c], f = faces_.of(cell, facet);
        visit(faces_[f], faces_[f].sideOf(cell), std::size_t(f), std::size_t(facet), std::size_t(c));
      }
  }

  StarBody body_;
  StressCells cells_;
  StressFaces faces_;
  std::vector<StressEdge> edges_;

public:
  ClassMatrices ofClasses;

private:
  StressMatrices matrices_;

public:
  StressBlocks blocks;

private:
  StressUnknowns unknowns_;
};

/// Every `step`th block, by what the energy makes of unknowns there alone. Inverses have single precision.
void expectDiagonalBlocks(const Energy& energy, std::size_t step, const std::string& what)
{
  const StressBlocks& blocks = energy.blocks;
  std::vector<int> begin;
  for (int f = 0; f < energy.numFaces(); ++f)
    begin.push_back(blocks.ofFace(f));
  for (std::size_t e = 0; e < energy.numEdges(); ++e)
    begin.push_back(blocks.ofEdge(e));
  begin.push_back(blocks.size());
  test::Random random(7);
  for (std::size_t b = 0; b + 1 < begin.size(); b += step) {
    Vector y(std::size_t(blocks.size()), 0.0);
    for (int i = begin[b]; i < begin[b + 1]; ++i)
      y[std::size_t(i)] = random();
    const Vector gradient = energy.times(y);
    std::vector<float> scaled(gradient.size()), same;
    std::transform(gradient.begin(), gradient.end(), scaled.begin(),
                   [&](double value) { return float(value * blocks.unit()); });
    blocks.precondition(scaled, std::vector<char>(begin.size() - 1, 0), 1, same);
    for (int i = begin[b]; i < begin[b + 1]; ++i)
      EXPECT_NEAR(same[std::size_t(i)], y[std::size_t(i)], 1e-5) << what << ", block " << b;
  }
}

/// A box of equal cells with a few points out of place and layers of other sizes.
Mesh partlyEqual()
{
  return test::moved(test::box({6, 6, 6}), [](double* point) {
    point[0] *= 1.0 + 0.3 * double(point[0] > 0.7);
    if (point[1] > 0.9 && point[2] > 0.9)
      point[1] += 0.05 * (1.0 + point[0] + point[0] * point[0]);
  });
}

} // namespace

TEST(StressBlocks, AreTheDiagonalBlocksOfTheEnergy)
{
  for (const int degree : {1, 2})
    for (const char* kind : {"clamped", "rollers", "corner"}) {
      const test::Problem problem =
          test::solved(test::makeBody(test::sampleMesh(3, 35.0), 1, test::conditions(3, kind)), degree);
      expectDiagonalBlocks(Energy(problem), 11, kind);
    }
}

TEST(StressBlocks, AreThoseOfEveryFaceAndEdgeWhereCellsShareThem)
{
  for (const int degree : {1, 2}) {
    const test::Problem problem = test::solved(test::makeBody(partlyEqual(), 1, test::conditions(3, "corner")), degree);
    const Energy energy(problem);
    EXPECT_GE(energy.ofClasses.size(), 12);
    EXPECT_LT(energy.blocks.numKept(), energy.blocks.numBlocks() / 2);
    expectDiagonalBlocks(energy, 53, "shared");
  }
}

TEST(StressBlocks, DirectionsHaveFewerDigits)
{
  // Cells without a class: rounded where they are not stretched, and exact where single precision would spoil them.
  for (const double aspect : {1.0, 100.0}) {
    const Mesh mesh = test::moved(test::sampleMesh(3, 35.0), [&](double* point) { point[2] *= aspect; });
    const test::Problem problem = test::solved(test::makeBody(mesh, 1, test::conditions(3, "clamped")), 2);
    const Energy energy(problem);
    test::Random random(3);
    Vector y(std::size_t(energy.blocks.size()));
    for (double& value : y)
      value = random();
    const Vector all = energy.times(y), few = energy.times(y, true);
    double difference = 0.0, size = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      difference = std::hypot(difference, few[i] - all[i]);
      size = std::hypot(size, all[i]);
    }
    EXPECT_LT(difference, (aspect == 1.0 ? 3e-6 : 2e-7) * size) << aspect; // measured: 2.6e-7, 1.5e-8
  }
}

} // namespace ndframe
