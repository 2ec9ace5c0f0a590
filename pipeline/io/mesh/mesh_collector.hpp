/* What OpenMesh's readers hand over, kept as triangles.
 *
 * A reader hands vertices and faces to an importer. OpenMesh's own builds half-edges and drops what
 * is not manifold; this one only collects. It trusts nothing: the check ran before, but handles out
 * of range are still refused here, by an exception.
 */
#ifndef GP_IO_MESH_COLLECTOR_HPP
#define GP_IO_MESH_COLLECTOR_HPP

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/Mesh/BaseKernel.hh>

#include <stdexcept>
#include <vector>

extern "C" {
#include "pipeline/io/mesh/mesh_check.h"
}

namespace
{
using namespace OpenMesh;

/* Normal and texture coordinates of a corner. */
struct Attributes {
    Vec3f normal{ 0, 0, 0 };
    Vec2f texcoord{ 0, 0 };

    bool operator==(const Attributes &other) const
    {
        return normal == other.normal && texcoord == other.texcoord;
    }
};

struct Vertex {
    Vec3f position{ 0, 0, 0 };
    Vec4f color{ 1, 1, 1, 1 };
    Attributes attributes;
    bool is_used = false; /* by a face: the attributes are settled */
    int next_copy = -1;   /* the same vertex with other attributes */
};

struct Halfedge {
    int to = -1, next = -1;
};

class Collector : public IO::BaseImporter
{
  public:
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices; /* of triangles */
    size_t face_count = 0;

    explicit Collector(const GpMeshSource &source)
        : file_vertices_(source.vertex_count), latest_(source.vertex_count)
    {
        bool is_stl = source.format == GP_MESH_STL; /* welding leaves about a sixth */
        vertices.reserve(is_stl ? source.vertex_count / 6 : source.vertex_count);
        indices.reserve(3 * source.face_count);
    }

    VertexHandle add_vertex(const Vec3f &point) override
    {
        if (vertices.size() >= file_vertices_)
            throw std::runtime_error("more vertices than the file has");
        vertices.emplace_back();
        vertices.back().position = point;
        return VertexHandle(int(vertices.size() - 1));
    }

    VertexHandle add_vertex() override
    {
        return add_vertex(Vec3f(0, 0, 0));
    }
    using BaseImporter::add_vertex;

    void set_point(VertexHandle v, const Vec3f &point) override
    {
        vertices[check(v)].position = point;
    }

    FaceHandle add_face(const VHandles &handles) override
    {
        if (handles.size() < 3)
            throw std::runtime_error("a face with fewer than three corners");
        uint32_t first = corner(handles[0]), previous = corner(handles[1]);
        for (size_t i = 2; i < handles.size(); i++) {
            uint32_t last = corner(handles[i]);
            indices.insert(indices.end(), { first, previous, last });
            previous = last;
        }
        return FaceHandle(int(face_count++));
    }

    /* --- attributes: OBJ sets them before each face, for its corners -------------------------- */

    void set_normal(VertexHandle v, const Vec3f &normal) override
    {
        latest_[check(v)].normal = normal;
        keep_latest(v);
    }

    void set_normal(VertexHandle v, const Vec3d &normal) override
    {
        set_normal(v, Vec3f(normal));
    }

    void set_texcoord(VertexHandle v, const Vec2f &texcoord) override
    {
        latest_[check(v)].texcoord = texcoord;
        keep_latest(v);
    }

    void set_color(VertexHandle v, const Vec4f &color) override
    {
        vertices[check(v)].color = color;
    }

    void set_color(VertexHandle v, const Vec3f &color) override
    {
        set_color(v, Vec4f(color[0], color[1], color[2], 1));
    }

    void set_color(VertexHandle v, const Vec4uc &color) override
    {
        set_color(
            v, Vec4f(color[0] / 255.0f, color[1] / 255.0f, color[2] / 255.0f, color[3] / 255.0f));
    }

    void set_color(VertexHandle v, const Vec3uc &color) override
    {
        set_color(v, Vec4uc(color[0], color[1], color[2], 255));
    }

    /* --- half-edges: only OM files have them --------------------------------------------------- */

    /* The pair of half-edges to: and from: gets the next two numbers. */
    HalfedgeHandle add_edge(VertexHandle from, VertexHandle to) override
    {
        halfedges_.resize(halfedges_.size() + 2);
        halfedges_[halfedges_.size() - 2].to = int(check(to));
        halfedges_[halfedges_.size() - 1].to = int(check(from));
        return HalfedgeHandle(int(halfedges_.size() - 2));
    }

