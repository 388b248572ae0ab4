#pragma once

#include <memory>
#include <string>

#include "ndframe/meshing/mesh_source.hpp"

namespace ndframe::test
{

// A `Mesh` list of a deck, entry by entry.
std::string doubles(const std::string& key, const std::string& values);
std::string ints(const std::string& key, const std::string& values);
std::string strings(const std::string& key, const std::string& values);
std::string text(const std::string& key, const std::string& value);
std::string number(const std::string& key, const std::string& value);
std::string integer(const std::string& key, const std::string& value);
std::string boolean(const std::string& key, const std::string& value);
std::string list(const std::string& name, const std::string& entries);

/// What the list with these entries ("Type" among them) makes. InputError goes through.
std::unique_ptr<MeshSource> meshSource(const std::string& entries);
/// Its mesh.
Mesh readMesh(const std::string& entries);
/// The message of the InputError that readMesh throws; a test failure when it throws none.
std::string messageOf(const std::string& entries);

/// A path in the test's own corner of the temporary directory.
std::string scratchPath(const std::string& name);
/// Writes a scratch file and returns its path.
std::string scratchFile(const std::string& name, const std::string& contents);
std::string contentsOf(const std::string& path);
/// A file of tests/meshing/data.
std::string dataPath(const std::string& name);

/// Sum of the cells' measures.
double volume(const Mesh& mesh);
double measure(const Mesh& mesh, const Side& side);
/// Sum over the whole boundary of the outward normals times their measure (zero for every mesh), relative to its
/// measure.
double boundaryDefect(const Mesh& mesh);
/// Smallest and largest distance of the vertices of a side from the line or plane normal.x = offset.
double distanceFromPlane(const Mesh& mesh, const Side& side, const double* normal, double offset);

/// Equality of everything but the notes; coordinates up to an absolute tolerance.
void expectSameMesh(const Mesh& a, const Mesh& b, double tolerance = 0.0);

} // namespace ndframe::test
