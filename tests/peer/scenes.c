/* The scenes of the peer check. Everything here runs once and before any pixel, so the C library's
 * sine and cosine are fine: both renderers get the same floats. */
#include "tests/peer/peer.h"

#include "tests/support/random.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* --- camera and light ------------------------------------------------------------------------- */

/* gluPerspective times gluLookAt with up = +y, rows; then the depth row again for 0 <= z <= w:
 * z' = (z + w) / 2. */
static void set_camera(PeerScene *scene, double fovy, const double eye[3])
{
    const double near_plane = 0.5, far_plane = 10;
    double length = sqrt(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]);
    double back[3] = { eye[0] / length, eye[1] / length, eye[2] / length };
    double across = sqrt(back[0] * back[0] + back[2] * back[2]);
    double right[3] = { back[2] / across, 0, -back[0] / across };
    double up[3] = { back[1] * right[2] - back[2] * right[1],
                     back[2] * right[0] - back[0] * right[2],
                     back[0] * right[1] - back[1] * right[0] };
    double view[3][4];
    for (int c = 0; c < 3; c++) {
        view[0][c] = right[c];
        view[1][c] = up[c];
        view[2][c] = back[c];
    }
    for (int r = 0; r < 3; r++)
        view[r][3] = -(view[r][0] * eye[0] + view[r][1] * eye[1] + view[r][2] * eye[2]);

    double zoom = 1 / tan(fovy * pi / 360);
    double z_scale = (far_plane + near_plane) / (near_plane - far_plane);
    double z_offset = 2 * far_plane * near_plane / (near_plane - far_plane);
    for (int c = 0; c < 4; c++) {
        double z = z_scale * view[2][c] + (c == 3 ? z_offset : 0), w = -view[2][c];
        double row[5] = { zoom * view[0][c], zoom * view[1][c], (z + w) / 2, w, z };
        for (int r = 0; r < 4; r++)
            scene->uniforms.mvp[r][c] = scene->gl_mvp[r][c] = (float)row[r];
        scene->gl_mvp[2][c] = (float)row[4];
    }
    for (int c = 0; c < 3; c++)
        scene->uniforms.eye[c] = (float)eye[c];
}

static void set_light(PeerScene *scene)
{
    PhongUniforms *u = &scene->uniforms;
    const double towards[3] = { 3, 4, 2 }, albedo[3] = { 0.80, 0.55, 0.40 };
    for (int c = 0; c < 3; c++) {
        u->light[c] = (float)(towards[c] / sqrt(29));
        u->diffuse[c] = (float)albedo[c];
        u->ambient[c] = (float)(0.15 * albedo[c]);
    }
    u->specular = 0.35f;
    u->shininess = 40;
}

static GpResult create(uint32_t vertices, uint32_t indices, PeerScene *scene)
{
    *scene = (PeerScene){ .vertex_count = vertices, .index_count = indices };
    scene->vertices = gp_alloc(vertices, sizeof *scene->vertices);
    scene->indices = gp_alloc(indices, sizeof *scene->indices);
    if (scene->vertices && scene->indices)
        return GP_OK;
    peer_scene_free(scene);
    return GP_ERROR_MEMORY;
}

void peer_scene_free(PeerScene *scene)
{
    gp_free(scene->vertices);
    gp_free(scene->indices);
    *scene = (PeerScene){ 0 };
}

/* --- torus ------------------------------------------------------------------------------------ */

static void tilt(const double in[3], float out[3])
{
    double angle = 55 * pi / 180;
    out[0] = (float)in[0];
    out[1] = (float)(in[1] * cos(angle) - in[2] * sin(angle));
    out[2] = (float)(in[1] * sin(angle) + in[2] * cos(angle));
}

GpResult peer_torus(uint32_t around, uint32_t across, double distance, PeerScene *scene)
{
    const double radius = 0.85, tube = 0.42;
    GpResult result = create(around * across, around * across * 6, scene);
    if (result)
        return result;
    uint32_t *index = scene->indices;
    for (uint32_t i = 0; i < around; i++)
        for (uint32_t j = 0; j < across; j++) {
            double a = 2 * pi * i / around, b = 2 * pi * j / across;
            double normal[3] = { cos(b) * cos(a), cos(b) * sin(a), sin(b) };
            double position[3] = { radius * cos(a) + tube * normal[0],
                                   radius * sin(a) + tube * normal[1], tube * normal[2] };
            PeerVertex *vertex = &scene->vertices[i * across + j];
            tilt(position, vertex->position);
            tilt(normal, vertex->normal);

            uint32_t i1 = (i + 1) % around, j1 = (j + 1) % across;
            uint32_t quad[6] = { i * across + j, i1 * across + j,  i1 * across + j1,
                                 i * across + j, i1 * across + j1, i * across + j1 };
            memcpy(index, quad, sizeof quad);
            index += 6;
        }
    set_camera(scene, 42, (const double[3]){ 0, 0, distance });
    set_light(scene);
    return GP_OK;
}

/* --- lattice ---------------------------------------------------------------------------------- */

enum { LATTICE_CELLS = 58, LATTICE_STEP = 16 };

/* Position of a lattice point: multiples of half a pixel, so that pixel centres lie on corners and,
 * often, on edges; exact in binary32 and on the screen. */
static void place_point(uint32_t column, uint32_t row, float position[3])
{
    Random random = { row * (LATTICE_CELLS + 1) + column };
    int32_t half_x = random_int(&random, -6, 6), half_y = random_int(&random, -6, 6);
    float x = (float)((int32_t)(column + 2) * LATTICE_STEP) + 0.5f * (float)half_x;
    float y = (float)((int32_t)(row + 2) * LATTICE_STEP) + 0.5f * (float)half_y;
    position[0] = x * 2 / PEER_SIZE - 1;
    position[1] = 1 - y * 2 / PEER_SIZE;
    position[2] = 0;
}

