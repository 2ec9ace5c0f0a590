/* OpenMesh's decimater with its quadrics. This file is a library of its own, which simplify.c
 * loads. */
#define NDEBUG /* OpenMesh's own assertions take most of its time */
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" /* its vectors are, where it makes room */
#endif
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <new>
#include <vector>

#include "pipeline/io/mesh/simplify.h"

namespace
{
struct Traits : OpenMesh::DefaultTraitsDouble {
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Decimater = OpenMesh::Decimater::DecimaterT<Mesh>;

/* Vertices keep their numbers. Triangles that do not fit go to `loose`. */
void build(const GpSimplifyInput &input, Mesh &mesh, std::vector<uint32_t> &loose)
{
    omerr().disable(); /* which would tell of each of them */
    mesh.reserve(input.vertex_count, 3 * input.vertex_count, input.triangle_count);
    for (uint32_t i = 0; i < input.vertex_count; i++) {
        const float *at = input.positions + 3 * size_t(i);
        mesh.add_vertex(Mesh::Point(at[0], at[1], at[2]));
    }
    for (uint32_t i = 0; i < input.triangle_count; i++) {
        const uint32_t *corner = input.indices + 3 * size_t(i);
        Mesh::VertexHandle face[3];
        for (int k = 0; k < 3; k++)
            face[k] = mesh.vertex_handle(corner[k]);
        if (!mesh.add_face(face, 3).is_valid())
            loose.insert(loose.end(), corner, corner + 3);
    }
    for (const auto &vertex : mesh.vertices())
        mesh.status(vertex).set_locked(mesh.is_boundary(vertex));
    for (const uint32_t number : loose)
        mesh.status(mesh.vertex_handle(number)).set_locked(true);
}

void decimate(const GpSimplifyInput &input, size_t loose, Mesh &mesh)
{
    Decimater decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<Mesh>::Handle flipping;
    decimater.add(quadric);
    decimater.add(flipping);
    decimater.module(quadric).unset_max_err();
    mesh.update_face_normals();
    if (decimater.initialize())
        decimater.decimate_to_faces(0, input.least_triangles > loose ? input.least_triangles - loose
                                                                     : 0);
}

void store(const Mesh &mesh, const std::vector<uint32_t> &loose, GpSimplified *simplified)
{
    std::vector<uint32_t> corners(loose), place(mesh.n_vertices(), 0);
    for (const auto &face : mesh.faces())
        for (const auto &vertex : mesh.fv_range(face))
            corners.push_back(uint32_t(vertex.idx()));
    for (const uint32_t number : corners)
        place[number] = 1;
    std::vector<uint32_t> vertices;
    for (size_t i = 0; i < place.size(); i++) {
        if (place[i] == 0)
            continue;
        place[i] = uint32_t(vertices.size());
        vertices.push_back(uint32_t(i));
    }
    simplified->vertices = static_cast<uint32_t *>(gp_alloc(vertices.size() + 1, sizeof(uint32_t)));
    simplified->indices = static_cast<uint32_t *>(gp_alloc(corners.size() + 1, sizeof(uint32_t)));
    if (!simplified->vertices || !simplified->indices)
        throw std::bad_alloc();
    std::copy(vertices.begin(), vertices.end(), simplified->vertices);
    for (size_t i = 0; i < corners.size(); i++)
        simplified->indices[i] = place[corners[i]];
    simplified->vertex_count = uint32_t(vertices.size());
    simplified->triangle_count = uint32_t(corners.size() / 3);
}
} // namespace

extern "C" __attribute__((visibility("default"))) GpResult
gp_mesh_openmesh(const GpSimplifyInput *input, GpSimplified *simplified)
{
    try {
        Mesh mesh;
        std::vector<uint32_t> loose;
        build(*input, mesh, loose);
        decimate(*input, loose.size() / 3, mesh);
        store(mesh, loose, simplified);
    } catch (const std::bad_alloc &) {
        return GP_ERROR_MEMORY;
    }
    return GP_OK;
}
