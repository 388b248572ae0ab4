#include "exodus_input.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>

#include <exodusII.h>
#include <fmt/format.h>

#include "ndframe/reading/file_error.hpp"

namespace ndframe
{

namespace
{

constexpr int maxNameLength = 255;

} // namespace

ExodusInput::Handle::Handle(const std::string& path)
{
  ex_opts(0); // no messages on the terminal
  int wordSize = sizeof(double);
  int fileWordSize = 0;
  float version = 0;
  id_ = ex_open(path.c_str(), EX_READ, &wordSize, &fileWordSize, &version);
  if (id_ < 0)
    throw FileError("the file is damaged or not an Exodus file.");
  ex_set_max_name_length(id_, maxNameLength);
  ex_set_int64_status(id_, 0); // all integers come as int, whatever the file's own attribute says
}

ExodusInput::Handle::~Handle()
{
  ex_close(id_);
}

ExodusInput::ExodusInput(const std::string& path)
    : file_(path), fileSize_(std::int64_t(std::filesystem::file_size(path)))
{
  ex_init_params sizes{};
  require(ex_get_init_ext(file_, &sizes), "sizes");
  dim_ = plausible(sizes.num_dim, "dimensions");
  numNodes_ = plausible(sizes.num_nodes, "nodes");
  numElements_ = plausible(sizes.num_elem, "elements");
  numBlocks_ = plausible(sizes.num_elem_blk, "element blocks");
  numSideSets_ = plausible(sizes.num_side_sets, "side sets");
}

void ExodusInput::require(int status, const char* what) const
{
  if (status < 0)
    throw FileError(fmt::format("the {} cannot be read; the file is damaged.", what));
}

int ExodusInput::plausible(std::int64_t count, const char* what) const
{
  if (count < 0 || count > fileSize_)
    throw FileError(fmt::format("the file says that it has {} {}, more than it can hold; it is damaged.", count, what));
  return int(count);
}

std::vector<int> ExodusInput::ids(int kind, int count) const
{
  std::vector<int> found(count);
  if (count > 0)
    require(ex_get_ids(file_, ex_entity_type(kind), found.data()), "numbers of blocks or sets");
  return found;
}

std::string ExodusInput::name(int kind, int id, const char* unnamed) const
{
  std::array<char, maxNameLength + 1> text{};
  require(ex_get_name(file_, ex_entity_type(kind), id, text.data()), "names of blocks or sets");
  text.back() = '\0';
  const std::string found = text.data();
  return found.empty() ? fmt::format("{}_{}", unnamed, id) : found;
}

std::vector<double> ExodusInput::coordinates() const
{
  std::array<std::vector<double>, 3> x;
  for (auto& component : x)
    component.resize(numNodes_, 0.0);
  // The partial readers check the shapes in the file against what is asked for, the others overrun the arrays.
  require(ex_get_partial_coord(file_, 1, numNodes_, x[0].data(), x[1].data(), x[2].data()), "coordinates");
  std::vector<double> points;
  points.reserve(std::size_t(3) * numNodes_);
  for (int node = 0; node < numNodes_; ++node)
    for (const auto& component : x) {
      if (!std::isfinite(component[node]))
        throw FileError(fmt::format("node {} has a coordinate that is not finite.", node + 1));
      points.push_back(component[node]);
    }
  return points;
}

std::vector<ExodusBlock> ExodusInput::blocks() const
{
  std::vector<ExodusBlock> list;
  std::int64_t first = 0;
  for (const int id : ids(EX_ELEM_BLOCK, numBlocks_)) {
    ex_block block{};
    block.id = id;
    block.type = EX_ELEM_BLOCK;
    require(ex_get_block_param(file_, &block), "element blocks");
    block.topology[MAX_STR_LENGTH] = '\0';
    std::string type = block.topology;
    std::transform(type.begin(), type.end(), type.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    list.push_back({id, name(EX_ELEM_BLOCK, id, "block"), type, plausible(block.num_entry, "elements in a block"),
                    plausible(block.num_nodes_per_entry, "nodes in an element"), int(first)});
    plausible(block.num_entry * block.num_nodes_per_entry, "nodes in a block");
    first += block.num_entry;
  }
  if (first != numElements_)
    throw FileError(
        fmt::format("the blocks have {} elements, but the file says {}; it is damaged.", first, numElements_));
  return list;
}

std::vector<int> ExodusInput::nodes(const ExodusBlock& block) const
{
  std::vector<int> numbers(std::size_t(block.numElements) * block.nodesPerElement);
  if (!numbers.empty())
    require(ex_get_partial_conn(file_, EX_ELEM_BLOCK, block.id, 1, block.numElements, numbers.data(), nullptr, nullptr),
            "elements");
  for (int& number : numbers) {
    if (number < 1 || number > numNodes_)
      throw FileError(fmt::format("an element uses node {}, but there are {} nodes.", number, numNodes_));
    --number;
  }
  return numbers;
}

std::vector<int> ExodusInput::idMap(int kind, int count) const
{
  std::vector<int> numbers(count);
  if (count > 0)
    require(ex_get_partial_id_map(file_, ex_entity_type(kind), 1, count, numbers.data()),
            "numbers of nodes and elements");
  return numbers;
}

std::vector<int> ExodusInput::nodeIds() const
{
  return idMap(EX_NODE_MAP, numNodes_);
}

std::vector<int> ExodusInput::elementIds() const
{
  return idMap(EX_ELEM_MAP, numElements_);
}

std::vector<ExodusSideSet> ExodusInput::sideSets() const
{
  std::vector<ExodusSideSet> list;
  for (const int id : ids(EX_SIDE_SET, numSideSets_)) {
    int count = 0;
    int factors = 0;
    require(ex_get_set_param(file_, EX_SIDE_SET, id, &count, &factors), "side sets");
    ExodusSideSet set{name(EX_SIDE_SET, id, "sideset"), std::vector<int>(plausible(count, "sides in a set")), {}};
    set.sides.resize(set.elements.size());
    if (count > 0)
      require(ex_get_n_side_set(file_, id, 1, count, set.elements.data(), set.sides.data()), "side sets");
    list.push_back(std::move(set));
  }
  return list;
}

} // namespace ndframe
