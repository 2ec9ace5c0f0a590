/* OpenMesh's readers with an importer that keeps every face. */
#include "pipeline/io/mesh/mesh_collector.hpp"

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/reader/OFFReader.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <cstring>
#include <istream>
#include <mutex>
#include <new>
#include <stdexcept>
#include <streambuf>

extern "C" {
#include "pipeline/io/mesh/mesh_openmesh.h"
}

namespace
{
using IO::Options;

/* A stream over bytes that stay where they are. OpenMesh seeks in it. */
class MemoryBuffer : public std::streambuf
{
  public:
    MemoryBuffer(char *data, size_t size)
    {
        setg(data, data, data + size);
    }

  protected:
    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override
    {
        char *base = from == std::ios_base::beg   ? eback()
                     : from == std::ios_base::cur ? gptr()
                                                  : egptr();
        if (offset < eback() - base || offset > egptr() - base)
            return pos_type(off_type(-1));
        setg(eback(), base + offset, egptr());
        return pos_type(gptr() - eback());
    }

    pos_type seekpos(pos_type position, std::ios_base::openmode mode) override
    {
        return seekoff(off_type(position), std::ios_base::beg, mode);
    }
};

/* A log stream of OpenMesh that is silent while this lives. */
class Silence
{
  public:
    explicit Silence(mostream &stream) : stream_(stream), was_enabled_(stream.is_enabled())
    {
        stream_.disable();
    }

    ~Silence()
    {
        if (was_enabled_)
            stream_.enable();
    }

    Silence(const Silence &) = delete;
    Silence &operator=(const Silence &) = delete;

  private:
    mostream &stream_;
    bool was_enabled_;
};

void read_with_openmesh(const GpMeshSource &source, Collector &collector)
{
    Options options;
    if (source.is_binary)
        options += Options::Binary;
    if (source.has_normals)
        options += Options::VertexNormal;
    if (source.has_colors)
        options += Options::VertexColor;
    if (source.has_texcoords)
        options += Options::VertexTexCoord;

    /* The OFF reader takes the header's letters from the last file that it was asked about. */
    if (source.format == GP_MESH_OFF && !IO::OFFReader().can_u_read(source.path))
        throw std::runtime_error("the header of an OFF file");
    MemoryBuffer buffer(source.file.data, source.file.size);
    std::istream stream(&buffer);
    if (source.format == GP_MESH_OM)
        stream.unsetf(std::ios::skipws);
    if (!IO::IOManager().read(stream, source.reading, collector, options))
        throw std::runtime_error("the file");
    collector.resolve_faces();
}

/* Faces may be missing only where OpenMesh is known to drop those without area. */
bool is_complete(const GpMeshSource &source, const Collector &collector)
{
    bool may_drop = source.format == GP_MESH_STL || source.format == GP_MESH_OBJ;
    bool all_vertices =
        source.format == GP_MESH_STL || collector.vertices.size() >= source.vertex_count;
    return all_vertices && collector.face_count <= source.face_count &&
           (may_drop || collector.face_count == source.face_count);
}

GpResult copy_out(const GpMeshSource &source, const Collector &collector, GpMesh *mesh)
{
    size_t count = collector.vertices.size();
    GpMesh copy = {};
    copy.vertex_count = uint32_t(count);
    copy.triangle_count = uint32_t(collector.indices.size() / 3);
    copy.skipped_count = uint32_t(source.face_count - collector.face_count);
    copy.had_normals = source.has_normals;
    copy.had_colors = source.has_colors;
    copy.had_texcoords = source.has_texcoords;
    copy.positions = static_cast<float *>(gp_alloc(3 * count, sizeof(float)));
    copy.normals = static_cast<float *>(gp_alloc(3 * count, sizeof(float)));
    copy.indices = static_cast<uint32_t *>(gp_alloc(collector.indices.size(), sizeof(uint32_t)));
    if (source.has_colors)
        copy.colors = static_cast<float *>(gp_alloc(4 * count, sizeof(float)));
    if (source.has_texcoords)
        copy.texcoords = static_cast<float *>(gp_alloc(2 * count, sizeof(float)));
    if (!copy.positions || !copy.normals || !copy.indices || (source.has_colors && !copy.colors) ||
        (source.has_texcoords && !copy.texcoords)) {
        gp_mesh_free(&copy);
        return GP_ERROR_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        const Vertex &vertex = collector.vertices[i];
        std::memcpy(copy.positions + 3 * i, vertex.position.data(), 3 * sizeof(float));
        std::memcpy(copy.normals + 3 * i, vertex.attributes.normal.data(), 3 * sizeof(float));
        if (copy.colors)
            std::memcpy(copy.colors + 4 * i, vertex.color.data(), 4 * sizeof(float));
        if (copy.texcoords)
            std::memcpy(copy.texcoords + 2 * i, vertex.attributes.texcoord.data(),
                        2 * sizeof(float));
    }
    if (!collector.indices.empty())
        std::memcpy(copy.indices, collector.indices.data(),
                    collector.indices.size() * sizeof(uint32_t));
    *mesh = copy;
    return GP_OK;
}
} // namespace

extern "C" GpResult gp_mesh_import(const GpMeshSource *source, GpMesh *mesh, GpError *error)
{
    static std::mutex readers; /* OpenMesh's readers are global objects with state */
    try {
        std::lock_guard<std::mutex> lock(readers);
        Silence log(omlog()), out(omout()), err(omerr());
        Collector collector(*source);
        read_with_openmesh(*source, collector);
        if (!is_complete(*source, collector))
            return gp_fail(error, GP_ERROR_FORMAT,
                           "%s: OpenMesh delivered %zu of %zu vertices and %zu of %zu faces",
                           source->path, collector.vertices.size(), source->vertex_count,
                           collector.face_count, source->face_count);
        if (copy_out(*source, collector, mesh) == GP_OK)
            return GP_OK;
    } catch (const std::bad_alloc &) {
        /* falls through to the message below */
    } catch (const std::exception &problem) {
        return gp_fail(error, GP_ERROR_FORMAT, "%s: OpenMesh cannot read it: %s", source->path,
                       problem.what());
    }
    return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for the mesh", source->path);
}
