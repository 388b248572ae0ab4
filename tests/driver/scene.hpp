#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ndframe/base/deck.hpp"
#include "ndframe/driver/run_deck.hpp"

namespace ndframe::test
{

/// Everything ndframe ships.
const Components& components();

/// Path of decks/NAME.xml.
std::string shippedDeck(const std::string& name);

/// All decks that are shipped, by name, but studies and load cases: those are not one run.
std::vector<std::string> shippedDecks();

/// A run with the ledger that its factors count in.
struct Outcome
{
  std::unique_ptr<Ledger> ledger;
  Run run;
};

/// A deck on its way to a run: read, changed, run.
class Scene
{
public:
  /// A shipped deck. Without its expectations, which belong to the deck as it is.
  explicit Scene(const std::string& shippedName);
  static Scene fromText(const std::string& xml);
  static Scene fromFile(const std::string& path);

  /// As --set does.
  Scene& set(const std::string& setting);
  /// Runs `change` on every entry named `key`, wherever it stands.
  Scene& changeAll(const std::string& key, const std::function<std::string(const std::string&)>& change);
  /// Turns all boxes about the origin. Gaps and vectors given in the deck are not turned.
  Scene& rotate(double degrees);
  /// The same scene in other units: every length and every stress of the deck multiplied.
  Scene& changeUnits(double length, double stress);
  /// Turns the order of the bodies round.
  Scene& reverseBodies();

  Params params() const;
  Outcome run() const;
  DeckList& deck() { return deck_; }

private:
  explicit Scene(DeckList deck) : deck_(std::move(deck)) {}
  DeckList deck_;
};

/// The words of an InputError or NotConverged that running the scene ends with; a failure if it runs.
std::string complaintOf(const Scene& scene);

/// Final displacement of a body, global axes.
const Vector& displacement(const Run& run, int body);

/// Largest |a_i - b_i| over the largest |b_i|.
double relativeDifference(const Vector& a, const Vector& b);

/// Final status of every interface node.
std::vector<char> statuses(const Run& run);

/// Lambda_dir at every interface node.
Vector traction(const Run& run);

} // namespace ndframe::test
