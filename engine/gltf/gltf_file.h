// glTF 2.0 files: writes scenes as one binary file (.glb) and reads models as plain triangles. Not for the haptic
// thread. The caller defines the unit of length. Colours are sRGB, 0 to 1.
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

/// The geometry of a model: triangles with all transforms applied, three corners each.
struct SolidModel {
  struct Corner {
    glm::vec3 place{0.0f}, normal{0.0f};  ///< position and unit normal
    glm::vec3 colour{1.0f};
  };
  std::vector<Corner> corners;
  glm::vec3 low{0.0f}, high{0.0f};  ///< bounding box
};

/// Limit on the triangles of a model, so that it can be drawn without a graphics card.
inline constexpr std::size_t kMaxModelTriangles = 50000;

/// Reads the default scene of a .glb or .gltf file: triangles, transforms and base colours. Textures, animations and
/// cameras are ignored. Corners without a normal get that of their triangle. Returns a Problem if the file is
/// unreadable, violates the format or contains no triangles.
Expected<SolidModel> readGltf(const std::filesystem::path& file);

struct GltfMaterial {
  std::string name;
  glm::vec3 colour{1.0f};
  float opacity = 1.0f;
};
/// Triangles of one material: three indices each into the mesh's vertices.
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
  std::size_t mesh = kNone;    ///< none: a group
  std::size_t parent = kNone;  ///< index of an earlier node; none: a root of the scene
  glm::vec3 place{0.0f};       ///< translation relative to the parent
  float scale = 1.0f;
};
/// A scene to write. Meshes with equal vertices share them in the file.
struct GltfScene {
  std::string title;
  std::vector<std::pair<std::string, std::string>> notes;  ///< written as the asset's extras
  std::vector<GltfMaterial> materials;
  std::vector<GltfMesh> meshes;
  std::vector<GltfNode> nodes;
};

/// Writes a binary glTF file. Returns a Problem on failure. All indices of the scene must be valid.
std::optional<Problem> writeGlb(const std::filesystem::path& file, const GltfScene& scene);

}  // namespace moltact
