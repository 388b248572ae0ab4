#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ndframe
{

/// One mistake in the user's input: where it stands and how to mend it.
struct Diagnostic
{
  std::string file;    ///< deck or mesh file, "--set" for a setting of the command line; may be empty
  int line = 0;        ///< 1-based, 0 when unknown
  std::string path;    ///< list path such as "Bodies/punch/Material"
  std::string message; ///< what is wrong and how to mend it, one sentence

  /// "decks/punch.xml:41: Bodies/punch/Material: <message>"
  std::string text() const;
};

/// Mistakes collected while reading, so that the user sees all of them at once.
class Diagnostics
{
public:
  void add(Diagnostic diagnostic);                              ///< behind those there are
  void append(const Diagnostics& other);                        ///< all of the other one, behind those there are
  bool empty() const { return list_.empty(); }                  ///< no mistake so far
  const std::vector<Diagnostic>& list() const { return list_; } ///< in the order in which they were added

  /// Throws InputError with everything collected so far, if there is anything.
  void throwIfAny() const;

private:
  std::vector<Diagnostic> list_;
};

/// The user's input is wrong (exit code 2). what() holds one line per mistake.
class InputError : public std::runtime_error
{
public:
  explicit InputError(std::vector<Diagnostic> list); ///< all mistakes of one reading
  explicit InputError(Diagnostic single) : InputError(std::vector<Diagnostic>{std::move(single)}) {} ///< one mistake
  /// A mistake with no place in a deck, e.g. a file that cannot be opened.
  explicit InputError(const std::string& message) : InputError(Diagnostic{{}, 0, {}, message}) {}
  const std::vector<Diagnostic>& list() const { return list_; } ///< as in what()

private:
  std::vector<Diagnostic> list_;
};

/// A solver gave up for a reason that lies in the problem, not in the code (exit code 3).
class NotConverged : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A broken invariant: a bug of ours (exit code 1).
class InternalError : public std::logic_error
{
public:
  using std::logic_error::logic_error;
};

/// Asserts an invariant in every build type; a failure is a bug and carries its place.
#define NDFRAME_ASSERT(condition, message)                                                                             \
  do {                                                                                                                 \
    if (!(condition))                                                                                                  \
      ::ndframe::failAssertion(#condition, (message), __FILE__, __LINE__);                                             \
  } while (false)
/// Throws InternalError with all of these in its text.
[[noreturn]] void failAssertion(const char* condition, const std::string& message, const char* file, int line);

} // namespace ndframe
