#include "engine/gltf/gltf_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <sstream>
// Included as a system header to suppress its warnings.
#include <tiny_gltf.h>

#include "engine/core/file_bytes.h"
#include "engine/language/catalogue.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxNodes = 10000, kMaxDepth = 64;
constexpr std::uintmax_t kMaxBytes = 64u << 20;

float toLinear(float s) { return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f); }
float toScreen(float l) { return l <= 0.0031308f ? l * 12.92f : 1.055f * std::pow(l, 1 / 2.4f) - 0.055f; }

// Aborts the reading; never leaves this file.
struct Broken {
  std::string why;
};

class Reader {
 public:
  explicit Reader(const tinygltf::Model& model) : model_(model) {}

  SolidModel read() {
    if (model_.scenes.empty()) throw Broken{tr("the model has no scene")};
    const std::size_t scene = model_.defaultScene < 0 ? 0 : std::size_t(model_.defaultScene);
    if (scene >= model_.scenes.size()) throw Broken{tr("the model names a scene that it does not hold")};
    for (const int node : model_.scenes[scene].nodes) visit(node, glm::mat4(1.0f), 0);
    if (out_.corners.empty()) throw Broken{tr("the model holds no triangles")};
    out_.low = out_.high = out_.corners.front().place;
    for (const SolidModel::Corner& c : out_.corners) {
      out_.low = glm::min(out_.low, c.place);
      out_.high = glm::max(out_.high, c.place);
    }
    return std::move(out_);
  }

 private:
  template <class T>
  const T& at(const std::vector<T>& all, int index, const char* otherwise) const {
    if (index < 0 || std::size_t(index) >= all.size()) throw Broken{tr(otherwise)};
    return all[std::size_t(index)];
  }

  static glm::mat4 placeOf(const tinygltf::Node& n) {
    if (n.matrix.size() == 16) return glm::mat4(glm::make_mat4(n.matrix.data()));
    glm::dmat4 m(1.0);
    if (n.translation.size() == 3) m = glm::translate(m, glm::make_vec3(n.translation.data()));
    if (n.rotation.size() == 4)
      m *= glm::mat4_cast(glm::dquat(n.rotation[3], n.rotation[0], n.rotation[1], n.rotation[2]));
    if (n.scale.size() == 3) m = glm::scale(m, glm::make_vec3(n.scale.data()));
    return glm::mat4(m);
  }

  void visit(int index, const glm::mat4& parent, std::size_t depth) {
    if (++visited_ > kMaxNodes || depth > kMaxDepth) throw Broken{tr("the model has nodes within nodes without end")};
    const tinygltf::Node& node = at(model_.nodes, index, N_("the model names a node that it does not hold"));
    const glm::mat4 place = parent * placeOf(node);
    if (node.mesh >= 0)
      for (const tinygltf::Primitive& p :
           at(model_.meshes, node.mesh, N_("the model names a mesh that it does not hold")).primitives)
        add(p, place);
    for (const int child : node.children) visit(child, place, depth + 1);
  }

  // Element `i` is stored at data + i * stride; all elements are within the buffer.
  struct Elements {
    const unsigned char* data = nullptr;
    std::size_t stride = 0, count = 0;
    int type = 0;
  };
  Elements elementsOf(int index, int shape) const {
    const tinygltf::Accessor& a =
        at(model_.accessors, index, N_("the model names a list of numbers that it does not hold"));
    if (a.sparse.isSparse) throw Broken{tr("the model holds sparse lists of numbers, which are not read")};
    const tinygltf::BufferView& v =
        at(model_.bufferViews, a.bufferView, N_("the model names a view of a buffer that it does not hold"));
    const tinygltf::Buffer& b = at(model_.buffers, v.buffer, N_("the model names a buffer that it does not hold"));
    const int component = tinygltf::GetComponentSizeInBytes(std::uint32_t(a.componentType)),
              parts = tinygltf::GetNumComponentsInType(std::uint32_t(a.type));
    const int stride = a.ByteStride(v);
    if (a.type != shape || component <= 0 || parts <= 0 || stride < component * parts)
      throw Broken{tr("the model holds numbers of the wrong kind")};
    const std::size_t size = std::size_t(component * parts);
    const bool fits = a.count > 0 && v.byteOffset <= b.data.size() && v.byteLength <= b.data.size() - v.byteOffset &&
                      a.byteOffset <= v.byteLength && size <= v.byteLength - a.byteOffset &&
                      a.count - 1 <= (v.byteLength - a.byteOffset - size) / std::size_t(stride);
    if (!fits) throw Broken{tr("the model ends before its lists of numbers do")};
    return {b.data.data() + v.byteOffset + a.byteOffset, std::size_t(stride), a.count, a.componentType};
  }

