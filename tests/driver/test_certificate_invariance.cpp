// What must not matter to the bound: units, orientation, numbering, order and roles of the bodies in the deck.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driver/certificate_numbers.hpp"
#include "driver/program.hpp"
#include "io/temporary_folder.hpp"
#include "reading/mesh_files.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

const std::string oneSweep = "Error Estimation/Recovery/Sweeps=1";

struct Way
{
  const char* deck;
  std::vector<std::string> settings;
};

void PrintTo(const Way& way, std::ostream* out)
{
  *out << way.deck;
  for (const auto& setting : way.settings)
    *out << ", " << setting;
}

/// Contact everywhere, contact lost on some facets, a gap; both tractions, sweeps, order 1, element equilibration.
const std::vector<Way>& ways()
{
  static const std::vector<Way> all{
      {"punch", {}},
      {"punch", {"Discretization/Order=1", "Error Estimation/Recovery/Degree=2"}},
      {"punch", {"Error Estimation/Mode=Paper", "Error Estimation/Interface Traction/Mean=Updated"}},
      {"punch", {"Interfaces/contact/Gap=0.01*x^2", "Coupling/Type=Monolithic"}},
      {"contact-loss", {oneSweep}},
      {"contact-loss", {"Error Estimation/Interface Traction/Type=Projected", "Error Estimation/Recovery/Degree=3"}},
      {"contact-loss",
       {"Error Estimation/Interface Traction/Type=Projected", "Error Estimation/Recovery/Type=Element"}}};
  return all;
}

class CertificateInvariance : public testing::TestWithParam<Way>
{
protected:
  static Scene scene()
  {
    Scene result = smallScene(GetParam().deck);
    for (const auto& setting : GetParam().settings)
      result.set(setting);
    return result;
  }
};

/// A random permutation that is its own only by chance.
std::vector<int> permutation(int size, std::mt19937& generator)
{
  std::vector<int> all(std::size_t(size), 0);
  std::iota(all.begin(), all.end(), 0);
  std::shuffle(all.begin(), all.end(), generator);
  return all;
}

/// The mesh with other numbers of its vertices and cells, and other first vertices of its cells.
Mesh renumbered(const Mesh& mesh, std::mt19937& generator)
{
  const auto vertexOf = permutation(mesh.numPoints(), generator), cellOf = permutation(mesh.numCells(), generator);
  Mesh result = mesh;
  for (int p = 0; p < mesh.numPoints(); ++p)
    std::copy_n(mesh.point(p), 2, result.points.begin() + 2 * vertexOf[std::size_t(p)]);
  std::vector<int> first(cellOf.size());
  for (int c = 0; c < mesh.numCells(); ++c) {
    first[std::size_t(c)] = int(generator() % 3);
    for (int k = 0; k < 3; ++k)
      result.cells[std::size_t(3 * cellOf[std::size_t(c)] + k)] =
          vertexOf[std::size_t(mesh.cell(c)[(k + first[std::size_t(c)]) % 3])];
  }
  for (Side& side : result.sides)
    for (Facet& facet : side.facets)
      facet = {cellOf[std::size_t(facet.cell)], (facet.local + 3 - first[std::size_t(facet.cell)]) % 3};
  return result;
}

/// The list of a deck with this name inside another one.
DeckList& sublist(DeckList& list, const std::string& name)
{
  return *std::find_if(list.lists.begin(), list.lists.end(), [&](const DeckList& sub) { return sub.name == name; });
}

/// Takes the meshes of all bodies from Exodus files.
void readFromFiles(Scene& scene, const TemporaryFolder& folder, const std::vector<std::string>& names,
                   const std::vector<Mesh>& meshes)
{
  for (std::size_t b = 0; b < names.size(); ++b) {
    const std::string file = folder.file(names[b] + ".e");
    writeExodus(file, asExodusSample(meshes[b]));
    DeckList& mesh = sublist(sublist(sublist(scene.deck(), "Bodies"), names[b]), "Mesh");
    mesh.entries.clear();
    mesh.lists.clear();
    scene.set(fmt::format("Bodies/{}/Mesh/Type=Exodus", names[b]));
    scene.set(fmt::format("Bodies/{}/Mesh/File={}", names[b], file));
  }
}

} // namespace

/// Energy norms have the unit of length times the square root of stress (per thickness).
TEST_P(CertificateInvariance, UnderAChangeOfUnits)
{
  const auto reference = scene().run();
  for (const auto& [length, stress] : {std::pair(1e-3, 1e6), {1e3, 1e-9}}) {
    SCOPED_TRACE(fmt::format("lengths {}, stresses {}", length, stress));
    const auto outcome = scene().changeUnits(length, stress).run();
    expectSameErrors(errorsOf(outcome), errorsOf(reference), 1e-9, length * std::sqrt(stress));
  }
}

TEST_P(CertificateInvariance, UnderARotationByAnyAngle)
{
  const auto reference = scene().run();
  std::mt19937 generator(11);
  const double angle = std::uniform_real_distribution(0.0, 2 * M_PI)(generator);
  SCOPED_TRACE(angle);
  Scene rotated = scene();
  rotated.rotate(angle * 180.0 / M_PI).changeAll("Gap", [&](const std::string&) {
    return fmt::format("0.01 * ({:.17g} * x + {:.17g} * y)^2", std::cos(angle), std::sin(angle));
  });
  expectSameErrors(errorsOf(rotated.run()), errorsOf(reference), 1e-9);
}

TEST_P(CertificateInvariance, UnderAnotherOrderOfTheBodies)
{
  const auto reference = scene().run(), outcome = scene().reverseBodies().run();
  EXPECT_EQ(outcome.run.model.bodies[0].name, reference.run.model.bodies[1].name);
  expectSameErrors(errorsOf(outcome), errorsOf(reference), 1e-9);
}

TEST_P(CertificateInvariance, UnderAnotherNumberingOfTheMeshes)
{
  const auto reference = scene().run();
  const TemporaryFolder folder;
  std::mt19937 generator(5);
  std::vector<std::string> names;
  std::vector<Mesh> meshes;
  for (const auto& body : reference.run.model.bodies) {
    names.push_back(body.name);
    meshes.push_back(renumbered(body.mesh, generator));
  }
  Scene other = scene();
  readFromFiles(other, folder, names, meshes);
  const auto outcome = other.run();
  EXPECT_NE(outcome.run.model.bodies[0].mesh.points, reference.run.model.bodies[0].mesh.points);
  // Sweeps go over the stars one after the other, in an order that the numbering chooses: here the certificate differs,
  // by as little as one sweep leaves to the next.
  const auto& settings = GetParam().settings;
  const bool sweeps = std::find(settings.begin(), settings.end(), oneSweep) != settings.end();
  expectSameErrors(errorsOf(outcome), errorsOf(reference), sweeps ? 2e-3 : 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Scenes, CertificateInvariance, testing::ValuesIn(ways()));
