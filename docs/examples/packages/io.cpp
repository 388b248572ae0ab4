// Writes a table so that nobody sees half a file, and reads back the same bits.
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "ndframe/io/atomic_file.hpp"
#include "ndframe/io/csv.hpp"

int main()
{
  using namespace ndframe;
  const std::string name = csvField("punch, left"); // a separator: the name is put in quotes
  std::string table = "interface,x\n";
  for (int i = 0; i < 3; ++i)
    table += fmt::format("{},{:.17g}\n", name, i / 3.0);
  const std::int64_t bytes = writeTextAtomically("io-example.csv", table);

  std::ifstream file("io-example.csv");
  std::string line;
  std::getline(file, line); // the names of the columns
  bool ok = bytes == std::int64_t(table.size()) && line == "interface,x";
  for (int i = 0; i < 3; ++i) {
    const std::string field = "\"punch, left\",";
    ok = std::getline(file, line) && line.rfind(field, 0) == 0 && ok;
    ok = ok && std::stod(line.substr(field.size())) == i / 3.0;
  }
  removeEarlier("io-example.csv");
  return ok && !std::getline(file, line) ? 0 : 1;
}
