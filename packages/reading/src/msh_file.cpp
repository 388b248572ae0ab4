#include "ndframe/reading/msh_file.hpp"

#include <array>
#include <cstdlib>
#include <map>
#include <set>

#include <fmt/format.h>

#include "msh_cursor.hpp"
#include "ndframe/reading/file_error.hpp"
#include "number_index.hpp"

namespace ndframe
{

namespace
{

using Groups = std::vector<int>;

/// A negative tag turns the group's orientation around, which means nothing here.
int groupTag(int tag)
{
  return int(std::abs(std::int64_t(tag)));
}

class MshParser
{
public:
  explicit MshParser(std::string_view text) : in_(text) {}
  MshFile parse();

private:
  using Section = void (MshParser::*)();

  void header();
  void section(const std::string& name);
  void physicalNames();
  void entities();
  Groups entityGroups();
  void nodes41();
  void nodes22();
  void elements41();
  void elements22();
  void element22(int type, std::int64_t number, int numTags);
  MshBlock& block(int type, const Groups& groups);
  const MshElementType& elementType(int type) const;
  void addNode(MshBlock& block, std::int64_t number);
  void finishNodes();

  MshCursor in_;
  bool is41_ = false;
  std::set<std::string> seen_;
  MshFile file_;
  std::vector<std::int64_t> nodeNumbers_;
  NumberIndex nodeIndex_{{}};
  std::array<std::map<int, Groups>, 4> entityGroups_;
  std::map<std::pair<int, Groups>, std::size_t> blockOf_;
};

MshFile MshParser::parse()
{
  header();
  while (!in_.atEnd()) {
    const std::string_view line = in_.line();
    if (line.size() < 2 || line[0] != '$')
      in_.fail(fmt::format("\"{:.20}\" is found where a section should begin", line));
    const std::string name(line.substr(1));
    if (!seen_.insert(name).second && (name == "Nodes" || name == "Elements"))
      in_.fail(fmt::format("a second section ${}", name));
    section(name);
  }
  for (const char* needed : {"Nodes", "Elements"})
    if (seen_.count(needed) == 0)
      throw FileError(fmt::format("the file has no section ${}; it may have been cut off.", needed));
  return std::move(file_);
}

void MshParser::header()
{
  if (in_.atEnd())
    throw FileError("the file is empty.");
  if (in_.line() != "$MeshFormat")
    throw FileError("the file does not begin with $MeshFormat, so it is not a .msh file.");
  const double version = in_.wordReal();
  is41_ = version == 4.1;
  if (!is41_ && version != 2.2)
    throw FileError(fmt::format("MSH format {} is not read; save the mesh as 4.1 or 2.2.", version));
  const std::int64_t encoding = in_.wordInteger();
  if ((encoding != 0 && encoding != 1) || in_.wordInteger() != 8)
    throw FileError("the file type must be 0 (ASCII) or 1 (binary) and the data size 8.");
  if (encoding == 1) {
    in_.endLine();
    in_.setBinary(true);
    if (in_.int32() != 1)
      throw FileError("the file was written on a machine with another byte order.");
  }
  in_.expect("$EndMeshFormat");
}

void MshParser::section(const std::string& name)
{
  static const std::map<std::string, std::pair<Section, Section>> sections{
      {"PhysicalNames", {&MshParser::physicalNames, &MshParser::physicalNames}},
      {"Entities", {nullptr, &MshParser::entities}},
      {"Nodes", {&MshParser::nodes22, &MshParser::nodes41}},
      {"Elements", {&MshParser::elements22, &MshParser::elements41}}};
  if (name == "PartitionedEntities")
    in_.fail("the mesh is partitioned; save it without partitions");
  const auto known = sections.find(name);
  const Section read = known == sections.end() ? nullptr : is41_ ? known->second.second : known->second.first;
  if (read) {
    (this->*read)();
    in_.expect("$End" + name);
  } else if (!in_.skipBehindLine("$End" + name))
    in_.fail(fmt::format("the section ${} has no end; the file may have been cut off", name));
}

void MshParser::physicalNames()
{
  const std::int64_t count = in_.plausible(in_.wordInteger(), 5);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t dim = in_.wordInteger();
    const std::int64_t tag = in_.wordInteger();
    file_.groups.push_back({int(dim), int(tag), in_.quoted()});
  }
}

Groups MshParser::entityGroups()
{
  Groups groups(std::size_t(in_.count(4)));
  for (int& group : groups)
    group = groupTag(in_.int32());
  return groups;
}

void MshParser::entities()
{
  std::array<std::int64_t, 4> counts{};
  for (std::int64_t& count : counts)
    count = in_.count(36); // the tag, three coordinates and a count at least
  for (int dim = 0; dim < 4; ++dim)
    for (std::int64_t i = 0; i < counts[dim]; ++i) {
      const int tag = in_.int32();
      for (int k = 0; k < (dim == 0 ? 3 : 6); ++k)
        in_.real();
      entityGroups_[dim][tag] = entityGroups();
      for (std::int64_t k = dim == 0 ? 0 : in_.count(4); k > 0; --k)
        in_.int32();
    }
}

void MshParser::finishNodes()
{
  nodeIndex_ = NumberIndex(nodeNumbers_);
  nodeNumbers_ = {};
}

void MshParser::nodes22()
{
  // The count stands in a line of its own, in binary files too.
  const std::int64_t count = in_.plausible(in_.wordInteger(), 28);
  if (in_.binary())
    in_.endLine();
  nodeNumbers_.reserve(std::size_t(count));
  file_.coordinates.reserve(3 * std::size_t(count));
  for (std::int64_t i = 0; i < count; ++i) {
    nodeNumbers_.push_back(in_.int32());
    for (int k = 0; k < 3; ++k)
      file_.coordinates.push_back(in_.real());
  }
  finishNodes();
}

void MshParser::nodes41()
{
  const std::int64_t blocks = in_.count(20);
  const std::int64_t total = in_.count(32);
  in_.size();
  in_.size();
  nodeNumbers_.reserve(std::size_t(total));
  file_.coordinates.reserve(3 * std::size_t(total));
  for (std::int64_t b = 0; b < blocks; ++b) {
    const int dim = in_.int32();
    in_.int32();
    const bool parametric = in_.int32() != 0;
    if (dim < 0 || dim > 3)
      in_.fail(fmt::format("an entity of dimension {}", dim));
    const std::int64_t count = in_.count(32);
    for (std::int64_t i = 0; i < count; ++i)
      nodeNumbers_.push_back(in_.size());
    for (std::int64_t i = 0; i < count; ++i) {
      for (int k = 0; k < 3; ++k)
        file_.coordinates.push_back(in_.real());
      for (int k = 0; parametric && k < dim; ++k)
        in_.real();
    }
  }
  if (std::int64_t(nodeNumbers_.size()) != total)
    in_.fail(fmt::format("{} nodes are announced, {} are given", total, nodeNumbers_.size()));
  finishNodes();
}

const MshElementType& MshParser::elementType(int type) const
{
  const MshElementType* found = findMshElementType(type);
  if (!found)
    in_.fail(fmt::format("element type {} is not known", type));
  return *found;
}

MshBlock& MshParser::block(int type, const Groups& groups)
{
  const auto [place, isNew] = blockOf_.insert({{type, groups}, file_.blocks.size()});
  if (isNew)
    file_.blocks.push_back({type, groups, {}, {}});
  return file_.blocks[place->second];
}

void MshParser::addNode(MshBlock& target, std::int64_t number)
{
  const int node = nodeIndex_.find(number);
  if (node < 0)
    in_.fail(fmt::format("an element uses node {}, which does not exist", number));
  target.nodes.push_back(node);
}

void MshParser::elements41()
{
  const std::int64_t blocks = in_.count(20);
  const std::int64_t total = in_.count(16);
  in_.size();
  in_.size();
  std::int64_t given = 0;
  for (std::int64_t b = 0; b < blocks; ++b) {
    const int dim = in_.int32();
    const int entity = in_.int32();
    const int type = in_.int32();
    const MshElementType& properties = elementType(type);
    if (properties.dim != dim)
      in_.fail(fmt::format("a {} on an entity of dimension {}", properties.name, dim));
    const std::int64_t count = in_.count(8 * std::size_t(1 + properties.nodes));
    if (count == 0)
      continue;
    const auto groups = entityGroups_[dim].find(entity);
    MshBlock& target = block(type, groups == entityGroups_[dim].end() ? Groups{} : groups->second);
    for (std::int64_t i = 0; i < count; ++i) {
      target.numbers.push_back(in_.size());
      for (int k = 0; k < properties.nodes; ++k)
        addNode(target, in_.size());
    }
    given += count;
  }
  if (given != total)
    in_.fail(fmt::format("{} elements are announced, {} are given", total, given));
}

void MshParser::elements22()
{
  const std::int64_t count = in_.plausible(in_.wordInteger(), 4);
  if (in_.binary())
    in_.endLine();
  for (std::int64_t done = 0; done < count;) {
    // Binary: runs of elements with a common header. ASCII: every element has its own.
    const std::int64_t number = in_.binary() ? 0 : in_.int32();
    const int type = in_.int32();
    const std::int64_t run = in_.binary() ? in_.int32() : 1;
    if (run < 1 || run > count - done)
      in_.fail(fmt::format("{} elements follow where {} are left", run, count - done));
    const int numTags = int(in_.plausible(in_.int32(), 4));
    for (std::int64_t i = 0; i < run; ++i)
      element22(type, in_.binary() ? in_.int32() : number, numTags);
    done += run;
  }
}

void MshParser::element22(int type, std::int64_t number, int numTags)
{
  const MshElementType& properties = elementType(type);
  int physical = 0;
  for (int t = 0; t < numTags; ++t) {
    const int tag = in_.int32();
    physical = t == 0 ? groupTag(tag) : physical;
  }
  MshBlock& target = block(type, physical == 0 ? Groups{} : Groups{physical});
  target.numbers.push_back(number);
  for (int k = 0; k < properties.nodes; ++k)
    addNode(target, in_.int32());
}

} // namespace

MshFile parseMsh(std::string_view text)
{
  return MshParser(text).parse();
}

} // namespace ndframe
