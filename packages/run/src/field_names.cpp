#include "field_names.hpp"

#include <fmt/format.h>

namespace ndframe
{

void checkFieldNames(const Model& model, const Params& deck, Diagnostics& diagnostics)
{
  constexpr std::size_t longest = 256; // of netCDF
  const auto check = [&](const Params& list, const std::string& name) {
    if (name.size() > longest)
      diagnostics.add(list.mistake("", fmt::format("its name makes names of {} characters in the Exodus file, which "
                                                   "allows {}; shorten it, or set Output/Exodus = false.",
                                                   name.size(), longest)));
  };
  for (const auto& body : model.bodies) {
    std::string side;
    for (const auto& candidate : body.mesh.sides)
      side = candidate.name.size() > side.size() ? candidate.name : side;
    check(deck.sub("Bodies").sub(body.name), body.name + ":" + side);
  }
  for (const auto& interface : model.interfaces)
    check(deck.sub("Interfaces").sub(interface.name), interface.name + ":dirichlet");
}

} // namespace ndframe
