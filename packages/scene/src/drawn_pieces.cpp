#include "ndframe/scene/drawn_pieces.hpp"

#include <algorithm>
#include <limits>

#include "inside_forces.hpp"
#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/base/ascending.hpp"
#include "ndframe/mesh/byte_stream.hpp"
#include "ndframe/meshing/refined_source.hpp"
#include "ndframe/scene/joined_vertices.hpp"
#include "ndframe/scene/stage.hpp"
#include "piece_parts.hpp"

namespace ndframe
{
namespace
{

using Number = BodyPieces::Number;

/// A vertex that touches one of an earlier body, or of the same, which decides who owns both.
struct Partner
{
  int body;
  Number vertex;
  int firstBody;
  Number firstVertex;
};

/// The points that supports hold.
std::vector<std::vector<double>> heldPoints(const BodySettings& body)
{
  std::vector<std::vector<double>> points;
  for (const Params& support : body.supports)
    if (support.has("At"))
      points.push_back(support.get<std::vector<double>>("At"));
  return points;
}

/// Bodies that touch are halved as often; none touches itself.
bool touchOthersAlike(const SceneSettings& scene)
{
  const auto halvings = [&](const std::string& name) {
    const auto body = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                   [&](const BodySettings& one) { return one.name == name; });
    return body == scene.bodies.end() || body->isRigid ? -1 : halvingsOf(body->shape);
  };
  return std::all_of(scene.interfaces.begin(), scene.interfaces.end(), [&](const InterfaceSettings& interface) {
    const int a = halvings(interface.dirichletBody), b = halvings(interface.neumannBody);
    return interface.dirichletBody != interface.neumannBody && (a == b || a < 0 || b < 0);
  });
}

/// The pieces that a rank reads of each body; none: a body has not as many for each. Rank 0 looks for the files.
std::vector<std::int64_t> piecesOfRanks(const SceneSettings& scene, const SceneComponents& components, const Comm& comm)
{
  Vector pieces(scene.bodies.size(), 0.0);
  for (std::size_t b = 0; b < pieces.size() && comm.rank() == 0; ++b)
    if (!scene.bodies[b].isRigid)
      pieces[b] = components.meshSources.build(scene.bodies[b].shape)->drawn().numPieces();
  comm.broadcast(pieces);
  std::vector<std::int64_t> ofRanks;
  for (std::size_t b = 0; b < pieces.size(); ++b) {
    const auto count = std::int64_t(pieces[b]);
    if (!scene.bodies[b].isRigid && (count == 0 || count % comm.size() != 0))
      return {};
    ofRanks.push_back(count / comm.size());
  }
  return ofRanks;
}

std::optional<NumberedMesh> readOwn(const MeshSource& source, std::int64_t count, const Comm& comm)
{
  try {
    return source.readPieces(int(comm.rank() * count), int((comm.rank() + 1) * count));
  } catch (const InputError&) { // told where they are read as a whole
    return std::nullopt;
  }
}

/// Ranks have about as many vertices each, and enough of them.
bool canBeParts(const DrawnPieces& pieces, const Comm& comm)
{
  constexpr double mostUneven = 1.2; // the largest part, relative to the mean
  Number vertices = 0;
  Vector largest{0.0};
  for (const std::optional<BodyPieces>& body : pieces.bodies)
    if (body) {
      vertices += body->counts[0];
      largest[0] += double(std::count(body->owners.begin(), body->owners.end(), comm.rank()));
    }
  takeLargest(largest, comm);
  return vertices >= fewestVertices(comm.size()) && vertices <= std::numeric_limits<int>::max() &&
         largest[0] * comm.size() <= mostUneven * double(vertices);
}

/// On rank 0: the vertices that touch others.
std::vector<Partner> partnersOf(const DrawnPieces& pieces, const DrawnScene& drawn, const std::vector<int>& bodies)
{
  const JoinedVertices joined = joinedVertices(*drawn.model, bodies);
  std::vector<Partner> partners;
  std::vector<std::pair<int, Number>> first(std::size_t(joined.count), {-1, 0});
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::vector<Number>& vertices = pieces.bodies[std::size_t(bodies[b])]->outer.points;
    for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex) {
      auto& [body, number] = first[std::size_t(joined(b, int(vertex)))];
      if (body < 0)
        std::tie(body, number) = std::pair(bodies[b], vertices[vertex]);
      else
        partners.push_back({bodies[b], vertices[vertex], body, number});
    }
  }
  return partners;
}

/// A body's part with who owns what of it.
class OwnedPart
{
public:
  /// first: number of each body's first vertex among all.
  OwnedPart(DrawnPieces& scene, int body, const std::vector<Partner>& partners, const std::vector<Number>& first)
      : scene_(scene), body_(*scene.bodies[std::size_t(body)]), first_(first), number_(body), partners_(partners)
  {}

