#include "checkpoint_pieces.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/io/atomic_file.hpp"
#include "ndframe/mesh/piece_name.hpp"
#include "ndframe/report/checkpoint_bytes.hpp"

namespace ndframe
{
namespace
{

namespace fs = std::filesystem;

std::string partName(const std::string& path, const std::string& stamp, int pieces, int piece)
{
  return pieceName(path + "." + stamp, pieces, piece);
}

/// Of a time that no earlier run had.
std::string newStamp()
{
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return fmt::format("{:x}", std::chrono::duration_cast<std::chrono::microseconds>(now).count());
}

std::vector<Vector>& fieldsOf(Checkpoint& checkpoint)
{
  return checkpoint.sweeps->done.passes->system.fields;
}

/// Without what is in the parts.
Checkpoint withoutParts(Checkpoint checkpoint, int pieces, const std::string& stamp)
{
  for (Vector& field : fieldsOf(checkpoint))
    field.clear();
  for (Vector& places : checkpoint.shared.places)
    places.clear();
  checkpoint.pieces = pieces;
  checkpoint.stamp = stamp;
  return checkpoint;
}

/// With nothing else.
Checkpoint partOf(const Checkpoint& checkpoint, const std::string& stamp)
{
  Checkpoint part;
  part.version = checkpoint.version;
  part.stamp = stamp;
  part.shared = checkpoint.shared;
  part.sweeps.emplace();
  part.sweeps->done.passes.emplace();
  fieldsOf(part) = checkpoint.sweeps->done.passes->system.fields;
  return part;
}

void append(std::vector<Vector>& all, const std::vector<Vector>& more)
{
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].insert(all[i].end(), more[i].begin(), more[i].end());
}

/// Whether a name is "NAME.STAMP.N.r" with NAME.
bool isPart(const std::string& name, const std::string& whole)
{
  const auto stamp = whole.size() + 1, end = name.find('.', stamp), last = name.rfind('.');
  if (name.compare(0, stamp, whole + ".") != 0 || end == std::string::npos || end == stamp || last == end ||
      name.find_first_not_of("0123456789abcdef", stamp) != end)
    return false;
  const std::vector<std::string> meant = piecesMeant(name.substr(0, last));
  return std::find(meant.begin(), meant.end(), name) != meant.end();
}

} // namespace

std::string contentsOf(const std::string& path)
{
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    throw InputError(
        fmt::format("there is no \"{}\" to continue from: a run with Output/Checkpoint = true writes it "
                    "after its first level, Checkpoint Sweeps or status pass; run without --restart, from the "
                    "beginning.",
                    path));
  std::ifstream file(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path, ignored) || !file)
    throw InputError(fmt::format("cannot read \"{}\"; run without --restart, from the beginning.", path));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (text.empty())
    throw InputError(fmt::format("\"{}\" is empty; run without --restart, from the beginning.", path));
  return text;
}

bool isInPieces(const Checkpoint& checkpoint)
{
  return checkpoint.shared.isInParts;
}

void writeCheckpointPieces(const std::string& path, const Checkpoint& checkpoint, const Comm& comm)
{
  std::string stamp = newStamp();
  comm.broadcast(stamp);
  onEveryRank(comm, [&] {
    writeTextAtomically(partName(path, stamp, comm.size(), comm.rank()), toBytes(partOf(checkpoint, stamp)));
  });
  onEveryRank(comm, [&] {
    if (comm.rank() != 0)
      return;
    writeTextAtomically(path, toBytes(withoutParts(checkpoint, comm.size(), stamp)));
    removeCheckpointPieces(path, stamp);
  });
}

void readCheckpointPieces(const std::string& path, Checkpoint& checkpoint, const Comm& comm)
{
  onEveryRank(comm, [&] {
    for (int piece = comm.rank(); piece < checkpoint.pieces; piece += comm.size()) {
      const std::string name = partName(path, checkpoint.stamp, checkpoint.pieces, piece);
      const Checkpoint part = checkpointFromBytes(contentsOf(name), name, checkpoint.version);
      if (part.stamp != checkpoint.stamp || part.shared.places.size() != checkpoint.shared.places.size() ||
          !part.sweeps || !part.sweeps->done.passes ||
          part.sweeps->done.passes->system.fields.size() != fieldsOf(checkpoint).size())
        throw InputError(
            fmt::format("\"{}\" is no part of \"{}\"; run without --restart, from the beginning.", name, path));
      append(fieldsOf(checkpoint), part.sweeps->done.passes->system.fields);
      append(checkpoint.shared.places, part.shared.places);
    }
  });
}

void removeCheckpointPieces(const std::string& path, const std::string& stamp)
{
  const fs::path whole(path);
  const std::string name = whole.filename().string(), kept = name + "." + stamp + ".";
  std::error_code ignored;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(whole.has_parent_path() ? whole.parent_path() : ".", ignored), end; entry != end;
       entry.increment(ignored))
    if (const std::string other = entry->path().filename().string();
        entry->is_regular_file(ignored) && isPart(other, name) &&
        (stamp.empty() || other.compare(0, kept.size(), kept) != 0))
      found.push_back(entry->path());
  for (const fs::path& part : found)
    fs::remove(part, ignored);
}

} // namespace ndframe
