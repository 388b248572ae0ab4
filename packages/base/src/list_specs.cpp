#include "ndframe/base/list_specs.hpp"

#include <utility>

namespace ndframe
{

ListSpec makeList(std::string name, std::string doc)
{
  ListSpec list;
  list.name = std::move(name);
  list.doc = std::move(doc);
  return list;
}

ListSpec makeChoice(std::string name, std::string doc, const Choices& choices)
{
  ListSpec list = makeList(std::move(name), std::move(doc));
  list.choices = choices;
  return list;
}

} // namespace ndframe
