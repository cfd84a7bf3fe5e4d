// What a model file must satisfy before Assimp may have it: it reads past the end of a PLY file that is cut
// short, and repeats or drops what it cannot make sense of without a word.
#pragma once

#include <filesystem>
#include <string_view>

namespace gnomon {

/// Coordinates beyond this cannot be worked with in single precision: their squares and products overflow.
constexpr double max_coordinate = 1e15;

/// Reads every value of a PLY file. Throws Error naming the file and the vertex or face (counted from 0) that
/// is missing, not a finite number in range, or an index to no vertex; also if the file declares no faces.
void precheck_ply(const std::filesystem::path& path, std::string_view bytes);

/// Reads the vertex positions of an OBJ file. Throws Error naming the file, line and vertex (counted from 1)
/// that does not have three finite numbers in range.
void precheck_obj(const std::filesystem::path& path, std::string_view bytes);

/// Reads the chunk sizes of a binary glTF file. Throws Error naming the file if one reaches past its end:
/// Assimp allocates whatever they say. Then checks its JSON as precheck_gltf does.
void precheck_glb(const std::filesystem::path& path, std::string_view bytes);

/// Assimp follows nested JSON and nested nodes by recursion: throws Error naming the file if either is deeper
/// than 500 levels, if a node is its own ancestor, or a child more than once (the format wants trees); also
/// if the JSON is damaged or names a member twice, where Assimp may read another text than was checked.
void precheck_gltf(const std::filesystem::path& path, std::string_view json);

} // namespace gnomon
