#include "ndframe/base/params.hpp"

#include <algorithm>
#include <filesystem>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <fmt/format.h>

#include "ndframe/base/expression.hpp"
#include "params_node.hpp"
#include "text.hpp"
#include "value_text.hpp"

namespace ndframe
{

namespace
{

const ParamsEntry* findEntry(const Params::Node& node, const std::string& key)
{
  const auto found =
      std::find_if(node.entries.begin(), node.entries.end(), [&](const ParamsEntry& e) { return e.name == key; });
  return found == node.entries.end() ? nullptr : &*found;
}

const ParamsEntry& entryOf(const Params::Node& node, const std::string& key)
{
  const auto* entry = findEntry(node, key);
  NDFRAME_ASSERT(entry != nullptr, fmt::format("\"{}\" has no parameter {}", node.path, inQuotes(key)));
  return *entry;
}

std::shared_ptr<const Params::Node> findList(const Params::Node& node, const std::string& name)
{
  const auto found =
      std::find_if(node.lists.begin(), node.lists.end(), [&](const auto& list) { return list->name == name; });
  return found == node.lists.end() ? nullptr : *found;
}

/// Teuchos has its own arrays, and no others in its readers and validators.
struct TeuchosSetter
{
  Teuchos::ParameterList& list;
  const std::string& name;

  template <class T>
  void operator()(const T& value) const
  {
    list.set(name, value);
  }
  template <class T>
  void operator()(const std::vector<T>& value) const
  {
    list.set(name, Teuchos::Array<T>(value));
  }
};

} // namespace

Teuchos::ParameterList toTeuchos(const Params::Node& node)
{
  Teuchos::ParameterList list(node.name);
  for (const auto& entry : node.entries)
    std::visit(TeuchosSetter{list, entry.name}, entry.value);
  for (const auto& sublist : node.lists)
    list.sublist(sublist->name).setParameters(toTeuchos(*sublist));
  return list;
}

const std::string& Params::name() const
{
  return node_->name;
}

std::string Params::path() const
{
  return node_->path;
}

bool Params::has(const std::string& key) const
{
  return findEntry(*node_, key) != nullptr;
}

bool Params::isGiven(const std::string& key) const
{
  const auto* entry = findEntry(*node_, key);
  return entry != nullptr && entry->isGiven;
}

template <class T>
T Params::get(const std::string& key) const
{
  const auto& entry = entryOf(*node_, key);
  const auto* value = std::get_if<T>(&entry.value);
  NDFRAME_ASSERT(value != nullptr, fmt::format("\"{}\": {} is of kind {}, another is asked for", node_->path,
                                               inQuotes(key), kindName(entry.kind)));
  return *value;
}

template bool Params::get<bool>(const std::string&) const;
template int Params::get<int>(const std::string&) const;
template double Params::get<double>(const std::string&) const;
template std::string Params::get<std::string>(const std::string&) const;
template std::vector<int> Params::get<std::vector<int>>(const std::string&) const;
template std::vector<double> Params::get<std::vector<double>>(const std::string&) const;
template std::vector<std::string> Params::get<std::vector<std::string>>(const std::string&) const;

Expression Params::expression(const std::string& key) const
{
  const auto& entry = entryOf(*node_, key);
  NDFRAME_ASSERT(entry.kind == Kind::Expression,
                 fmt::format("\"{}\": {} is not an expression", node_->path, inQuotes(key)));
  return Expression(std::get<std::string>(entry.value));
}

std::string Params::file(const std::string& key) const
{
  const std::filesystem::path name = get<std::string>(key);
  const auto& entry = entryOf(*node_, key);
  return (std::filesystem::path(entry.file).parent_path() / name).string();
}

bool Params::hasSub(const std::string& list) const
{
  return findList(*node_, list) != nullptr;
}

Params Params::sub(const std::string& list) const
{
  auto found = findList(*node_, list);
  NDFRAME_ASSERT(found != nullptr, fmt::format("\"{}\" has no list {}", node_->path, inQuotes(list)));
  return Params(std::move(found));
}

std::vector<Params> Params::subs() const
{
  std::vector<Params> all;
  for (const auto& list : node_->lists)
    all.emplace_back(list);
  return all;
}

Diagnostic Params::mistake(const std::string& key, const std::string& message) const
{
  const auto* entry = findEntry(*node_, key);
  if (entry == nullptr || !entry->isGiven)
    return {node_->file, node_->line, node_->path, message};
  return {entry->file, entry->line, node_->path, message};
}

Teuchos::ParameterList Params::teuchos() const
{
  return toTeuchos(*node_);
}

} // namespace ndframe
