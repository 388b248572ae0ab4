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
  void array(const T& values) // a vector of numbers or a string
  {
    const std::size_t size = values.size();
    bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes_.append(reinterpret_cast<const char*>(values.data()), size * sizeof(typename T::value_type));
  }
  template <class T>
  void list(const std::vector<T>& items)
  {
    array(std::string(items.size(), ' ')); // its length
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
  void array(T& values)
  {
    using Value = typename T::value_type;
    static_assert(std::is_trivially_copyable_v<Value>);
    std::size_t size = 0;
    NDFRAME_ASSERT(left_.size() >= sizeof size, "the bytes of a mesh end too early");
    std::memcpy(&size, left_.data(), sizeof size);
    left_.remove_prefix(sizeof size);
    NDFRAME_ASSERT(size <= left_.size() / sizeof(Value), "the bytes of a mesh end too early");
    values.resize(size);
    if (size > 0)
      std::memcpy(values.data(), left_.data(), size * sizeof(Value));
    left_.remove_prefix(size * sizeof(Value));
  }
  template <class T>
  void list(std::vector<T>& items)
  {
    std::string length;
    array(length);
    items.resize(length.size());
  }
  bool atEnd() const { return left_.empty(); }

private:
  std::string_view left_;
};

/// Everything in a mesh, in one order for both directions.
template <class Stream, class AnyMesh>
void walk(Stream& stream, AnyMesh& mesh)
{
  stream.array(mesh.points);
  stream.array(mesh.cells);
  stream.list(mesh.sides);
  for (auto& side : mesh.sides) {
    stream.array(side.name);
    stream.array(side.facets);
  }
  stream.list(mesh.notes);
  for (auto& note : mesh.notes)
    stream.array(note);
}

} // namespace

std::string toBytes(const Mesh& mesh)
{
  Writer writer;
  writer.array(std::vector<int>{mesh.dim});
  walk(writer, mesh);
  return writer.take();
}

Mesh meshFromBytes(std::string_view bytes)
{
  Reader reader(bytes);
  std::vector<int> dim;
  reader.array(dim);
  NDFRAME_ASSERT(dim.size() == 1, "these are not the bytes of a mesh");
  Mesh mesh;
  mesh.dim = dim.front();
  walk(reader, mesh);
  NDFRAME_ASSERT(reader.atEnd(), "something follows the bytes of a mesh");
  return mesh;
}

} // namespace ndframe
