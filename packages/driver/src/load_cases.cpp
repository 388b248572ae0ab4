#include "load_cases.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "accuracy_list.hpp"
#include "case_expectations.hpp"
#include "deck_texts.hpp"
#include "ndframe/base/help.hpp"
#include "ndframe/base/list_specs.hpp"
#include "ndframe/driver/tied_deck.hpp"
#include "scaled_data.hpp"

namespace ndframe
{
namespace
{

constexpr const char* listName = "Load Cases";

const DeckEntry* setBefore(const std::vector<DeckEntry>& entries, const std::string& name)
{
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

/// Factors with paths as keys: `--set "Load Cases/Factors/Bodies/punch/Loads/press={1, 2}"` makes lists of the path,
/// which replaces the key that the deck has.
void collectFactors(const DeckList& list, const std::string& path, DeckList& flat)
{
  for (DeckEntry entry : list.entries) {
    entry.name = plainPath(path + entry.name);
    if (const DeckEntry* const before = setBefore(flat.entries, entry.name))
      flat.entries[std::size_t(before - flat.entries.data())] = entry;
    else
      flat.entries.push_back(entry);
  }
  for (const DeckList& sub : list.lists)
    collectFactors(sub, path + sub.name + "/", flat);
}

DeckList withPaths(DeckList list)
{
  for (DeckList& sub : list.lists)
    if (sub.name == "Factors") {
      DeckList flat{sub.name, sub.file, sub.line, {}, {}};
      collectFactors(sub, "", flat);
      sub = flat;
    }
  return list;
}

/// Names of cases, factors, and the place of each.
class CaseList
{
public:
  CaseList(const DeckList& list, const ScalableData& data, Diagnostics& diagnostics) : list_(list)
  {
    ListSpec only;
    only.lists = {loadCasesSpec()};
    Diagnostics mistakes;
    params_ = validate({{}, list.file, 0, {}, {list}}, only, mistakes);
    if (mistakes.empty()) {
      names_ = params().get<std::vector<std::string>>("Names");
      checkNames(mistakes);
    }
    if (mistakes.empty()) {
      for (const DeckEntry& entry : factors().entries)
        checkFactor(entry, data, mistakes);
    }
    diagnostics.append(mistakes);
  }

  Params params() const { return params_->sub(listName); }
  const std::vector<std::string>& names() const { return names_; }
  const DeckList& factors() const { return *list_.findList("Factors"); }
  double factor(const std::string& path, std::size_t k) const
  {
    return params().sub("Factors").get<std::vector<double>>(path)[k];
  }

private:
  void checkNames(Diagnostics& mistakes) const
  {
    const auto refuse = [&](const std::string& message) { mistakes.add(params().mistake("Names", message)); };
    if (names_.empty())
      refuse("Names has no case; name them, such as {assembly, half, full}.");
    std::set<std::string> seen;
    for (const std::string& name : names_) {
      if (name.empty() || name.find('/') != std::string::npos)
        refuse(fmt::format(
            "\"{}\" cannot name a case: files and quantities are named after it, which needs a name without \"/\".",
            name));
      if (!seen.insert(name).second)
        refuse(fmt::format("two cases are called \"{}\"; give each its own name.", name));
    }
  }

  void checkFactor(const DeckEntry& entry, const ScalableData& data, Diagnostics& mistakes) const
  {
    const Params place = params().sub("Factors");
    if (!data.has(entry.name)) {
      mistakes.add(place.mistake(entry.name, unknownPath(entry.name, data.paths())));
      return;
    }
    const std::size_t number = place.get<std::vector<double>>(entry.name).size();
    if (number != names_.size())
      mistakes.add(place.mistake(entry.name, fmt::format("{} has {} factor{} for {} case{}; give one for each of {}.",
                                                         entry.name, number, number == 1 ? "" : "s", names_.size(),
                                                         names_.size() == 1 ? "" : "s", fmt::join(names_, ", "))));
  }

  static std::string unknownPath(const std::string& path, const std::vector<std::string>& paths)
  {
    std::string near = nearestName(path, paths);
    for (const std::string& known : paths) // without the word that all begin with
      if (near.empty() && known.substr(known.find('/') + 1) == path)
        near = known;
    std::string text = fmt::format("\"{}\" is not something that a factor multiplies", path);
    if (!near.empty())
      return text + fmt::format("; did you mean \"{}\"?", near);
    return paths.empty() ? text + ": the deck gives no load, displacement or gap."
                         : text + fmt::format(": a list with a load, a prescribed displacement or a gap; those are {}.",
                                              fmt::join(paths, ", "));
  }

  const DeckList& list_;
  std::optional<Params> params_;
  std::vector<std::string> names_;
};

/// Sweeps and cases cannot both be the steps of one file; a study has other decks.
void refuseOtherSteps(const DeckList& deck, const DeckList& list, Diagnostics& diagnostics)
{
  if (deck.findList("Study") != nullptr)
    diagnostics.add({list.file, list.line, listName,
                     "a deck has either load cases or a Study; an axis of a study can vary the values of loads."});
  if (deck.findList("Accuracy") == nullptr && outputEntry(deck, "Steps") == "All Sweeps")
    diagnostics.add(
        {list.file, list.line, listName,
         "the steps of the Exodus file are the cases; Output/Steps = All Sweeps would make them sweeps. Remove one."});
}

void removeList(DeckList& deck, const std::string& name)
{
  deck.lists.erase(std::remove_if(deck.lists.begin(), deck.lists.end(), [&](const auto& l) { return l.name == name; }),
                   deck.lists.end());
}

StudyCase makeCase(const Study& study, const CaseList& cases, std::size_t k, const ScalableData& data, DeckList deck,
                   const ListSpec& spec, Diagnostics& diagnostics)
{
  StudyCase made{cases.names()[k], {cases.names()[k]}, Params(nullptr)};
  for (const DeckEntry& entry : cases.factors().entries) {
    const double factor = cases.factor(entry.name, k);
    data.multiply(deck, entry.name, factor);
    made.values.push_back(fmt::format("{}", factor));
  }
  keepExpectations(deck, made.name);
  applySetting(deck, "Output/Report=false", diagnostics); // of all cases
  if (!study.loads->sharesFiles)
    applySetting(deck, fmt::format("Output/Name={}.{}", study.fileName, made.name), diagnostics);
  completeAccuracyDeck(deck, diagnostics);
  made.deck = validateScene(deck, spec, diagnostics);
  return made;
}

/// The deck as it was written. Its mistakes are those of all cases, before anything is multiplied; those of the list
/// stand in `mistakes` already.
Params validateWhole(DeckList deck, const DeckList& list, const ListSpec& spec, Diagnostics& mistakes)
{
  if (mistakes.empty())
    deck.lists.push_back(list);
  completeAccuracyDeck(deck, mistakes);
  return validate(deck, spec, mistakes);
}

/// Mistakes that several cases share are told once.
void addCases(Study& study, const CaseList& cases, const ScalableData& data, const DeckList& base, const ListSpec& spec,
              Diagnostics& diagnostics)
{
  std::set<std::string> said;
  for (std::size_t k = 0; k < cases.names().size(); ++k) {
    Diagnostics ofCase;
    study.cases.push_back(makeCase(study, cases, k, data, base, spec, ofCase));
    for (const auto& mistake : ofCase.list())
      if (said.insert(mistake.text()).second)
        diagnostics.add(mistake);
  }
}

/// Name and factors, which move together.
StudyAxis axisOf(const CaseList& cases)
{
  StudyAxis axis{"name", {{"name", {}, {}, 0}}, {cases.names()}};
  for (const DeckEntry& entry : cases.factors().entries) {
    axis.parameters.push_back({entry.name, {}, entry.file, entry.line});
    axis.values.emplace_back();
    for (std::size_t k = 0; k < cases.names().size(); ++k)
      axis.values.back().push_back(fmt::format("{}", cases.factor(entry.name, k)));
  }
  return axis;
}

} // namespace

ListSpec loadCasesSpec()
{
  ListSpec factors =
      makeList("Factors", "What is multiplied, and by what in each case. What is not named is the same in all.");
  factors.isRequired = true;
  factors.eachParam = ParamSpec::required(
      "PATH", Kind::Doubles,
      "The name is the path of a load (\"Bodies/punch/Loads/press\"), of a support with prescribed displacements "
      "(\"Bodies/block/Supports/top\"), of an interface with a Gap (\"Interfaces/contact\") or of a rigid body "
      "(\"Bodies/ball/Rigid\": its Displacement); the value has one factor per case.");
  ListSpec list = makeList(
      listName,
      "Solves the scene for several independent load states in one process: nothing is meshed or factored again, and "
      "contact starts from that of the previous case. Each case is a time step in NAME.e, a row in NAME.cases.csv and "
      "an entry in NAME.summary.json. With the list Accuracy every case has its own meshes and files, NAME.CASE.e, ... "
      "An expectation holds for all cases, or for one: its Quantity then begins with \"cases/CASE/\".");
  list.onlyIfGiven = true;
  list.params = {
      ParamSpec::required("Names", Kind::Strings, "Names of the cases, in the order in which they are solved."),
      {"Columns", std::vector<std::string>{}, "More columns of the table: paths of numbers in the summary of a case."}};
  list.lists = {std::move(factors)};
  return list;
}

Study expandLoadCases(const DeckList& deck, const std::string& deckName, const ListSpec& spec, Diagnostics& diagnostics)
{
  DeckList base = deck;
  removeList(base, listName);
  const DeckList list = withPaths(*deck.findList(listName));
  const ScalableData data(base, spec);
  Diagnostics mistakes;
  refuseOtherSteps(base, list, mistakes);
  removeList(base, "Study");
  const CaseList cases(list, data, mistakes);
  Study study;
  if (mistakes.empty())
    checkExpectations(base, cases.names(), mistakes);
  const Params whole = validateWhole(base, list, spec, mistakes);
  diagnostics.append(mistakes);
  if (!mistakes.empty())
    return study;
  study.loads = LoadCases{base.findList("Accuracy") == nullptr, outputEntry(base, "Summary") != "false",
                          whole.get<std::string>("Title"), toJson(whole)};
  study.fileName = fileNameOf(base, deckName);
  study.columns = cases.params().get<std::vector<std::string>>("Columns");
  study.writesFiles = !study.loads->sharesFiles;
  study.writesReport = outputEntry(base, "Report") == "true";
  study.axes = {axisOf(cases)};
  addCases(study, cases, data, base, spec, diagnostics);
  return study;
}

} // namespace ndframe
