#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/param_spec.hpp"
#include "ndframe/base/params.hpp"

namespace ndframe
{

/// The validated list of a choice with these entries, as `--set` has them ("Tolerance=1e-8"), and all defaults: for
/// those who have no deck. name: of the list. Throws InputError.
Params validatedChoice(const std::string& name, const Choices& choices, const std::vector<std::string>& settings);

/// The components of one kind: name, documentation, valid parameters and builder stand together in one entry.
///
/// Filled by explicit registerX(registry) calls (a static initialiser would be dropped from a static archive).
template <class Product>
class Registry
{
public:
  using Builder = std::function<std::unique_ptr<Product>(const Params&)>; ///< from the validated list that chose it

  /// `kind` is what messages call the components, e.g. "relaxation".
  explicit Registry(std::string kind, std::string defaultType = {}) : kind_(std::move(kind))
  {
    choices_.defaultType = std::move(defaultType);
  }

  /// Another component of the same name is a bug (InternalError). lists: its sublists.
  void add(std::string name, std::string doc, std::vector<ParamSpec> params, Builder builder,
           std::vector<ListSpec> lists = {})
  {
    for (const auto& component : choices_.components)
      NDFRAME_ASSERT(component.name != name, kind_ + " \"" + name + "\" is registered twice");
    choices_.components.push_back({std::move(name), std::move(doc), std::move(params), std::move(lists)});
    builders_.push_back(std::move(builder));
  }

  /// Builds what the validated list's "Type" names.
  std::unique_ptr<Product> build(const Params& params) const
  {
    const auto type = params.get<std::string>("Type");
    for (std::size_t i = 0; i < builders_.size(); ++i)
      if (choices_.components[i].name == type)
        return builders_[i](params);
    throw InternalError(kind_ + " \"" + type + "\" passed validation but is not registered");
  }

  /// The list that a deck with these entries would have, e.g. {"Type=Krylov", "Tolerance=1e-8"}.
  Params validated(const std::vector<std::string>& settings) const
  {
    return validatedChoice(kind_, choices_, settings);
  }

  /// Builds what such a list's "Type" names.
  std::unique_ptr<Product> build(const std::vector<std::string>& settings) const { return build(validated(settings)); }

  const std::string& kind() const { return kind_; }   ///< as given to the constructor
  const Choices& choices() const { return choices_; } ///< for the specification of the deck (makeChoice)

private:
  std::string kind_;
  Choices choices_;
  std::vector<Builder> builders_;
};

} // namespace ndframe
