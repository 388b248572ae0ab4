#include "ndframe/base/scratch.hpp"

#include <algorithm>
#include <mutex>
#include <vector>

namespace ndframe
{

namespace
{

std::mutex mutex; ///< of what follows
std::vector<const Scratch*> living;

void removeOne(const Scratch& scratch)
{
  std::error_code ignored;
  std::filesystem::remove_all(scratch.path(), ignored);
}

} // namespace

Scratch::Scratch(std::filesystem::path path) : path_(std::move(path))
{
  const std::lock_guard<std::mutex> lock(mutex);
  living.push_back(this);
}

Scratch::~Scratch()
{
  const std::lock_guard<std::mutex> lock(mutex);
  removeOne(*this);
  living.erase(std::find(living.begin(), living.end(), this));
}

void removeScratch()
{
  const std::lock_guard<std::mutex> lock(mutex);
  for (const Scratch* scratch : living)
    removeOne(*scratch);
}

} // namespace ndframe
