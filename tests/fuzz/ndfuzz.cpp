// Tries a reader on damaged files: ndfuzz READER [--inputs N] [--seed S] [--only I] [--verbose].
//
// Every input must be read or refused with an InputError, come to an end, and take at most 64 MB + 200 times its size.
// Anything else ends the program with the input kept, and its number: --only repeats it.

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "fuzz/allocated.hpp"
#include "fuzz/mutator.hpp"
#include "fuzz/targets.hpp"
#include "ndframe/base/diagnostics.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

constexpr unsigned secondsPerInput = 300; // of the wall clock, on a busy machine
constexpr std::size_t freeBytes = std::size_t(64) << 20;
constexpr std::size_t bytesPerByte = 200;

extern "C" void reportHang(int)
{
  constexpr char text[] = "HANG: an input takes too long\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, sizeof text - 1);
  std::_Exit(1);
}

struct Options
{
  std::string reader;
  std::uint64_t inputs = 100'000, seed = 1;
  std::int64_t only = -1;
  bool verbose = false;
};

/// How many inputs ended so.
using Outcomes = std::map<std::string, std::uint64_t>;

/// What a message says of the library that reads the file, and what that is called here.
constexpr std::pair<const char*, const char*> libraryFailures[]{
    {" crashed on this file", "refused: the library crashed"},
    {" did not finish", "refused: the library did not end"},
    {" asks for more memory", "refused: the library wanted too much memory"},
    {"no child process can be started", "refused: no process for the library"}};

/// What became of an input: "read", "refused", or "refused: " and how the library failed on it.
std::string outcomeOf(const Target& target, const std::string& path)
{
  try {
    target.read(path);
    return "read";
  } catch (const InputError& error) {
    const std::string text = error.what();
    for (const auto& [said, outcome] : libraryFailures)
      if (text.find(said) != std::string::npos)
        return outcome;
    return "refused";
  }
}

void requireModestMemory(std::size_t before, std::size_t fileSize)
{
  const std::size_t used = takePeakBytes() - before;
  if (used > freeBytes + bytesPerByte * fileSize)
    throw std::runtime_error(fmt::format("MEMORY: {} bytes for a file of {}", used, fileSize));
}

void writeInput(const std::string& path, const std::string& input)
{
  std::ofstream file(path, std::ios::binary);
  file << input << std::flush;
  if (!file)
    throw std::runtime_error("cannot write " + path);
}

void tryInput(const Target& target, Mutator& mutate, std::uint64_t n, const std::string& path, Outcomes& outcomes,
              bool verbose)
{
  const std::string input = mutate(n);
  writeInput(path, input);
  alarm(secondsPerInput);
  takePeakBytes();
  const std::size_t before = allocatedBytes();
  try {
    const std::string outcome = outcomeOf(target, path);
    requireModestMemory(before, input.size());
    ++outcomes[outcome];
    if (verbose && outcome.find(':') != std::string::npos)
      std::cout << "input " << n << " " << outcome << std::endl;
  } catch (...) {
    std::cerr << fmt::format("input {} (kept as {}):\n", n, path);
    throw;
  }
}

int fuzz(const Options& options)
{
  std::string folder = (std::filesystem::temp_directory_path() / "ndfuzz-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr)
    throw std::runtime_error("no folder can be made as " + folder);
  const std::string path = folder + "/input";
  std::cout << "inputs are " << path << std::endl;
  const Target target = makeTarget(options.reader, folder);
  Mutator mutate(target.sound, target.text, options.seed);
  std::signal(SIGALRM, reportHang);
  Outcomes outcomes;
  const auto first = options.only >= 0 ? std::uint64_t(options.only) : 0;
  const auto end = options.only >= 0 ? first + 1 : options.inputs;
  for (std::uint64_t n = first; n < end; ++n)
    tryInput(target, mutate, n, path, outcomes, options.verbose);
  std::cout << options.reader << ", seed " << options.seed << ":";
  for (const auto& [outcome, count] : outcomes)
    std::cout << fmt::format("  {} {}", count, outcome);
  std::cout << std::endl;
  if (options.only < 0)
    std::filesystem::remove_all(folder);
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  CLI::App app("Tries a reader on damaged files.", "ndfuzz");
  app.add_option("reader", options.reader, "deck, msh, geo or exodus")->required();
  app.add_option("--inputs", options.inputs, "how many")->capture_default_str();
  app.add_option("--seed", options.seed, "of the damage")->capture_default_str();
  app.add_option("--only", options.only, "one input by its number; the file is kept");
  app.add_flag("--verbose", options.verbose, "name the inputs that a library failed on");
  CLI11_PARSE(app, argc, argv);
  try {
    return fuzz(options);
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return 1;
  }
}
