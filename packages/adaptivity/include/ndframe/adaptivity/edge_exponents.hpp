#pragma once

#include <vector>

#include "ndframe/adaptivity/contribution_model.hpp"
#include "ndframe/algebra/comm.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// How the error falls around the edges of solids, learned from one mesh to the next.
///
/// Around an edge with u ~ r^lambda the cells that have a piece of it as an edge contribute sum eta_K^2 ~ (V /
/// L)^lambda per length L together, V the volume of all of them; where the solution is smooth, (V / L)^(p+1) with
/// displacements of degree p: a corner of the plane, along a line. Two meshes show lambda wherever these cells became
/// smaller. Edges are those of the very first mesh where its boundary turns, where the sides change and where regions
/// meet at an angle or end. The cells at the ends of an edge are left out where there are others.
class EdgeExponents
{
public:
  /// How the next mesh is made of the one before.
  enum class Meshes
  {
    Halved,   ///< points keep their places, edges are halved in the middle
    MadeAnew, ///< an edge lies along the one of the first mesh that it is nearest to; those in a row learn together
  };
  explicit EdgeExponents(int degree, Meshes meshes = Meshes::Halved) ///< degree: p
      : smooth_(degree + 1.0), kind_(meshes)
  {}

  /// The next mesh of every body and eta_K on it.
  /// isCoarse: nothing can be learned from this mesh, nor from those before.
  void observe(const std::vector<const Mesh*>& meshes, const std::vector<Vector>& contributions, bool isCoarse = false);

  /// lambda per body and vertex of the meshes last seen; p + 1 off the edges and where nothing has been learned.
  const std::vector<Vector>& exponents() const { return exponents_; }
  /// Whether any edge is known to be singular.
  bool knowsAny() const;
  /// Of the edge with this lambda.
  const EdgeDirections& directions() const { return directions_; }

private:
  /// Sums over the cells of an edge.
  struct Tube
  {
    double squared = 0.0, volume = 0.0, length = 0.0;
  };
  /// An edge of the last mesh.
  struct Piece
  {
    std::array<int, 2> ends;
    std::array<double, 3> direction;
  };
  struct Crease
  {
    std::array<std::array<double, 3>, 2> ends;
    std::array<double, 3> direction;
    double exponent;
    int row;                     ///< edges with the same number go on straight, or nearly so
    std::vector<Piece> pieces{}; ///< of the last mesh that lie along it, from end to end
    Tube tube{};                 ///< on the last mesh that could teach
  };

  void findCreases(const Mesh& mesh);
  static void findRows(std::vector<Crease>& creases);
  static void addInRows(const std::vector<Crease>& creases, std::vector<Tube>& tubes);
  static void findHalves(const Mesh& mesh, std::vector<Crease>& creases);
  static void findPieces(const Mesh& mesh, std::vector<Crease>& creases);
  static std::vector<Tube> tubesOf(const Mesh& mesh, const Vector& contributions, const std::vector<Crease>& creases);
  void learn(Crease& crease, const Tube& now) const;
  void tellVertices(const Mesh& mesh, const std::vector<Crease>& creases);

  double smooth_;
  Meshes kind_;
  std::vector<std::vector<Crease>> creases_; ///< per body
  std::vector<Vector> exponents_;
  EdgeDirections directions_;
};

} // namespace ndframe
