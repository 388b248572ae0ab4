#include <string>

#include <gtest/gtest.h>

#include "ndframe/base/byte_hash.hpp"

namespace
{

using ndframe::byteHash;

std::uint64_t hashOf(const std::string& text)
{
  return byteHash(text.data(), text.size());
}

} // namespace

TEST(ByteHash, IsThatOfItsAuthors)
{
  EXPECT_EQ(hashOf(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hashOf("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(hashOf("foobar"), 0x85944171f73967e8u);
}

TEST(ByteHash, GoesOnFromTheBytesBefore)
{
  EXPECT_EQ(byteHash("bar", 3, hashOf("foo")), hashOf("foobar"));
}
