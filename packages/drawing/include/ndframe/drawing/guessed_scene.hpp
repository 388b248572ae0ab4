#pragma once

#include <set>

#include "ndframe/drawing/deck_writer.hpp"
#include "ndframe/drawing/drawn_scene.hpp"

namespace ndframe
{

/// Supports and loads, which no drawing says: enough for a scene that has a solution, each with a comment.
///
/// The lowest body with a free side is clamped there, away from what it touches. A body that touches others in one
/// direction is moved against them by its free side; without one, or where what it touches is all around it, a body
/// force presses it. A body between others is left to them. Limit: bodies without a moved side may still be turned or
/// pulled off by their force, which the run says.
class GuessedScene
{
public:
  /// The scene must live as long. Throws InputError where no side is left to hold a body.
  explicit GuessedScene(const DrawnAssembly& scene);

  static constexpr const char* holdName = "hold"; ///< of the supports Hold

  /// A body whose Hold is refused has none: a side of its own is moved or clamped, or, without one, a Point stops it.
  void leaveOutHold(std::size_t body) { held_.insert(body); }

  /// Whether a support is at a vertex, which meshes that are made again need not have.
  bool holdsAVertex() const;

  /// The lists Supports and Loads of a body.
  void write(std::size_t body, DeckWriter& deck) const;

private:
  Vector3 down() const;
  Vector3 path(std::size_t body, const Vector3& push) const;
  void writeBase(const DrawnBody& body, const Vector3& push, DeckWriter& deck) const;
  void writePressed(const DrawnBody& body, const DrawnSide* held, DeckWriter& deck) const;
  void writeDriven(const DrawnBody& body, const DrawnSide& side, const Vector3& path, DeckWriter& deck) const;
  void writeClamp(const DrawnSide& side, DeckWriter& deck) const;
  void writeStill(const DrawnBody& body, const Vector3& push, DeckWriter& deck) const;
  void writeHeld(std::size_t body, const Vector3& push, DeckWriter& deck) const;
  void writeBodyForce(const Vector3& direction, DeckWriter& deck) const;
  void writeComponents(const Vector3& vector, DeckWriter& deck) const;
  std::size_t numNeighbours(std::size_t body) const;

  const DrawnAssembly& scene_;
  std::size_t base_;
  std::set<std::size_t> held_; ///< bodies that need no Hold
};

} // namespace ndframe
