#include "ndframe/mesh/mesh_bytes.hpp"

#include <cstring>
#include <type_traits>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

namespace
{

/// Walks through the parts of a mesh, writing them.
class Writer
{
public:
  template <class T>
  void number(const T& value)
  {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void array(const T& values) // a vector of numbers or a string
  {
    number(values.size());
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(typename T::value_type));
  }
  template <class T>
  void length(const std::vector<T>& items)
  {
    number(items.size());
  }
  std::string take() { return std::move(bytes_); }

private:
  std::string bytes_;
};

/// The same walk, reading.
class Reader
{
public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  template <class T>
  void number(T& value)
  {
    requireLeft(1, sizeof value);
    std::memcpy(&value, left_.data(), sizeof value);
    left_.remove_prefix(sizeof value);
  }
  template <class T>
  void array(T& values)
  {
    using Value = typename T::value_type;
    static_assert(std::is_trivially_copyable_v<Value>);
    std::size_t size = 0;
    number(size);
    requireLeft(size, sizeof(Value));
    values.resize(size);
    if (size > 0)
      std::memcpy(values.data(), left_.data(), size * sizeof(Value));
    left_.remove_prefix(size * sizeof(Value));
  }
  template <class T>
  void length(std::vector<T>& items)
  {
    std::size_t size = 0;
    number(size);
    requireLeft(size, sizeof size); // each item begins with its own length
    items.resize(size);
  }
  bool atEnd() const { return left_.empty(); }

private:
  void requireLeft(std::size_t count, std::size_t size) const
  {
    NDFRAME_ASSERT(count <= left_.size() / size, "the bytes of a mesh end too early");
  }

  std::string_view left_;
};

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
  Writer writer;
  walk(writer, mesh);
  return writer.take();
}

Mesh meshFromBytes(std::string_view bytes)
{
  Reader reader(bytes);
  Mesh mesh;
  walk(reader, mesh);
  NDFRAME_ASSERT(reader.atEnd(), "something follows the bytes of a mesh");
  return mesh;
}

} // namespace ndframe