  static glm::vec3 vectorAt(const Elements& e, std::size_t i) {
    const unsigned char* at = e.data + i * e.stride;
    return {numberAt<float>(at), numberAt<float>(at + sizeof(float)), numberAt<float>(at + 2 * sizeof(float))};
  }
  static std::size_t indexAt(const Elements& e, std::size_t i) {
    const unsigned char* at = e.data + i * e.stride;
    if (e.type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *at;
    if (e.type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return numberAt<std::uint16_t>(at);
    if (e.type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) return numberAt<std::uint32_t>(at);
    throw Broken{tr("the model holds numbers of the wrong kind")};
  }

  void add(const tinygltf::Primitive& p, const glm::mat4& to_scene) {
    if (p.mode != TINYGLTF_MODE_TRIANGLES)
      throw Broken{tr("the model holds lines, points or strips; only lists of triangles are read")};
    const auto attribute = [&](const char* name) {
      const auto it = p.attributes.find(name);
      return it == p.attributes.end() ? -1 : it->second;
    };
    if (attribute("POSITION") < 0) throw Broken{tr("the model holds triangles without places (are they compressed?)")};
    const Elements places = elementsOf(attribute("POSITION"), TINYGLTF_TYPE_VEC3);
    Elements normals, indices;
    if (attribute("NORMAL") >= 0) normals = elementsOf(attribute("NORMAL"), TINYGLTF_TYPE_VEC3);
    if (p.indices >= 0) indices = elementsOf(p.indices, TINYGLTF_TYPE_SCALAR);
    if (places.type != TINYGLTF_COMPONENT_TYPE_FLOAT || (normals.data && normals.type != TINYGLTF_COMPONENT_TYPE_FLOAT))
      throw Broken{tr("the model holds numbers of the wrong kind")};
    const std::size_t count = (indices.data ? indices.count : places.count) / 3 * 3;
    if (out_.corners.size() + count > 3 * kMaxModelTriangles)
      throw Broken{trf("the model has more than {0} triangles", kMaxModelTriangles)};
    glm::vec3 colour(1.0f);
    if (p.material >= 0) {
      const auto& factor = at(model_.materials, p.material, N_("the model names a material that it does not hold"))
                               .pbrMetallicRoughness.baseColorFactor;
      if (factor.size() >= 3)
        for (int k = 0; k < 3; ++k) colour[k] = toScreen(std::clamp(float(factor[std::size_t(k)]), 0.0f, 1.0f));
    }
    const glm::mat3 turn = glm::transpose(glm::inverse(glm::mat3(to_scene)));
    for (std::size_t i = 0; i < count; i += 3) {
      std::array<SolidModel::Corner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t vertex = indices.data ? indexAt(indices, i + k) : i + k;
        if (vertex >= places.count || (normals.data && vertex >= normals.count))
          throw Broken{tr("the model names corners that it does not hold")};
        corners[k].place = glm::vec3(to_scene * glm::vec4(vectorAt(places, vertex), 1.0f));
        if (normals.data) corners[k].normal = turn * vectorAt(normals, vertex);
        corners[k].colour = colour;
        if (!std::isfinite(glm::dot(corners[k].place, glm::vec3(1.0f))))
          throw Broken{tr("the model holds places that are no numbers")};
      }
      const glm::vec3 face = glm::cross(corners[1].place - corners[0].place, corners[2].place - corners[0].place);
      for (SolidModel::Corner& c : corners) {
        if (!(glm::dot(c.normal, c.normal) > 1e-20f)) c.normal = face;
        const float length = glm::length(c.normal);
        c.normal = length > 0 ? c.normal / length : glm::vec3(0, 1, 0);
      }
      out_.corners.insert(out_.corners.end(), corners.begin(), corners.end());
    }
  }

  const tinygltf::Model& model_;
  SolidModel out_;
  std::size_t visited_ = 0;
};

// Textures are ignored and not decoded.
bool passOver(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

class Writer {
 public:
  explicit Writer(const GltfScene& scene) : scene_(scene) {
    model_.buffers.emplace_back();
    model_.asset.version = "2.0";
    model_.asset.generator = "Moltact";
    if (!scene.notes.empty()) {
      tinygltf::Value::Object notes;
      for (const auto& [key, value] : scene.notes) notes.emplace(key, tinygltf::Value(value));
      model_.asset.extras = tinygltf::Value(notes);
    }
    for (const GltfMaterial& m : scene.materials) addMaterial(m);
    for (const GltfMesh& m : scene.meshes) addMesh(m);
    addNodes();
  }
  tinygltf::Model& model() { return model_; }

 private:
  void addMaterial(const GltfMaterial& m) {
    tinygltf::Material out;
    out.name = m.name;
    out.pbrMetallicRoughness.baseColorFactor = {toLinear(m.colour.x), toLinear(m.colour.y), toLinear(m.colour.z),
                                                double(m.opacity)};
    if (m.opacity < 1.0f) out.alphaMode = "BLEND";
    out.pbrMetallicRoughness.metallicFactor = 0.0;
    out.pbrMetallicRoughness.roughnessFactor = 0.6;
    model_.materials.push_back(std::move(out));
  }

  template <class T>
  int addList(const std::vector<T>& values, int component, int type, int target) {
    auto& bytes = model_.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes.size();
    view.byteLength = values.size() * sizeof(T);
    view.target = target;
    bytes.resize(bytes.size() + view.byteLength);
    std::memcpy(bytes.data() + view.byteOffset, values.data(), view.byteLength);
    model_.bufferViews.push_back(std::move(view));
    tinygltf::Accessor list;
    list.bufferView = int(model_.bufferViews.size()) - 1;
    list.componentType = component;
    list.type = type;
    list.count = values.size();
    model_.accessors.push_back(std::move(list));
    return int(model_.accessors.size()) - 1;
  }

  // Meshes of the same shape with other materials share their arrays.
  const std::array<int, 2>& listsOf(const GltfMesh& m) {
    for (const auto& [mesh, lists] : lists_)
      if (mesh->places == m.places && mesh->normals == m.normals) return lists;
    const int places =
        addList(m.places, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
    glm::vec3 low = m.places.front(), high = low;
    for (const glm::vec3& p : m.places) low = glm::min(low, p), high = glm::max(high, p);
    model_.accessors.back().minValues = {low.x, low.y, low.z};
    model_.accessors.back().maxValues = {high.x, high.y, high.z};
    const int normals =
        addList(m.normals, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
    lists_.push_back({&m, {places, normals}});
    return lists_.back().second;
  }

  int indicesOf(const std::vector<std::uint32_t>& indices) {
    for (const auto& [known, list] : index_lists_)
      if (*known == indices) return list;
    const int list = addList(indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                             TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    index_lists_.push_back({&indices, list});
    return list;
  }

  void addMesh(const GltfMesh& m) {
    tinygltf::Mesh out;
    out.name = m.name;
    const std::array<int, 2> lists = listsOf(m);
    for (const GltfPart& part : m.parts) {
      tinygltf::Primitive p;
      p.attributes = {{"POSITION", lists[0]}, {"NORMAL", lists[1]}};
      p.indices = indicesOf(part.indices);
      p.material = int(part.material);
      p.mode = TINYGLTF_MODE_TRIANGLES;
      out.primitives.push_back(std::move(p));
    }
    model_.meshes.push_back(std::move(out));
  }

  void addNodes() {
    tinygltf::Scene scene;
    scene.name = scene_.title;
    for (std::size_t k = 0; k < scene_.nodes.size(); ++k) {
      const GltfNode& n = scene_.nodes[k];
      tinygltf::Node out;
      out.name = n.name;
      if (n.mesh != GltfNode::kNone) out.mesh = int(n.mesh);
      if (n.place != glm::vec3(0.0f)) out.translation = {n.place.x, n.place.y, n.place.z};
      if (n.scale != 1.0f) out.scale = {n.scale, n.scale, n.scale};
      model_.nodes.push_back(std::move(out));
      if (n.parent == GltfNode::kNone)
        scene.nodes.push_back(int(k));
      else
        model_.nodes[n.parent].children.push_back(int(k));
    }
    model_.scenes.push_back(std::move(scene));
    model_.defaultScene = 0;
  }

  const GltfScene& scene_;
  tinygltf::Model model_;
  std::vector<std::pair<const GltfMesh*, std::array<int, 2>>> lists_;
  std::vector<std::pair<const std::vector<std::uint32_t>*, int>> index_lists_;
};

}  // namespace

Expected<SolidModel> readGltf(const std::filesystem::path& file) {
  const auto problem = [&](const std::string& message,
                           const std::string& remedy = tr("give a glTF 2.0 file (.glb or .gltf) with triangles")) {
    return Problem{.file = file.string(), .message = message, .remedy = remedy};
  };
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  std::array<char, 4> magic{};
  if (error || !in) return problem(tr("the model cannot be read"), tr("check its name, and whether you may read it"));
  if (bytes > kMaxBytes) return problem(tr("the model is larger than 64 MB"), tr("give a simpler model"));
  in.read(magic.data(), 4);
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(&passOver, nullptr);
  tinygltf::Model model;
  std::string why, warning;
  try {
    const bool binary = std::string_view(magic.data(), 4) == "glTF";
    const bool read = binary ? loader.LoadBinaryFromFile(&model, &why, &warning, file.string())
                             : loader.LoadASCIIFromFile(&model, &why, &warning, file.string());
    if (!read) {
      why.erase(std::remove(why.begin(), why.end(), '\n'), why.end());
      return problem(why.empty() ? tr("the model is no sound glTF file")
                                 : trf("the model is no sound glTF file: {0}", why));
    }
    return Reader(model).read();
  } catch (const Broken& broken) {
    return problem(broken.why);
  } catch (const std::exception& e) {  // thrown by the parser for an invalid file
    return problem(trf("the model is no sound glTF file: {0}", e.what()));
  }
}

std::optional<Problem> writeGlb(const std::filesystem::path& file, const GltfScene& scene) {
  Writer writer(scene);
  std::ostringstream out;
  tinygltf::TinyGLTF saver;
  if (!saver.WriteGltfSceneToStream(&writer.model(), out, false, true) || !out)
    return Problem{.file = file.string(),
                   .message = tr("the scene is too large for a glTF file"),
                   .remedy = tr("take a smaller molecule, or a coarser surface")};
  return writeWhole(file, out.str());
}

}  // namespace moltact
