#include "ndframe/mesh/mesh_bytes.hpp"

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
  stream.arrays(mesh.notes);
  stream.array(mesh.groups.kind);
  stream.length(mesh.groups.names);
  for (auto& names : mesh.groups.names)
    stream.arrays(names);
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
  reader.requireEnd();
  return mesh;
}

} // namespace ndframe