GpResult peer_lattice(PeerScene *scene)
{
    static const uint32_t corner[6][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 },
                                           { 0, 0 }, { 1, 1 }, { 0, 1 } };
    uint32_t count = LATTICE_CELLS * LATTICE_CELLS * 6;
    GpResult result = create(count, count, scene);
    if (result)
        return result;
    Random random = { 1 };
    for (uint32_t i = 0; i < count; i++) {
        uint32_t cell = i / 6, column = cell % LATTICE_CELLS, row = cell / LATTICE_CELLS;
        PeerVertex *vertex = &scene->vertices[i];
        place_point(column + corner[i % 6][0], row + corner[i % 6][1], vertex->position);
        for (int c = 0; c < 3; c++) /* one normal a triangle, and so one colour */
            vertex->normal[c] = i % 3 ? vertex[-1].normal[c] : random_float(&random, 0.1f, 1);
        scene->indices[i] = i;
    }
    for (int r = 0; r < 4; r++)
        scene->uniforms.mvp[r][r] = scene->gl_mvp[r][r] = r == 2 ? 0 : 1;
    scene->uniforms.mvp[2][3] = 0.5f; /* halfway between near and far on both sides */
    scene->uniforms.eye[2] = 3;
    set_light(scene);
    return GP_OK;
}

/* --- bunny ------------------------------------------------------------------------------------ */

/* Reads the header of the one PLY layout that the check needs. */
static bool read_header(FILE *file, uint32_t *vertices, uint32_t *faces)
{
    static const char *const expected[] = {
        "ply\n",
        "format binary_little_endian 1.0\n",
        NULL,
        "property float x\n",
        "property float y\n",
        "property float z\n",
        NULL,
        "property list uchar int vertex_indices\n",
        "end_header\n",
    };
    char line[128];
    for (size_t i = 0; i < GP_COUNT(expected); i++) {
        do
            if (!fgets(line, sizeof line, file))
                return false;
        while (strncmp(line, "comment", 7) == 0);
        bool right = expected[i] ? strcmp(line, expected[i]) == 0
                     : i == 2    ? sscanf(line, "element vertex %u", vertices) == 1
                                 : sscanf(line, "element face %u", faces) == 1;
        if (!right)
            return false;
    }
    return *vertices > 0 && *vertices < 1u << 24 && *faces > 0 && *faces < 1u << 24;
}

/* Vertices and faces; files and machines are little-endian here. */
static bool read_body(FILE *file, PeerScene *scene)
{
    for (uint32_t i = 0; i < scene->vertex_count; i++)
        if (fread(scene->vertices[i].position, sizeof(float), 3, file) != 3)
            return false;
    for (uint32_t i = 0; i < scene->index_count; i += 3) {
        if (fgetc(file) != 3 || fread(scene->indices + i, sizeof(uint32_t), 3, file) != 3)
            return false;
        for (uint32_t k = i; k < i + 3; k++)
            if (scene->indices[k] >= scene->vertex_count)
                return false;
    }
    return true;
}

static void center_and_scale(PeerScene *scene)
{
    float low[3] = { INFINITY, INFINITY, INFINITY };
    float high[3] = { -INFINITY, -INFINITY, -INFINITY }, side = 0;
    for (int c = 0; c < 3; c++) {
        for (uint32_t i = 0; i < scene->vertex_count; i++) {
            low[c] = fminf(low[c], scene->vertices[i].position[c]);
            high[c] = fmaxf(high[c], scene->vertices[i].position[c]);
        }
        side = fmaxf(side, high[c] - low[c]);
    }
    for (uint32_t i = 0; i < scene->vertex_count; i++)
        for (int c = 0; c < 3; c++) {
            float *p = &scene->vertices[i].position[c];
            *p = (*p - 0.5f * (low[c] + high[c])) * (2 / side);
        }
}

/* Normals: the cross products of the faces round a vertex, which weigh by area, summed. */
static void add_normals(PeerScene *scene)
{
    for (uint32_t i = 0; i < scene->index_count; i += 3) {
        PeerVertex *v[3];
        for (uint32_t k = 0; k < 3; k++)
            v[k] = &scene->vertices[scene->indices[i + k]];
        float a[3], b[3];
        for (int c = 0; c < 3; c++) {
            a[c] = v[1]->position[c] - v[0]->position[c];
            b[c] = v[2]->position[c] - v[0]->position[c];
        }
        float cross[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                           a[0] * b[1] - a[1] * b[0] };
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 3; c++)
                v[k]->normal[c] += cross[c];
    }
    for (uint32_t i = 0; i < scene->vertex_count; i++) {
        float *n = scene->vertices[i].normal;
        float length = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int c = 0; c < 3 && length > 0; c++)
            n[c] /= length;
    }
}

GpResult peer_bunny(const char *path, PeerScene *scene, GpError *error)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return gp_fail(error, GP_ERROR_IO, "%s: cannot be opened", path);
    uint32_t vertices = 0, faces = 0;
    PeerScene bunny = { 0 };
    GpResult result = GP_OK;
    if (!read_header(file, &vertices, &faces))
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: not the layout of the bunny", path);
    else if (create(vertices, faces * 3, &bunny))
        result = gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for the mesh", path);
    else if (!read_body(file, &bunny))
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: cut short, or an index out of range", path);
    fclose(file);
    if (result) {
        peer_scene_free(&bunny);
        return result;
    }
    center_and_scale(&bunny);
    add_normals(&bunny);
    set_camera(&bunny, 44, (const double[3]){ 0.6, 0.5, 2.9 });
    set_light(&bunny);
    *scene = bunny;
    return GP_OK;
}
