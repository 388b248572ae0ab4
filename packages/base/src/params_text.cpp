#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tinyxml2.h>

#include "ndframe/base/params.hpp"
#include "params_node.hpp"
#include "value_text.hpp"

namespace ndframe
{

namespace
{

using Json = nlohmann::ordered_json;

/// A printer with the project's indentation.
class Printer : public tinyxml2::XMLPrinter
{
protected:
  void PrintSpace(int depth) override
  {
    for (int i = 0; i < depth; ++i)
      Write("  ");
  }
};

void print(const Params::Node& node, Printer& printer)
{
  printer.OpenElement("ParameterList");
  printer.PushAttribute("name", node.name.c_str());
  for (const auto& entry : node.entries) {
    printer.OpenElement("Parameter");
    printer.PushAttribute("name", entry.name.c_str());
    printer.PushAttribute("type", kindName(kindOf(entry.value)).c_str());
    printer.PushAttribute("value", valueText(entry.value).c_str());
    printer.CloseElement();
  }
  for (const auto& list : node.lists)
    print(*list, printer);
  printer.CloseElement();
}

Json json(const Params::Node& node)
{
  Json object = Json::object();
  for (const auto& entry : node.entries)
    object[entry.name] = std::visit([](const auto& value) { return Json(value); }, entry.value);
  for (const auto& list : node.lists)
    object[list->name] = json(*list);
  return object;
}

} // namespace

std::string toXml(const Params& params)
{
  Printer printer;
  print(params.node(), printer);
  return printer.CStr();
}

std::string toJson(const Params& params)
{
  return json(params.node()).dump(2);
}

} // namespace ndframe
