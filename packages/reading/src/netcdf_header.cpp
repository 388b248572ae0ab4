#include "ndframe/reading/netcdf_header.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "ndframe/reading/file_error.hpp"

namespace ndframe
{

namespace
{

constexpr std::uint64_t maxNameLength = 1024;
constexpr std::uint64_t maxDimensions = 1024; // of one variable (NC_MAX_VAR_DIMS)

[[noreturn]] void failShort()
{
  throw FileError("the file is shorter than its header says; it may have been cut off.");
}

/// The dimension of the variables that the Exodus library copies into arrays of that length without looking at their
/// own; empty for all others.
std::string exodusDimension(const std::string& variable)
{
  static const std::map<std::string, std::string> dimensions{{"eb_prop1", "num_el_blk"},
                                                             {"eb_status", "num_el_blk"},
                                                             {"ss_prop1", "num_side_sets"},
                                                             {"ss_status", "num_side_sets"}};
  const auto found = dimensions.find(variable);
  return found == dimensions.end() ? std::string() : found->second;
}

/// Walks through a classic header ("The NetCDF Classic Format Specification").
class ClassicHeader
{
public:
  ClassicHeader(std::ifstream& in, std::uint64_t fileSize, int version)
      : in_(in), fileSize_(fileSize), version_(version)
  {}

  /// Throws FileError unless the header is well formed and all its data lie within the file.
  void check();

private:
  struct Dimension
  {
    std::string name;
    std::uint64_t length;
  };
  struct Variable
  {
    std::uint64_t begin;
    std::uint64_t bytes;
    bool isRecord;
  };

  [[noreturn]] static void fail() { throw FileError("the netCDF header is damaged."); }
  std::uint64_t big(int bytes);
  std::uint64_t count() { return big(version_ == 5 ? 8 : 4); }
  std::uint64_t listLength(std::uint64_t tag);
  void skip(std::uint64_t bytes);
  std::string name();
  void skipAttributes();
  std::uint64_t typeSize();
  Variable variable(const std::vector<Dimension>& dimensions);
  static std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

  std::ifstream& in_;
  std::uint64_t fileSize_;
  int version_;
};

std::uint64_t ClassicHeader::big(int bytes)
{
  std::uint64_t value = 0;
  for (int i = 0; i < bytes; ++i) {
    const int byte = in_.get();
    if (byte < 0)
      fail();
    value = value << 8 | std::uint64_t(byte);
  }
  return value;
}

std::uint64_t ClassicHeader::listLength(std::uint64_t tag)
{
  const std::uint64_t found = big(4);
  const std::uint64_t length = count();
  if (length > fileSize_ / 4 || (found != tag && (found != 0 || length != 0)))
    fail();
  return length;
}

void ClassicHeader::skip(std::uint64_t bytes)
{
  if (bytes > fileSize_)
    fail();
  in_.seekg(std::streamoff(bytes), std::ios::cur);
}

std::string ClassicHeader::name()
{
  const std::uint64_t length = count();
  if (length > maxNameLength)
    fail();
  std::string text(length, ' ');
  in_.read(text.data(), std::streamsize(length));
  skip(padded(length) - length);
  return text;
}

std::uint64_t ClassicHeader::typeSize()
{
  // byte, char, short, int, float, double, then those of CDF-5: ubyte, ushort, uint, int64, uint64
  static constexpr std::uint64_t sizes[] = {1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
  const std::uint64_t type = big(4);
  if (type < 1 || type > (version_ == 5 ? 11 : 6))
    fail();
  return sizes[type - 1];
}

void ClassicHeader::skipAttributes()
{
  for (std::uint64_t n = listLength(0x0C); n > 0; --n) {
    name();
    const std::uint64_t size = typeSize();
    const std::uint64_t values = count();
    if (values > fileSize_)
      fail();
    skip(padded(size * values));
  }
}

ClassicHeader::Variable ClassicHeader::variable(const std::vector<Dimension>& dimensions)
{
  const std::string dimensionNeeded = exodusDimension(name());
  const std::uint64_t rank = count();
  if (rank > maxDimensions)
    fail();
  bool isRecord = false;
  std::uint64_t values = 1;
  for (std::uint64_t i = 0; i < rank; ++i) {
    const std::uint64_t id = count();
    if (id >= dimensions.size() || (!dimensionNeeded.empty() && dimensions[id].name != dimensionNeeded))
      fail();
    const std::uint64_t length = dimensions[id].length;
    isRecord = isRecord || (i == 0 && length == 0);
    values *= i == 0 && isRecord ? 1 : length;
    if (length > fileSize_ || values > fileSize_) // every value takes a byte at least
      failShort();
  }
  skipAttributes();
  const std::uint64_t bytes = values * typeSize();
  count(); // the size as written, which large variables overflow
  const std::uint64_t begin = big(version_ == 1 ? 4 : 8);
  if (begin > fileSize_)
    failShort();
  return {begin, bytes, isRecord};
}

void ClassicHeader::check()
{
  const std::uint64_t records = count();
  const bool streaming = records == (version_ == 5 ? ~std::uint64_t(0) : 0xFFFFFFFF);
  std::vector<Dimension> dimensions(listLength(0x0A));
  for (Dimension& dimension : dimensions) {
    dimension.name = name();
    dimension.length = count();
  }
  skipAttributes();
  std::vector<Variable> variables(listLength(0x0B));
  std::uint64_t recordBytes = 0;
  int recordVariables = 0;
  for (Variable& v : variables) {
    v = variable(dimensions);
    recordBytes += v.isRecord ? padded(v.bytes) : 0;
    recordVariables += v.isRecord ? 1 : 0;
  }
  for (const Variable& v : variables) {
    // A single record variable is not padded.
    const std::uint64_t stride = recordVariables == 1 ? v.bytes : recordBytes;
    const std::uint64_t previous = v.isRecord && records > 0 && !streaming ? records - 1 : 0;
    if (stride > 0 && previous > fileSize_ / stride)
      fail();
    const bool empty = v.isRecord && (records == 0 || streaming);
    if (!empty && v.begin + v.bytes + previous * stride > fileSize_)
      failShort();
  }
}

/// The superblock tells where the file ends (HDF5 file format specification, II.A); 8-byte little-endian addresses.
void checkHdf5Length(const std::array<char, 52>& head, std::uint64_t fileSize)
{
  static constexpr std::array<std::size_t, 4> places{40, 44, 28, 28}; // by the superblock's version
  const auto version = std::uint8_t(head[8]);
  if (version >= places.size())
    throw FileError("the HDF5 header is damaged.");
  const std::size_t place = places[version];
  std::uint64_t end = 0;
  for (std::size_t i = 8; i-- > 0;)
    end = end << 8 | std::uint8_t(head[place + i]);
  if (end > fileSize)
    failShort();
}

} // namespace

void checkNetcdfHeader(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw FileError("the file cannot be read; relative paths start from the deck's folder.");
  const std::uint64_t fileSize = std::filesystem::file_size(path);
  std::array<char, 52> head{};
  in.read(head.data(), head.size());
  const int version = static_cast<unsigned char>(head[3]);
  if (std::memcmp(head.data(), "\x89HDF\r\n\x1a\n", 8) == 0)
    return checkHdf5Length(head, fileSize);
  if (std::memcmp(head.data(), "CDF", 3) != 0 || (version != 1 && version != 2 && version != 5))
    throw FileError("the file is not netCDF, so it is not an Exodus file.");
  in.clear();
  in.seekg(4);
  ClassicHeader(in, fileSize, version).check();
}

} // namespace ndframe
