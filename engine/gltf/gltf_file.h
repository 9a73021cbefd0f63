// glTF 2.0 files: scenes written as one binary file (.glb), models read as plain triangles. Not for the haptic thread.
// Units of a file are its own: whoever writes or reads one says what a unit stands for. Colours are sRGB, 0 to 1.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// The drawable part of a model: triangles with all transforms applied, three corners each.
struct SolidModel {
  struct Corner {
    glm::vec3 place{0.0f}, normal{0.0f};  ///< the normal has length 1
    glm::vec3 colour{1.0f};
  };
  std::vector<Corner> corners;
  glm::vec3 low{0.0f}, high{0.0f};  ///< the box round it
};

/// A model may have so many triangles at most, so that it is drawn without a graphics card.
inline constexpr std::size_t kMaxModelTriangles = 50000;

/// Reads the default scene of a .glb or .gltf file: triangles, transforms and base colours; textures, animations and
/// cameras are passed over. Corners without a normal get their triangle's. A file that cannot be read, breaks the
/// format or holds no triangles gives a problem.
Expected<SolidModel> readGltf(const std::filesystem::path& file);

struct GltfMaterial {
  std::string name;
  glm::vec3 colour{1.0f};
  float opacity = 1.0f;
};
/// Triangles of one material: three indices each into the mesh's places.
struct GltfPart {
  std::vector<std::uint32_t> indices;
  std::size_t material = 0;
};
struct GltfMesh {
  std::string name;
  std::vector<glm::vec3> places, normals;  ///< of the same length
  std::vector<GltfPart> parts;
};
struct GltfNode {
  static constexpr std::size_t kNone = std::size_t(-1);
  std::string name;
  std::size_t mesh = kNone;    ///< none: it only holds others
  std::size_t parent = kNone;  ///< a node before it; none: stands in the scene itself
  glm::vec3 place{0.0f};       ///< relative to the parent
  float scale = 1.0f;
};
/// A scene to be written. Meshes with the same places and normals share them in the file.
struct GltfScene {
  std::string title;
  std::vector<std::pair<std::string, std::string>> notes;  ///< written as the asset's extras
  std::vector<GltfMaterial> materials;
  std::vector<GltfMesh> meshes;
  std::vector<GltfNode> nodes;
};

/// Writes a binary glTF file. Returns what went wrong, or nothing. The scene must be sound: indices within range.
std::optional<Problem> writeGlb(const std::filesystem::path& file, const GltfScene& scene);

}  // namespace moltact