  DrawnPart complete(bool withHalo, const Comm& comm)
  {
    for (const Partner& partner : partners_)
      if (partner.body == number_)
        body_.owners[placeIn(body_.part.points, partner.vertex)] = ownerOf(partner);
    if (withHalo)
      addHalo(body_, comm);
    RefinedNumbers numbers(body_.part.mesh, body_.halvings, wholeOf(body_, comm));
    DrawnOwners owners{orders(), std::move(body_.owners)};
    return {std::move(body_.part.mesh), std::move(numbers), std::move(owners), body_.halvings};
  }

private:
  static std::size_t placeIn(const std::vector<Number>& numbers, Number number)
  {
    const int place = placeOf(numbers, number);
    NDFRAME_ASSERT(place >= 0, "all ranks have the vertices at contact");
    return std::size_t(place);
  }

  int ownerOf(const Partner& partner) const
  {
    const BodyPieces& other = *scene_.bodies[std::size_t(partner.firstBody)];
    return other.touchingOwners[placeIn(other.touching, partner.firstVertex)];
  }

  std::vector<int> orders() const
  {
    std::vector<int> orders;
    for (const Number point : body_.part.points)
      orders.push_back(int(first_[std::size_t(number_)] + point));
    for (const Partner& partner : partners_)
      if (partner.body == number_)
        orders[placeIn(body_.part.points, partner.vertex)] =
            int(first_[std::size_t(partner.firstBody)] + partner.firstVertex);
    return orders;
  }

  const DrawnPieces& scene_;
  BodyPieces& body_;
  const std::vector<Number>& first_;
  int number_;
  const std::vector<Partner>& partners_;
};

} // namespace

std::optional<DrawnPieces> readPieces(const SceneSettings& scene, const SceneComponents& components,
                                      std::vector<AskedPoints> points, const Comm& comm, Ledger& ledger)
{
  const bool haveMaterials = std::all_of(scene.bodies.begin(), scene.bodies.end(), [&](const BodySettings& body) {
    return body.isRigid || body.regions.empty() || body.material; // else cells without one have to be told
  });
  if (!haveMaterials || !touchOthersAlike(scene))
    return std::nullopt;
  const auto timer = timeStage(ledger, Stage::Read);
  const std::vector<std::int64_t> counts = piecesOfRanks(scene, components, comm);
  if (counts.empty())
    return std::nullopt;
  DrawnPieces pieces;
  for (std::size_t b = 0; b < counts.size(); ++b) {
    const BodySettings& body = scene.bodies[b];
    pieces.bodies.emplace_back();
    if (body.isRigid)
      continue;
    points[b].nearVertices = heldPoints(body);
    const PieceSettings settings{contactSides(scene, body.name), std::move(points[b]), halvingsOf(body.shape),
                                 !body.shape.get<std::vector<std::string>>("Blocks").empty()};
    const auto source = components.meshSources.build(body.shape);
    pieces.bodies[b] = sharedPieces(readOwn(source->drawn(), counts[b], comm), settings, comm);
    if (!pieces.bodies[b])
      return std::nullopt;
    const auto forces = forcesInside(*pieces.bodies[b], body, components, scene.order, comm);
    if (!forces)
      return std::nullopt;
    pieces.bodies[b]->forcesInside = *forces;
    addCellsAtContact(*pieces.bodies[b], comm);
    pieces.numPieces += counts[b];
  }
  return canBeParts(pieces, comm) ? std::optional(std::move(pieces)) : std::nullopt;
}

DrawnScene outerScene(DrawnPieces& pieces)
{
  DrawnScene drawn;
  for (std::optional<BodyPieces>& body : pieces.bodies) {
    drawn.asked.push_back(body ? body->halvings : 0);
    drawn.inside.push_back(body ? InsideOfBody{body->measure, body->cellsOfKinds, body->forcesInside} : InsideOfBody{});
    drawn.meshes.push_back(body ? std::move(body->outer.mesh) : Mesh());
    drawn.numbers.push_back( // of vertices alone
        body
            ? RefinedNumbers(drawn.meshes.back(), body->halvings, {body->cells, body->counts, {body->outer.points}, {}})
            : RefinedNumbers(Mesh(), 0));
  }
  drawn.halvings = drawn.asked;
  drawn.before.resize(drawn.meshes.size());
  return drawn;
}

std::vector<DrawnPart> drawnParts(DrawnPieces&& pieces, const DrawnScene& drawn, bool withHalo, const Comm& comm)
{
  std::vector<int> bodies;
  std::vector<Number> first{0};
  for (std::size_t b = 0; b < pieces.bodies.size(); ++b) {
    if (pieces.bodies[b])
      bodies.push_back(int(b));
    first.push_back(first.back() + (pieces.bodies[b] ? pieces.bodies[b]->counts[0] : 0));
  }
  const std::string bytes = fromRankZero(comm, [&] {
    ByteWriter writer;
    writer.array(partnersOf(pieces, drawn, bodies));
    return writer.take();
  });
  std::vector<Partner> partners;
  ByteReader(bytes).array(partners);
  std::vector<DrawnPart> parts;
  for (const int body : bodies)
    parts.push_back(OwnedPart(pieces, body, partners, first).complete(withHalo, comm));
  return parts;
}

} // namespace ndframe
