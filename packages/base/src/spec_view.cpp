#include "spec_view.hpp"

#include <algorithm>

namespace ndframe
{

namespace
{

void collect(const PlacedList& place, std::vector<PlacedList>& all)
{
  all.push_back(place);
  for (const auto& list : place.spec->lists)
    collect({joinPath(place.path, list.name), &list, nullptr}, all);
  if (place.spec->each)
    collect({joinPath(place.path, "*"), place.spec->each.get(), nullptr}, all);
  if (!place.spec->choices)
    return;
  for (const auto& component : place.spec->choices->components)
    for (const auto& list : component.lists)
      collect({joinPath(place.path, list.name), &list, &component}, all);
}

} // namespace

const ParamSpec* SpecView::findParam(const std::string& name) const
{
  const auto found = std::find_if(params.begin(), params.end(), [&](const ParamSpec& p) { return p.name == name; });
  return found == params.end() ? nullptr : &*found;
}

const ListSpec* SpecView::findList(const std::string& name) const
{
  const auto found = std::find_if(lists.begin(), lists.end(), [&](const ListSpec* l) { return l->name == name; });
  return found == lists.end() ? nullptr : *found;
}

std::vector<std::string> SpecView::paramNames() const
{
  std::vector<std::string> names;
  for (const auto& param : params)
    names.push_back(param.name);
  return names;
}

std::vector<std::string> SpecView::listNames() const
{
  std::vector<std::string> names;
  for (const auto* list : lists)
    names.push_back(list->name);
  return names;
}

SpecView viewOf(const ListSpec& spec, const ComponentInfo* component)
{
  SpecView view;
  const auto add = [&](const std::vector<ParamSpec>& params, const std::vector<ListSpec>& lists) {
    view.params.insert(view.params.end(), params.begin(), params.end());
    for (const auto& list : lists)
      view.lists.push_back(&list);
  };
  if (spec.choices)
    view.params.push_back(typeParam(*spec.choices));
  add(spec.params, spec.lists);
  if (component != nullptr)
    add(component->params, component->lists);
  return view;
}

ParamSpec typeParam(const Choices& choices)
{
  const Range range = oneOf(componentNames(choices));
  const std::string doc = "Which component; it brings its own parameters.";
  if (choices.defaultType.empty())
    return ParamSpec::required("Type", Kind::String, range, doc);
  return {"Type", choices.defaultType, range, doc};
}

const ComponentInfo* findComponent(const ListSpec& spec, const std::string& name)
{
  if (!spec.choices)
    return nullptr;
  const auto& all = spec.choices->components;
  const auto found = std::find_if(all.begin(), all.end(), [&](const ComponentInfo& c) { return c.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> componentNames(const Choices& choices)
{
  std::vector<std::string> names;
  for (const auto& component : choices.components)
    names.push_back(component.name);
  return names;
}

std::vector<PlacedList> allLists(const ListSpec& root)
{
  std::vector<PlacedList> all;
  collect({{}, &root, nullptr}, all);
  return all;
}

std::string joinPath(const std::string& parent, const std::string& name)
{
  return parent.empty() ? name : parent + "/" + name;
}

} // namespace ndframe
