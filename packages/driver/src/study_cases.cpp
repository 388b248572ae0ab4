#include "study_cases.hpp"

#include <algorithm>
#include <cstdint>
#include <set>

#include <fmt/format.h>

#include "accuracy_list.hpp"
#include "deck_texts.hpp"
#include "ndframe/driver/tied_deck.hpp"

namespace ndframe
{
namespace
{

/// Nobody waits for more; a larger grid is a slip.
constexpr std::int64_t mostCases = 10000;

template <class Items>
auto findNamed(Items& items, const std::string& name)
{
  return std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
}

StudyAxis makeAxis(const DeckList& list, Diagnostics& diagnostics)
{
  StudyAxis axis;
  axis.name = list.name;
  const auto mistake = [&](int line, const std::string& message) {
    diagnostics.add({list.file, line, "Study/" + list.name, message});
  };
  if (list.entries.empty())
    mistake(list.line, "varies nothing; give it a parameter such as \"Coupling/Stopping/Tolerance\" = \"0.1; 0.01\".");
  for (const auto& entry : list.entries) {
    axis.parameters.push_back({entry.name, {}, entry.file, entry.line});
    axis.values.push_back(partsOf(entry.value, ";"));
    const auto& values = axis.values.back();
    if (std::find(values.begin(), values.end(), std::string()) != values.end())
      mistake(entry.line, fmt::format("{} = \"{}\" has an empty value; write values with \";\" between them.",
                                      entry.name, entry.value));
    if (values.size() != axis.size())
      mistake(entry.line, fmt::format("the parameters of an axis move together, but {} has {} values and {} has {}.",
                                      entry.name, values.size(), axis.parameters.front().path, axis.size()));
  }
  return axis;
}

void refuseRepeated(const std::vector<StudyAxis>& axes, Diagnostics& diagnostics)
{
  std::set<std::string> seen;
  for (const auto& axis : axes)
    for (const auto& parameter : axis.parameters)
      if (!seen.insert(plainPath(parameter.path)).second)
        diagnostics.add({parameter.file, parameter.line, "Study/" + axis.name,
                         fmt::format("{} varies along another axis already; leave it out of one.", parameter.path)});
}

/// 0 when there are too many.
std::int64_t numCases(const Study& study, const DeckList& list, Diagnostics& diagnostics)
{
  std::int64_t number = 1;
  for (const auto& axis : study.axes)
    number = std::min(number * std::int64_t(std::min<std::size_t>(axis.size(), mostCases + 1)), mostCases + 1);
  if (number > mostCases)
    diagnostics.add({list.file, list.line, "Study",
                     fmt::format("has more than {} cases; leave out values or an axis.", mostCases)});
  return number > mostCases ? 0 : number;
}

/// A study is read in its table; files of the cases are written on demand.
void setOutput(DeckList& deck, const Study& study, const std::string& caseName, Diagnostics& diagnostics)
{
  applySetting(deck, "Output/Report=false", diagnostics); // of the table
  if (study.writesFiles)
    applySetting(deck, "Output/Name=" + caseName, diagnostics);
  else
    for (const char* file : {"Exodus", "Summary", "Contact Table", "Level Table", "All Levels"})
      applySetting(deck, fmt::format("Output/{}=false", file), diagnostics);
  const DeckList* const output = deck.findList("Output");
  if (!study.writesFiles && output->findList("Probes") != nullptr)
    applySetting(deck, "Output/Probes/Table=false", diagnostics);
}

/// The values of the case with this number, axis by axis.
std::vector<Setting> settingsOf(const Study& study, std::int64_t number)
{
  std::vector<Setting> settings;
  for (auto axis = study.axes.rbegin(); axis != study.axes.rend(); ++axis) {
    const auto point = std::size_t(number % std::int64_t(axis->size()));
    number /= std::int64_t(axis->size());
    std::vector<Setting> here = axis->parameters;
    for (std::size_t p = 0; p < here.size(); ++p)
      here[p].value = axis->values[p][point];
    settings.insert(settings.begin(), here.begin(), here.end());
  }
  return settings;
}

StudyCase makeCase(const Study& study, DeckList deck, std::int64_t number, const ListSpec& spec,
                   Diagnostics& diagnostics)
{
  std::vector<std::string> values;
  for (const auto& setting : settingsOf(study, number)) {
    applySetting(deck, setting, diagnostics);
    values.push_back(setting.value);
  }
  setOutput(deck, study, fmt::format("{}.{}", study.fileName, number + 1), diagnostics);
  completeAccuracyDeck(deck, diagnostics);
  return {fmt::format("{}", number + 1), std::move(values), validateScene(deck, spec, diagnostics)};
}

/// Replaces the values of a parameter that an axis of the deck moves already; false if none does.
bool replaceValues(DeckList& study, const DeckEntry& entry, Diagnostics& diagnostics)
{
  for (auto& axis : study.lists)
    for (auto& present : axis.entries)
      if (plainPath(present.name) == plainPath(entry.name)) {
        if (present.file == entry.file)
          diagnostics.add({"--study",
                           0,
                           {},
                           fmt::format("{} is given twice; write all its values in one, with \";\" between them.",
                                       plainPath(entry.name))});
        present = entry;
        return true;
      }
  return false;
}

/// What decides about the results of a case: all of its deck but what only names them.
std::string decisiveText(const Study& study, const Params& deck)
{
  const bool touches = !deck.sub("Interfaces").subs().empty();
  std::string text;
  if (study.writesFiles) {
    const std::string name = deck.sub("Output").get<std::string>("Name");
    text = toXml(deck.sub("Output"));
    text.erase(text.find(name), name.size()); // every case has its own
  }
  for (const Params& list : deck.subs())
    if (list.name() != "Output" && (touches || list.name() != "Coupling"))
      text += toXml(list);
  return text;
}

/// An axis along which nothing changes solves the same thing again and again.
void refuseIdle(const Study& study, Diagnostics& diagnostics)
{
  std::size_t stride = study.cases.size();
  for (const auto& axis : study.axes) {
    stride /= axis.size();
    std::set<std::string> different;
    for (std::size_t point = 0; point < axis.size(); ++point)
      different.insert(decisiveText(study, study.cases[point * stride].deck));
    const auto& place = axis.parameters.front();
    if (axis.size() > 1 && different.size() == 1)
      diagnostics.add({place.file, place.line, "Study/" + axis.name,
                       "all its values give the same results; leave it out, or vary something that this deck uses."});
  }
}

} // namespace

ListSpec studySpec()
{
  ListSpec axis;
  axis.name = "AXIS";
  axis.doc = "Parameters that vary together, their values separated by \";\". Axes are combined into a grid, the last "
             "one varies fastest.";
  axis.eachParam = ParamSpec::required("PATH", Kind::String,
                                       "The name is the path of a parameter, e.g. \"Bodies/punch/Mesh/Cells\", the "
                                       "value lists what it is set to in turn, e.g. "
                                       "\"{15, 15}; {30, 30}\".");
  ListSpec study;
  study.name = "Study";
  study.doc = "Runs the deck once for every combination of values and writes one row per case to NAME.study.csv. What "
              "a case does not change is not recomputed, so name meshes first, then materials, then loads, and last "
              "what concerns the solution (tolerances, couplings).";
  study.onlyIfGiven = true;
  study.params = {{"Columns", std::vector<std::string>{},
                   "More columns: paths of numbers in the summary, e.g. \"interfaces/contact/largest_pressure\"."},
                  {"Files", false, "Write the files of every case too, as NAME.1.e, ..."}};
  study.each = std::make_shared<ListSpec>(std::move(axis));
  return study;
}

void addAxis(DeckList& deck, const std::string& axis, Diagnostics& diagnostics)
{
  if (deck.findList("Study") == nullptr)
    deck.lists.push_back({"Study", "--study", 0, {}, {}});
  DeckList& study = *findNamed(deck.lists, "Study");
  DeckList added{{}, "--study", 0, {}, {}};
  for (const auto& part : partsOf(axis, "&&")) {
    const auto equals = part.find('=');
    if (equals == std::string::npos || equals == 0) {
      diagnostics.add({"--study", 0, {}, fmt::format("\"{}\" is not \"List/Sublist/Key=value; value; ...\".", part)});
      continue;
    }
    const DeckEntry entry{trimmed(part.substr(0, equals)), {}, part.substr(equals + 1), "--study", 0};
    if (!replaceValues(study, entry, diagnostics))
      added.entries.push_back(entry);
  }
  if (added.entries.empty())
    return;
  added.name = added.entries.front().name;
  study.lists.push_back(std::move(added));
}

Study expandStudy(const DeckList& deck, const std::string& deckName, const ListSpec& spec, Diagnostics& diagnostics)
{
  Study study;
  DeckList base = deck;
  base.lists.erase(findNamed(base.lists, "Study"));
  const DeckList& list = *deck.findList("Study");
  ListSpec only;
  only.lists = {studySpec()};
  Diagnostics mistakes;
  const Params params = validate({{}, deck.file, 0, {}, {list}}, only, mistakes);
  for (const auto& axis : list.lists)
    study.axes.push_back(makeAxis(axis, mistakes));
  refuseRepeated(study.axes, mistakes);
  const std::int64_t number = mistakes.empty() ? numCases(study, list, mistakes) : 0;
  if (!mistakes.empty()) {
    diagnostics.append(mistakes);
    validate(base, spec, diagnostics);
    return study;
  }
  study.fileName = fileNameOf(base, deckName);
  study.columns = params.sub("Study").get<std::vector<std::string>>("Columns");
  study.writesFiles = params.sub("Study").get<bool>("Files");
  study.writesReport = outputEntry(base, "Report") == "true";
  std::set<std::string> said;
  for (std::int64_t k = 0; k < number; ++k) {
    Diagnostics ofCase;
    study.cases.push_back(makeCase(study, base, k, spec, ofCase));
    for (const auto& mistake : ofCase.list())
      if (said.insert(mistake.text()).second)
        diagnostics.add(mistake);
  }
  if (said.empty())
    refuseIdle(study, diagnostics);
  return study;
}

} // namespace ndframe