    void set_next(HalfedgeHandle h, HalfedgeHandle next) override
    {
        halfedges_.at(size_t(h.idx())).next = next.idx();
    }

    FaceHandle add_face(HalfedgeHandle h) override
    {
        starts_.push_back(h.idx());
        return FaceHandle(int(starts_.size() - 1));
    }

    /* Walks around every face once the half-edges are there. OpenMesh starts a face at the edge
     * that ends in its first corner. All walks together take each half-edge once in a valid file,
     * so a longer one is caught in a loop. */
    void resolve_faces()
    {
        VHandles corners;
        size_t steps = 0;
        for (int start : starts_) {
            corners.clear();
            int at = start;
            do {
                const Halfedge &halfedge = halfedges_.at(size_t(at));
                if (++steps > halfedges_.size())
                    throw std::runtime_error("a face whose half-edges do not close");
                corners.emplace_back(halfedge.to);
                at = halfedge.next;
            } while (at != start);
            add_face(corners);
        }
    }

    BaseKernel *kernel() override
    {
        return &kernel_; /* the OM reader wants one to look up custom properties */
    }

    size_t n_vertices() const override
    {
        return vertices.size();
    }

    size_t n_faces() const override
    {
        return face_count;
    }

    size_t n_edges() const override
    {
        return halfedges_.size() / 2;
    }

    /* --- what a mesh here has no place for ------------------------------------------------------ */

    using Status = OpenMesh::Attributes::StatusInfo;
    /* clang-format off */
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f> &) override {}
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f> &) override {}
    void set_face_texindex(FaceHandle, int) override {}
    void set_halfedge(VertexHandle, HalfedgeHandle) override {}
    void set_face(HalfedgeHandle, FaceHandle) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(HalfedgeHandle, const Vec2f &) override {}
    void set_texcoord(VertexHandle, const Vec3f &) override {}
    void set_texcoord(HalfedgeHandle, const Vec3f &) override {}
    void set_status(VertexHandle, const Status &) override {}
    void set_status(HalfedgeHandle, const Status &) override {}
    void set_status(EdgeHandle, const Status &) override {}
    void set_status(FaceHandle, const Status &) override {}
    void set_color(EdgeHandle, const Vec3uc &) override {}
    void set_color(EdgeHandle, const Vec4uc &) override {}
    void set_color(EdgeHandle, const Vec3f &) override {}
    void set_color(EdgeHandle, const Vec4f &) override {}
    void set_normal(FaceHandle, const Vec3f &) override {}
    void set_normal(FaceHandle, const Vec3d &) override {}
    void set_color(FaceHandle, const Vec3uc &) override {}
    void set_color(FaceHandle, const Vec4uc &) override {}
    void set_color(FaceHandle, const Vec3f &) override {}
    void set_color(FaceHandle, const Vec4f &) override {}
    void add_texture_information(int, std::string) override {}
    /* clang-format on */

  private:
    size_t file_vertices_;
    std::vector<Attributes> latest_; /* set last, of the file's vertices */
    std::vector<Halfedge> halfedges_;
    std::vector<int> starts_; /* one half-edge of every face */
    BaseKernel kernel_;

    size_t check(VertexHandle v) const
    {
        if (v.idx() < 0 || size_t(v.idx()) >= vertices.size() || size_t(v.idx()) >= file_vertices_)
            throw std::runtime_error("a vertex out of range");
        return size_t(v.idx());
    }

    void keep_latest(VertexHandle v)
    {
        Vertex &vertex = vertices[check(v)];
        if (!vertex.is_used)
            vertex.attributes = latest_[size_t(v.idx())];
    }

    /* The vertex with the latest attributes of v: v itself, a copy made earlier, or a new one. */
    uint32_t corner(VertexHandle v)
    {
        size_t at = check(v);
        const Attributes &wanted = latest_[at];
        while (vertices[at].is_used && !(vertices[at].attributes == wanted)) {
            if (vertices[at].next_copy < 0) {
                Vertex copy = vertices[at];
                copy.attributes = wanted;
                vertices[at].next_copy = int(vertices.size());
                vertices.push_back(copy);
            }
            at = size_t(vertices[at].next_copy);
        }
        vertices[at].is_used = true;
        return uint32_t(at);
    }
};
} // namespace

#endif
