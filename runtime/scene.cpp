#include "runtime/scene.h"

#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/one_line.h"
#include "runtime/scene_precheck.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <mutex>
#include <string_view>
#include <utility>

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/Logger.hpp>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace gnomon {
namespace {

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Assimp drops glTF triangles whose indices are out of range, and only its log says so.
class IndexWatch : public Assimp::Logger {
public:
    explicit IndexWatch(bool& out_of_range) : out_of_range_(out_of_range) {}
    bool attachStream(Assimp::LogStream*, unsigned) override { return false; }
    bool detachStream(Assimp::LogStream*, unsigned) override { return false; }

private:
    void OnVerboseDebug(const char*) override {}
    void OnDebug(const char*) override {}
    void OnInfo(const char*) override {}
    void OnWarn(const char* message) override {
        if (std::string_view(message).find("out-of-range indices") != std::string_view::npos)
            out_of_range_ = true;
    }
    void OnError(const char*) override {}

    bool& out_of_range_;
};

/// Assimp has one logger for the whole process.
struct LoggerInUse {
    explicit LoggerInUse(Assimp::Logger* owned) { Assimp::DefaultLogger::set(owned); }
    ~LoggerInUse() { Assimp::DefaultLogger::set(nullptr); } // deletes it
    LoggerInUse(const LoggerInUse&) = delete;
    LoggerInUse& operator=(const LoggerInUse&) = delete;
};

/// A file that the reader of its extension does not want Assimp gives to any other that likes its beginning;
/// some of these read past its end. They are moved to `others`, which frees them.
void keep_readers_of(std::string_view extension, Assimp::Importer& importer, Assimp::Importer& others) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        const aiImporterDesc* about = importer.GetImporterInfo(i);
        const std::string extensions = fmt::format(" {} ", about ? about->mFileExtensions : "");
        if (extensions.find(fmt::format(" {} ", extension)) != extensions.npos) continue;
        Assimp::BaseImporter* reader = importer.GetImporter(i);
        if (importer.UnregisterLoader(reader) == aiReturn_SUCCESS) others.RegisterLoader(reader);
    }
}

/// The file as Assimp reads it, before any post-processing.
const aiScene& import(Assimp::Importer& importer, const std::filesystem::path& path) {
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    bool out_of_range = false;
    const LoggerInUse logger(new IndexWatch(out_of_range));
    Assimp::Importer others;
    keep_readers_of(lower_case(path.extension().string()).substr(1), importer, others);
    const aiScene* imported = importer.ReadFile(path.string(), 0);

    if (out_of_range) throw Error("'{}': a triangle uses a vertex that does not exist", path.string());
    if (imported == nullptr)
        throw Error("'{}' cannot be read as a model: {}", path.string(), one_line(importer.GetErrorString()));
    if (imported->mRootNode == nullptr) throw Error("'{}' has no triangles", path.string());
    return *imported;
}

glm::dvec3 to_glm(const aiVector3D& v) { return {v.x, v.y, v.z}; }

glm::dmat4 to_glm(const aiMatrix4x4& m) {
    return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

bool is_coordinates(glm::dvec3 p) {
    return std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate &&
           std::abs(p.z) <= max_coordinate;
}

void check_position(glm::dvec3 p, std::size_t vertex, const aiMesh& mesh, const std::string& file) {
    if (is_coordinates(p)) return;
    throw Error(
        "'{}': vertex {} (counted from 0) of mesh '{}' is at ({:g}, {:g}, {:g}): coordinates must be finite "
        "numbers up to {:g}",
        file, vertex, one_line(mesh.mName.C_Str()), p.x, p.y, p.z, max_coordinate);
}

/// What triangulation relies on.
void check_mesh(const aiMesh& mesh, const std::string& file) {
    for (std::size_t i = 0; i < mesh.mNumVertices; ++i)
        check_position(to_glm(mesh.mVertices[i]), i, mesh, file);
    const std::string name = one_line(mesh.mName.C_Str());
    for (std::size_t i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices == 0)
            throw Error("'{}': face {} (counted from 0) of mesh '{}' has no vertices", file, i, name);
        for (std::size_t k = 0; k < face.mNumIndices; ++k)
            if (face.mIndices[k] >= mesh.mNumVertices)
                throw Error("'{}': face {} (counted from 0) of mesh '{}' uses vertex {}, but there are {}",
                            file, i, name, face.mIndices[k], mesh.mNumVertices);
    }
}

struct Mended {
    std::size_t zero_area = 0;
    std::size_t without_normal = 0;
};

glm::dvec3 area_vector(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 origin(a);
    return glm::cross(glm::dvec3(b) - origin, glm::dvec3(c) - origin);
}

/// Zero if `v` has no direction.
glm::vec3 unit(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0f);
}

/// The matrix for normals: also right where the transform mirrors, and defined where it flattens.
glm::dmat3 normal_matrix(const glm::dmat3& m) {
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return glm::determinant(m) < 0 ? -cofactors : cofactors;
}

