#include "ndframe/mesh/mesh_bytes.hpp"

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/byte_stream.hpp"

namespace ndframe
{

namespace
{

/// Everything in a mesh, in one order for both directions.
template <class Stream, class AnyMesh>
void walk(Stream& stream, AnyMesh& mesh)
{
  stream.number(mesh.dim);
  stream.array(mesh.points);
  stream.array(mesh.cells);
  stream.length(mesh.sides);
  for (auto& side : mesh.sides) {
    stream.array(side.name);
    stream.array(side.facets);
  }
  stream.length(mesh.notes);
  for (auto& note : mesh.notes)
    stream.array(note);
  stream.array(mesh.groups.kind);
  stream.length(mesh.groups.names);
  for (auto& names : mesh.groups.names) {
    stream.length(names);
    for (auto& name : names)
      stream.array(name);
  }
}

} // namespace

std::string toBytes(const Mesh& mesh)
{
  ByteWriter writer;
  walk(writer, mesh);
  return writer.take();
}

Mesh meshFromBytes(std::string_view bytes)
{
  ByteReader reader(bytes);
  Mesh mesh;
  walk(reader, mesh);
  NDFRAME_ASSERT(reader.atEnd(), "something follows the bytes of a mesh");
  return mesh;
}

} // namespace ndframe
