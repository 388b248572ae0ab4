#include "found_interfaces.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "automatic_list.hpp"
#include "ndframe/base/changed_params.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/interface/facing_search.hpp"
#include "ndframe/report/found_screen.hpp"
#include "ndframe/scene/read_meshes.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

constexpr double partOfScene = 0.01;      ///< the distance, where the deck has none
constexpr std::size_t fewInterfaces = 10; ///< the text of more is shown with -v

/// Turns the list Automatic of a deck into the interfaces that it stands for.
class InterfaceFinder
{
public:
  InterfaceFinder(const Params& deck, const Model& model)
      : deck_(deck), automatic_(deck.sub("Interfaces").sub("Automatic")), model_(model)
  {
    for (const BodyModel& body : model.bodies) {
      bodies_.push_back({body.isRigid ? &none_ : &body.uncut(), {}, {}});
      dim_ = std::max(dim_, body.uncut().dim);
    }
    if (dim_ == 3 && automatic_.has("Distance"))
      throw InputError(automatic_.mistake(
          "Distance", "Distance has no meaning in 3D, where sides are found that lie on each other; remove it."));
    for (const Params& given : givenInterfaces())
      for (const auto& [body, side] : sidesOf(given))
        prefer(body, side);
    leaveOut();
    distance_ = automatic_.has("Distance") ? automatic_.get<double>("Distance") : partOfScene * extentOf(bodies_);
  }

  void find()
  {
    FacingSearch search =
        dim_ == 3 ? searchMatching(bodies_) : searchFacing(bodies_, distance_, automatic_.get<double>("Corner Angle"));
    unnamed_ = std::move(search.unnamed);
    std::set<std::string> names;
    for (const Params& given : givenInterfaces())
      names.insert(given.name());
    for (const FacingPair& pair : search.pairs)
      if (!isGiven(pair))
        found_.push_back(named(pair, names));
    if (names.empty())
      refuseNothing();
  }

  const std::vector<FoundInterface>& found() const { return found_; }
  /// The table of them.
  std::string text() const { return dim_ == 3 ? matchingText(found_) : foundText(found_, distance_); }

  /// As the deck would have them.
  std::vector<Params> interfaces(const ListSpec& deckSpec) const
  {
    const Diagnostic place = automatic_.mistake("", "");
    DeckList list{"Interfaces", place.file, place.line, {}, {}};
    for (const FoundInterface& one : found_) {
      std::vector<DeckEntry> entries{{"Dirichlet Body", "string", one.firstBody, place.file, place.line},
                                     {"Dirichlet Side", "string", one.firstSide, place.file, place.line},
                                     {"Neumann Body", "string", one.secondBody, place.file, place.line},
                                     {"Neumann Side", "string", one.secondSide, place.file, place.line}};
      for (const DeckEntry& shared : sharedEntries(automatic_))
        entries.push_back(shared);
      list.lists.push_back({one.name, place.file, place.line, std::move(entries), {}});
    }
    ListSpec only;
    for (const ListSpec& spec : deckSpec.lists)
      if (spec.name == list.name)
        only.lists.push_back(spec);
    Diagnostics diagnostics;
    const Params made = validate({{}, place.file, place.line, {}, {std::move(list)}}, only, diagnostics);
    diagnostics.throwIfAny();
    return made.sub("Interfaces").subs();
  }

  std::vector<Params> givenInterfaces() const
  {
    std::vector<Params> given;
    for (const Params& list : deck_.sub("Interfaces").subs())
      if (list.name() != automatic_.name())
        given.push_back(list);
    return given;
  }

  std::vector<Diagnostic> warnings() const
  {
    std::vector<Diagnostic> warnings;
    for (const UnnamedFacing& part : unnamed_)
      warnings.push_back(automatic_.mistake(
          "",
          fmt::format("facets of \"{}\" near {} belong to no named side, or to one that shares facets with another, "
                      "and face {}: no interface was made of them. Name them in the mesh.",
                      nameOf(part.body), pointText(part.place.data(), dim_),
                      part.body == part.other ? "it itself" : fmt::format("\"{}\"", nameOf(part.other)))));
    return warnings;
  }

private:
  /// By body and name.
  using Sides = std::set<std::pair<std::string, std::string>>;

  static Sides sidesOf(const Params& interface)
  {
    Sides sides{{interface.get<std::string>("Dirichlet Body"), interface.get<std::string>("Dirichlet Side")}};
    if (interface.has("Neumann Side")) // else the other body is rigid
      sides.insert({interface.get<std::string>("Neumann Body"), interface.get<std::string>("Neumann Side")});
    return sides;
  }

  const std::string& nameOf(int body) const { return model_.bodies[std::size_t(body)].name; }

