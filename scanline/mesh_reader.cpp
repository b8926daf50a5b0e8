#include "scanline/mesh_reader.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <new>
#include <optional>

#include "scanline/error.h"
#include "scanline/mesh_checks.h"
#include "scanline/text_reader.h"

namespace scanline {
namespace {

std::string lower_suffix(const std::filesystem::path& path) {
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  return suffix;
}

/// Goes through Assimp's tree of nodes and gathers all meshes in the coordinates of the file.
class SceneGatherer {
 public:
  SceneGatherer(const aiScene& scene, std::string file)
      : scene_(scene), file_(std::move(file)), has_(present(scene)), mesh_(attributes()) {}

  Mesh gather() {
    visit(*scene_.mRootNode, glm::dmat4(1));
    Mesh mesh = mesh_.take();
    if (mesh.polygons.empty()) fail("no polygon with an area in this file");
    return mesh;
  }

 private:
  /// Which attributes any mesh of the file has; the others get zeros.
  struct Present {
    bool normal = false, color = false;
    int uv = 0;
  };

  static Present present(const aiScene& scene) {
    Present p;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
      const aiMesh& mesh = *scene.mMeshes[m];
      p.normal |= mesh.HasNormals();
      p.color |= mesh.HasVertexColors(0);
      if (mesh.HasTextureCoords(0)) p.uv = std::max(p.uv, std::clamp(static_cast<int>(mesh.mNumUVComponents[0]), 2, 3));
    }
    return p;
  }

  std::vector<MeshBuilder::Attribute> attributes() const {
    std::vector<MeshBuilder::Attribute> list;
    if (has_.normal) list.push_back({"normal", 3});
    if (has_.uv > 0) list.push_back({"uv", has_.uv});
    if (has_.color) list.push_back({"color", 4});
    return list;
  }

  [[noreturn]] void fail(const std::string& message) const { throw UserError({file_, 0, 0, message}); }

  void visit(const aiNode& node, const glm::dmat4& parent) {
    const aiMatrix4x4& m = node.mTransformation;
    const glm::dmat4 matrix = parent * glm::dmat4(m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3,
                                                  m.d3, m.a4, m.b4, m.c4, m.d4);
    for (unsigned k = 0; k < node.mNumMeshes; ++k) {
      if (node.mMeshes[k] >= scene_.mNumMeshes) fail("a part of the file names a mesh that is not there");
      add(*scene_.mMeshes[node.mMeshes[k]], matrix);
    }
    for (unsigned k = 0; k < node.mNumChildren; ++k) visit(*node.mChildren[k], matrix);
  }

  void add(const aiMesh& mesh, const glm::dmat4& matrix) {
    const double determinant = glm::determinant(glm::dmat3(matrix));
    const glm::dmat3 normal_matrix =
        determinant == 0 ? glm::dmat3(1) : glm::transpose(glm::inverse(glm::dmat3(matrix)));
    std::vector<std::uint32_t> vertices;
    vertices.reserve(mesh.mNumVertices);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& p = mesh.mVertices[v];
      const glm::dvec3 position(matrix * glm::dvec4(p.x, p.y, p.z, 1));
      for (int k = 0; k < 3; ++k) {
        if (!std::isfinite(position[k])) {
          fail("vertex " + std::to_string(v + 1) + " of mesh '" + mesh.mName.C_Str() +
               "' has a coordinate that is not finite");
        }
      }
      vertices.push_back(mesh_.vertex(position));
    }
    std::vector<std::uint32_t> polygon;
    std::vector<double> values;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices < 3) fail("a polygon needs at least three vertices; the file holds points or lines");
      polygon.clear();
      values.clear();
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        // A mirroring node turns polygons inside out: their order is reversed to keep the front outside.
        const unsigned v = face.mIndices[determinant < 0 ? face.mNumIndices - 1 - k : k];
        if (v >= mesh.mNumVertices) fail("a polygon names a vertex that is not there");
        polygon.push_back(vertices[v]);
        add_values(mesh, v, normal_matrix, values);
      }
      mesh_.polygon(polygon, values);
    }
  }

  void add_values(const aiMesh& mesh, unsigned v, const glm::dmat3& normal_matrix, std::vector<double>& values) const {
    const std::size_t begin = values.size();
    if (has_.normal) {
      const aiVector3D n = mesh.HasNormals() ? mesh.mNormals[v] : aiVector3D();
      const glm::dvec3 normal = normal_matrix * glm::dvec3(n.x, n.y, n.z);
      values.insert(values.end(), {normal.x, normal.y, normal.z});
    }
    if (has_.uv > 0) {
      const aiVector3D uv = mesh.HasTextureCoords(0) ? mesh.mTextureCoords[0][v] : aiVector3D();
      values.insert(values.end(), {uv.x, uv.y});
      if (has_.uv > 2) values.push_back(uv.z);
    }
    if (has_.color) {
      const aiColor4D c = mesh.HasVertexColors(0) ? mesh.mColors[0][v] : aiColor4D();
      values.insert(values.end(), {c.r, c.g, c.b, c.a});
    }
    for (std::size_t k = begin; k < values.size(); ++k) {
      if (!std::isfinite(values[k])) values[k] = 0;
    }
  }

  const aiScene& scene_;
  std::string file_;
  Present has_;
  MeshBuilder mesh_;
};

/// `text`: what the library is to read instead of the file itself.
Mesh read_with_assimp(const std::filesystem::path& path, const std::optional<std::string>& text) {
  Assimp::Importer importer;
  const aiScene* scene =
      text ? importer.ReadFileFromMemory(text->data(), text->size(), 0, "obj") : importer.ReadFile(path.string(), 0);
  if (!scene || !scene->mRootNode) throw UserError({path.string(), 0, 0, importer.GetErrorString()});
  return SceneGatherer(*scene, path.string()).gather();
}

}  // namespace

Mesh read_mesh_file(const std::filesystem::path& path) {
  const std::string suffix = lower_suffix(path);
  const std::string text = read_text_file(path);
  if (text.empty()) throw UserError({path.string(), 0, 0, "the file is empty"});
  if (suffix == ".off") return read_off(text, path.string());
  if (suffix != ".obj" && suffix != ".ply" && suffix != ".stl" && suffix != ".gltf" && suffix != ".glb") {
    throw UserError(
        {path.string(), 0, 0, "unknown kind of mesh '" + suffix + "' (known: .obj, .off, .ply, .stl, .gltf, .glb)"});
  }
  if (suffix == ".ply") check_ply(text, path.string());
  if (suffix == ".stl") check_stl(text, path.string());
  std::optional<std::string> checked;
  if (suffix == ".obj") checked = check_obj(text, path.string());
  try {
    return read_with_assimp(path, checked);
  } catch (const std::bad_alloc&) {
    throw UserError({path.string(), 0, 0, "the file announces more data than there is memory"});
  }
}

}  // namespace scanline
