#include <array>

#include "ndframe/reading/msh_file.hpp"

namespace ndframe
{

namespace
{

/// By gmsh's number, from 1.
constexpr std::array<MshElementType, 31> elementTypes{
    {{"line", 1, 1, 2},         {"triangle", 2, 1, 3},     {"quadrangle", 2, 1, 4},   {"tetrahedron", 3, 1, 4},
     {"hexahedron", 3, 1, 8},   {"prism", 3, 1, 6},        {"pyramid", 3, 1, 5},      {"line", 1, 2, 3},
     {"triangle", 2, 2, 6},     {"quadrangle", 2, 2, 9},   {"tetrahedron", 3, 2, 10}, {"hexahedron", 3, 2, 27},
     {"prism", 3, 2, 18},       {"pyramid", 3, 2, 14},     {"point", 0, 1, 1},        {"quadrangle", 2, 2, 8},
     {"hexahedron", 3, 2, 20},  {"prism", 3, 2, 15},       {"pyramid", 3, 2, 13},     {"triangle", 2, 3, 9},
     {"triangle", 2, 3, 10},    {"triangle", 2, 4, 12},    {"triangle", 2, 4, 15},    {"triangle", 2, 5, 15},
     {"triangle", 2, 5, 21},    {"line", 1, 3, 4},         {"line", 1, 4, 5},         {"line", 1, 5, 6},
     {"tetrahedron", 3, 3, 20}, {"tetrahedron", 3, 4, 35}, {"tetrahedron", 3, 5, 56}}};

} // namespace

const MshElementType* findMshElementType(int type)
{
  return type < 1 || type > int(elementTypes.size()) ? nullptr : &elementTypes[std::size_t(type) - 1];
}

} // namespace ndframe
