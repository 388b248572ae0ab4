#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace Teuchos
{
class ParameterList;
}

namespace ndframe
{

/// A value as it stands in a deck.
using Value =
    std::variant<bool, int, double, std::string, std::vector<int>, std::vector<double>, std::vector<std::string>>;

/// What a parameter accepts. An int is accepted where a double is wanted; an Expression accepts a number
/// or a text in x, y, z and is kept as text.
enum class Kind
{
  Bool,
  Int,
  Double,
  String,
  Expression,
  Ints,
  Doubles,
  Strings
};

/// The values a parameter may take, with the text that help and messages show ("(0, 2)", ">= 1", "Right | Crossed").
struct Range
{
  std::string text;                           ///< empty: no restriction beyond the kind (doubles are always finite)
  std::function<bool(const Value&)> contains; ///< empty: everything
};

/// Ranges with their text: (low, high), [low, high], > low, >= low, and one of some names.
Range inOpenRange(double low, double high);
Range inClosedRange(double low, double high); ///< [low, high]
Range above(double low);                      ///< > low
Range atLeast(double low);                    ///< >= low
Range oneOf(std::vector<std::string> names);  ///< names of a choice

/// One key of a list: name, kind, default, range and documentation stand here and nowhere else.
struct ParamSpec
{
  /// A parameter with a default; its kind follows from the default's type.
  ParamSpec(std::string name, Value defaultValue, Range range, std::string doc);
  ParamSpec(std::string name, Value defaultValue, std::string doc); ///< of any value of its kind

  static ParamSpec required(std::string name, Kind kind, Range range, std::string doc); ///< must be given: no default
  static ParamSpec required(std::string name, Kind kind, std::string doc);              ///< of any value of its kind
  /// May be absent; Params::has() tells.
  static ParamSpec optional(std::string name, Kind kind, Range range, std::string doc);
  static ParamSpec optional(std::string name, Kind kind, std::string doc); ///< of any value of its kind
  /// An expression in x, y, z with a default such as "0".
  static ParamSpec expression(std::string name, std::string defaultText, std::string doc);

  std::string name;                  ///< the key as decks have it
  Kind kind;                         ///< type of its values
  bool isRequired = false;           ///< absence is a mistake
  std::optional<Value> defaultValue; ///< none: required or optional
  Range range;                       ///< of the values
  std::string doc;                   ///< for help and reference

private:
  ParamSpec(std::string name, Kind kind, bool isRequired, Range range, std::string doc);
};

struct ListSpec;

/// A component as help and validation see it.
struct ComponentInfo
{
  std::string name;              ///< the value of "Type"
  std::string doc;               ///< for help and reference
  std::vector<ParamSpec> params; ///< its keys, beside those of the list
  std::vector<ListSpec> lists;   ///< its sublists, beside those of the list
};

/// The components that the key "Type" of a list chooses from.
struct Choices
{
  std::vector<ComponentInfo> components; ///< in the order of registration
  std::string defaultType;               ///< empty: "Type" is required
};

/// One list of the deck.
struct ListSpec
{
  std::string name;                        ///< in the deck; what help calls user-named lists
  std::string doc;                         ///< for help and reference
  bool isRequired = false;                 ///< absent lists that are not required are filled with their defaults ...
  bool onlyIfGiven = false;                ///< ... unless this is set: then absence means "not wanted"
  std::vector<std::string> requiredUnless; ///< a required list may be absent where one of these lists is given
  std::vector<ParamSpec> params;           ///< keys of this list
  std::vector<ListSpec> lists;             ///< sublists with fixed names
  std::shared_ptr<ListSpec> each;          ///< user-named sublists, all of this shape
  std::optional<ParamSpec> eachParam;      ///< user-named keys, all of this kind
  std::optional<Choices> choices;          ///< "Type" picks a component whose keys belong to this list too
  /// A list handed on to a library: any keys, checked by this function (returns one message per mistake).
  std::function<std::vector<std::string>(const Teuchos::ParameterList&)> passThrough;
};

[[noreturn]] void failUnknownName(const std::string& name); ///< a bug: no enumeration has this name

/// Names with the values they stand for: gives the range of a parameter and its conversion, so that names are written
/// once.
template <class T>
class Names
{
public:
  Names(std::initializer_list<std::pair<std::string, T>> entries) : entries_(entries) {} ///< each name and value once
  /// One of the names, as a parameter's range.
  Range range() const
  {
    std::vector<std::string> names;
    for (const auto& entry : entries_)
      names.push_back(entry.first);
    return oneOf(std::move(names));
  }
  /// The value of a name that validation has let through.
  T value(const std::string& name) const
  {
    for (const auto& entry : entries_)
      if (entry.first == name)
        return entry.second;
    failUnknownName(name);
  }
  const std::string& name(T value) const /// the name of a value; InternalError if it has none
  {
    for (const auto& entry : entries_)
      if (entry.second == value)
        return entry.first;
    failUnknownName("?");
  }

private:
  std::vector<std::pair<std::string, T>> entries_;
};

} // namespace ndframe
