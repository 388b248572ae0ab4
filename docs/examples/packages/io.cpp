// Writes a contact table so that nobody sees half a file, and reads back the same bits.
#include <fstream>
#include <string>

#include "ndframe/io/atomic_file.hpp"
#include "ndframe/io/contact_table.hpp"

int main()
{
  using namespace ndframe;
  std::vector<ContactNode> nodes(3);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].interface = "punch, left"; // a separator: the name is put in quotes
    nodes[i].point = {double(i) / 3.0, 0.0};
    nodes[i].closed = i < 2;
  }
  const std::string table = contactCsv(nodes, 2);
  const std::int64_t bytes = writeTextAtomically("io-example.contact.csv", table);

  std::ifstream file("io-example.contact.csv");
  std::string line;
  std::getline(file, line); // the names of the columns
  bool ok = bytes == std::int64_t(table.size()) && line.rfind("interface,x,y,arc_length,pressure,gap", 0) == 0;
  for (const ContactNode& node : nodes) {
    const std::string name = "\"punch, left\",";
    ok = std::getline(file, line) && line.rfind(name, 0) == 0 && ok;
    ok = ok && std::stod(line.substr(name.size())) == node.point[0] && line.back() == (node.closed ? '1' : '0');
  }
  removeEarlier("io-example.contact.csv");
  return ok && !std::getline(file, line) ? 0 : 1;
}
