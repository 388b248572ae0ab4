#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "gmsh_model.hpp"
#include "length_field.hpp"
#include "ndframe/meshing/remesh.hpp"

namespace ndframe
{

/// Vertices that a side shall have, in any order: those of a neighbour's mesh.
struct FixedSide
{
  std::string side;
  std::vector<std::array<double, 2>> points;
  double tolerance; ///< points that are closer are the same
};

/// The plane geometry of a script, meshed with lengths of edges from outside.
class GmshGeometry
{
public:
  /// Reads the script and leaves out regions that are not the body's, and what the script says about sizes. Throws
  /// FileError.
  explicit GmshGeometry(const MeshScript& script);

  /// The mesh; `file` is written on the way. Throws GmshGaveUp, and FileError for a fixed side without a vertex where
  /// the script has a corner.
  Mesh mesh(const LengthField& lengths, const std::vector<FixedSide>& fixed, GmshAlgorithm algorithm,
            const std::string& file);

private:
  using Point = std::array<double, 3>;
  /// A node of gmsh.
  struct Node
  {
    std::size_t tag;
    Point point;
  };
  /// A point at a curve, and the parameter of the curve's point that is nearest to it.
  struct CurvePoint
  {
    double parameter;
    Point point;
    double distance; ///< between both
  };

  void fix(const FixedSide& side);
  void fixCurve(int curve, const FixedSide& side);
  void replaceCurve(int curve, const std::vector<CurvePoint>& inside, std::array<Node, 2> ends);

  std::vector<Node> nodesOf(int dim, int entity) const;
  /// In the direction of the parameter.
  std::array<Node, 2> endsOf(int curve) const;
  CurvePoint project(int curve, Point point) const;

  GmshModel model_;
  const GmshFunctions& gmsh_ = GmshFunctions::get();
  std::vector<std::string> regions_;
  std::set<int> free_; ///< curves of the body's boundary whose vertices gmsh may choose
};

} // namespace ndframe
