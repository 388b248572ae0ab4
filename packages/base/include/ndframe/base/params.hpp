#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ndframe/base/deck.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

class Expression;

/// A validated list: every key is known, typed, in range and present (given or defaulted), and remembers its line.
class Params
{
public:
  struct Node; ///< the tree; built by validate()

  explicit Params(std::shared_ptr<const Node> node) : node_(std::move(node)) {}

  const std::string& name() const; ///< of the list itself, without its path
  std::string path() const;        ///< "Bodies/punch/Material"; empty for the deck itself

  /// True when the key was given or has a default.
  bool has(const std::string& key) const;
  /// True when the user wrote the key (deck or `--set`).
  bool isGiven(const std::string& key) const;
  /// T: bool, int, double, std::string, std::vector<int>, std::vector<double>, std::vector<std::string>.
  /// Asking for a key that the spec does not have, or for another type, is a bug (InternalError).
  template <class T>
  T get(const std::string& key) const;
  /// A file named in the deck: relative names count from the deck's folder, those of `--set` from the working
  /// directory.
  std::string file(const std::string& key) const;
  /// The compiled expression of a key of Kind::Expression.
  Expression expression(const std::string& key) const;

  bool hasSub(const std::string& list) const; ///< true when the list was given or is filled with defaults
  Params sub(const std::string& list) const;  ///< asking for one that is not there is a bug (InternalError)
  /// All sublists, in deck order (for user-named ones).
  std::vector<Params> subs() const;

  /// A mistake that shows only later (a side that does not exist, say), with the place of `key` (or of the list: empty
  /// key).
  Diagnostic mistake(const std::string& key, const std::string& message) const;

  /// The whole list, defaults included, as Teuchos sees it; for libraries and for echoing the effective deck.
  Teuchos::ParameterList teuchos() const;

  const Node& node() const { return *node_; } ///< for this package's writers

private:
  std::shared_ptr<const Node> node_;
};

/// Checks a deck against its specification and fills in the defaults. All mistakes are collected: unknown names (with
/// the nearest valid one), wrong types, values out of range or not finite, missing required keys and lists, expressions
/// that do not parse, unknown components. The result may be used only when nothing was added to `diagnostics`.
Params validate(const DeckList& deck, const ListSpec& spec, Diagnostics& diagnostics);

/// The effective deck as Teuchos XML, which reads back to the same Params.
std::string toXml(const Params& params);

/// The effective deck as a JSON object (lists -> objects, arrays -> arrays).
std::string toJson(const Params& params);

} // namespace ndframe