std::uint32_t add_vertex(Scene& scene, glm::vec3 position, glm::vec3 normal) {
    if (scene.positions.size() >= unused) throw Error("'{}' has more than {} vertices", scene.name, unused);
    scene.positions.push_back(position);
    scene.normals.push_back(normal);
    return static_cast<std::uint32_t>(scene.positions.size() - 1);
}

void append_mesh(const aiMesh& mesh, const glm::dmat4& to_world, const std::string& file, Scene& scene,
                 Mended& mended) {
    std::vector<glm::vec3> positions(mesh.mNumVertices);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::dvec3 p(to_world * glm::dvec4(to_glm(mesh.mVertices[i]), 1.0));
        check_position(p, i, mesh, file);
        positions[i] = glm::vec3(p);
    }
    const glm::dmat3 linear(to_world);
    const glm::dmat3 for_normals = normal_matrix(linear);
    const bool mirrored = glm::determinant(linear) < 0;
    std::vector<std::uint32_t> vertex_in_scene(positions.size(), unused);

    for (std::size_t i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices != 3) continue; // points and lines
        glm::uvec3 corners(face.mIndices[0], face.mIndices[1], face.mIndices[2]);
        if (mirrored) std::swap(corners.y, corners.z);
        const glm::dvec3 area = area_vector(positions[corners.x], positions[corners.y], positions[corners.z]);
        if (area == glm::dvec3(0.0)) {
            ++mended.zero_area;
            continue;
        }
        const glm::vec3 flat = unit(area);
        glm::uvec3 triangle;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t corner = corners[k];
            if (mesh.mNormals == nullptr) {
                triangle[k] = add_vertex(scene, positions[corner], flat);
                continue;
            }
            if (vertex_in_scene[corner] == unused) {
                glm::vec3 normal = unit(for_normals * to_glm(mesh.mNormals[corner]));
                if (normal == glm::vec3(0.0f)) {
                    normal = flat;
                    ++mended.without_normal;
                }
                vertex_in_scene[corner] = add_vertex(scene, positions[corner], normal);
            }
            triangle[k] = vertex_in_scene[corner];
        }
        scene.triangles.push_back(triangle);
    }
}

Scene flatten(const aiScene& imported, const std::string& file) {
    struct Visit {
        const aiNode* node;
        glm::dmat4 to_world;
    };
    Scene scene;
    Mended mended;
    std::vector<Visit> pending{{imported.mRootNode, to_glm(imported.mRootNode->mTransformation)}};
    while (!pending.empty()) {
        const Visit visit = pending.back();
        pending.pop_back();
        const aiNode& node = *visit.node;
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
            append_mesh(*imported.mMeshes[node.mMeshes[i]], visit.to_world, file, scene, mended);
        for (unsigned i = node.mNumChildren; i > 0;
             --i) { // reversed, so that they are taken in the file's order
            const aiNode* child = node.mChildren[i - 1];
            pending.push_back({child, visit.to_world * to_glm(child->mTransformation)});
        }
    }
    if (scene.triangles.empty())
        throw Error("'{}' has no triangles{}", file, mended.zero_area > 0 ? " of more than zero area" : "");
    if (mended.zero_area > 0)
        scene.warnings.push_back(
            fmt::format("'{}': {} triangles of zero area dropped", file, mended.zero_area));
    if (mended.without_normal > 0)
        scene.warnings.push_back(fmt::format("'{}': {} vertices without a normal got that of a triangle",
                                             file, mended.without_normal));
    return scene;
}

} // namespace

Box Scene::bounds() const {
    Box box;
    for (const glm::vec3& position : positions) box.include(position);
    return box;
}

Scene load_scene(const std::filesystem::path& path) {
    const std::string file = path.string();
    const std::string kind = lower_case(path.extension().string());
    const std::string bytes = read_file(path);
    if (kind != ".gltf" && kind != ".glb" && kind != ".obj" && kind != ".ply")
        throw Error("'{}' is of an unknown kind: use a .gltf, .glb, .obj or .ply file", file);
    if (bytes.empty()) throw Error("'{}' is empty", file);
    if (kind == ".ply") precheck_ply(path, bytes);
    if (kind == ".obj") precheck_obj(path, bytes);
    if (kind == ".glb") precheck_glb(path, bytes);
    if (kind == ".gltf") precheck_gltf(path, bytes);

    Assimp::Importer importer;
    const aiScene& imported = import(importer, path);
    for (unsigned i = 0; i < imported.mNumMeshes; ++i) check_mesh(*imported.mMeshes[i], file);
    const aiScene* triangulated = importer.ApplyPostProcessing(aiProcess_Triangulate);
    if (triangulated == nullptr)
        throw Error("'{}' cannot be triangulated: {}", file, one_line(importer.GetErrorString()));

    Scene scene = flatten(*triangulated, file);
    scene.name = path.stem().string();
    return scene;
}

} // namespace gnomon