  void prefer(const std::string& body, const std::string& side)
  {
    if (const int index = model_.bodyIndex(body); index >= 0)
      bodies_[std::size_t(index)].preferred.push_back(side);
  }

  void leaveOut()
  {
    for (const std::string& path : automatic_.get<std::vector<std::string>>("Leave Out")) {
      bool exists = false;
      for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (const Side& side : bodies_[b].mesh->sides)
          if (path == model_.bodies[b].name + "/" + side.name) {
            bodies_[b].leftOut.push_back(side.name);
            exists = true;
          }
      if (!exists)
        throw InputError(automatic_.mistake(
            "Leave Out",
            fmt::format("there is no \"{}\"; write the names of a body and of its side as BODY/SIDE.", path)));
    }
  }

  bool isGiven(const FacingPair& pair) const
  {
    const Sides sides{{nameOf(pair.firstBody), pair.firstSide}, {nameOf(pair.secondBody), pair.secondSide}};
    const auto given = givenInterfaces();
    return std::any_of(given.begin(), given.end(), [&](const Params& list) { return sidesOf(list) == sides; });
  }

  /// With a name that is not taken yet.
  FoundInterface named(const FacingPair& pair, std::set<std::string>& names) const
  {
    const std::string plain =
        fmt::format("{} {} - {} {}", nameOf(pair.firstBody), pair.firstSide, nameOf(pair.secondBody), pair.secondSide);
    std::string name = plain;
    for (int next = 2; !names.insert(name).second; ++next)
      name = fmt::format("{} ({})", plain, next);
    const double few = 1e-9 * pair.length;
    const auto rounded = [&](double opening) { return std::abs(opening) < few ? 0.0 : opening; };
    return {name,        nameOf(pair.firstBody), pair.firstSide,       nameOf(pair.secondBody), pair.secondSide,
            pair.length, rounded(pair.smallest), rounded(pair.largest)};
  }

  void refuseNothing() const
  {
    if (dim_ == 3)
      throw InputError(automatic_.mistake("", "no two named sides lie on each other: flat, or with the same "
                                              "nodes. Move the bodies together, or name the sides in the meshes."));
    const auto refuse = [&](const std::string& hint) {
      throw InputError(
          automatic_.mistake("", fmt::format("no two named sides face each other within {:.4g}: {}", distance_, hint)));
    };
    const auto nearest = nearestSides(bodies_);
    if (!nearest)
      refuse("there are not two named sides of elastic bodies that could; leave the list out.");
    refuse(
        fmt::format("the nearest are \"{}\" of \"{}\" and \"{}\" of \"{}\", {:.4g} apart at {}{} if they are to touch.",
                    nearest->firstSide, nameOf(nearest->firstBody), nearest->secondSide, nameOf(nearest->secondBody),
                    nearest->distance, pointText(nearest->place.data(), 2),
                    nearest->distance > distance_ ? "; raise Distance"
                                                  : ", in a corner or at a large angle; name them in an interface"));
  }

  const Params& deck_;
  const Params automatic_;
  const Model& model_;
  const Mesh none_; ///< of a rigid body
  std::vector<SearchedBody> bodies_;
  int dim_ = 2;
  double distance_ = 0.0;
  std::vector<FoundInterface> found_;
  std::vector<UnnamedFacing> unnamed_;
};

/// The text of a deck that names what was found.
std::string deckText(const std::vector<Params>& interfaces)
{
  std::string text = "  as deck text, in the list Interfaces:\n\n";
  for (const Params& interface : interfaces)
    text += toXml(withoutDefaults(interface)) + "\n";
  return text;
}

} // namespace

RunSettings withFoundInterfaces(const RunSettings& settings, const Components& components, Model& model,
                                const Comm& comm, Ledger& ledger, const Log& log)
{
  if (!findsInterfaces(settings.deck))
    return settings;
  updateMeshes(model, settings.scene, components, comm, ledger);
  const auto timer = timeStage(ledger, Stage::Read);
  InterfaceFinder finder(settings.deck, model);
  finder.find();
  const std::vector<Params> found = finder.interfaces(makeDeckSpec(components));
  std::vector<Params> all = finder.givenInterfaces();
  all.insert(all.end(), found.begin(), found.end());
  log.line(finder.text() + "\n");
  if (found.size() <= fewInterfaces && !found.empty())
    log.line(deckText(found));
  else if (!found.empty())
    log.detail(deckText(found));
  RunSettings expanded = settings;
  expanded.deck = withSublists(settings.deck, "Interfaces", all);
  expanded.scene = readScene(expanded.deck);
  expanded.outline.interfaces = all.size();
  expanded.outline.findsInterfaces = false;
  expanded.unnamedFacing = finder.warnings();
  return expanded;
}

} // namespace ndframe
