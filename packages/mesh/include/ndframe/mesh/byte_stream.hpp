#pragma once

#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

/// Numbers, arrays of numbers and texts as bytes for another process of this machine's kind.
class ByteWriter
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
  template <class T>
  void arrays(const std::vector<T>& all)
  {
    length(all);
    for (const T& values : all)
      array(values);
  }
  std::string take() { return std::move(bytes_); }

private:
  std::string bytes_;
};

/// Reads them in the same order, by functions of the same names. Bytes that end too early, or too late
/// (requireEnd), are a bug (InternalError).
class ByteReader
{
public:
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}

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
    using Entry = typename T::value_type;
    static_assert(std::is_trivially_copyable_v<Entry>);
    std::size_t size = 0;
    number(size);
    requireLeft(size, sizeof(Entry));
    values.resize(size);
    if (size > 0)
      std::memcpy(values.data(), left_.data(), size * sizeof(Entry));
    left_.remove_prefix(size * sizeof(Entry));
  }
  template <class T>
  void length(std::vector<T>& items)
  {
    std::size_t size = 0;
    number(size);
    requireLeft(size, sizeof size); // each item begins with its own length
    items.resize(size);
  }
  template <class T>
  void arrays(std::vector<T>& all)
  {
    length(all);
    for (T& values : all)
      array(values);
  }
  void requireEnd() const { NDFRAME_ASSERT(left_.empty(), "something follows the bytes that are wanted"); }

private:
  void requireLeft(std::size_t count, std::size_t size) const
  {
    NDFRAME_ASSERT(count <= left_.size() / size, "the bytes end too early");
  }

  std::string_view left_;
};

} // namespace ndframe
