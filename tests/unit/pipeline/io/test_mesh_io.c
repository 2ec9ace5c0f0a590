/* Meshes from files: every format tells the same pyramid, no face is lost, and normals are the
 * weighted sum. */
#include "pipeline/io/file.h"
#include "pipeline/io/mesh/mesh_file.h"
#include "tests/support/folder.h"
#include "tests/support/meshes/mesh_files.h"
#include "tests/support/random.h"

#include <limits.h>
#include <math.h>

static GpError error;

static void assert_reads(const char *path, GpMesh *mesh)
{
    if (gp_mesh_read(path, GP_MESH_TRIANGLES, mesh, &error) != GP_OK)
        fail_msg("%s", error.text);
}

/* --- the pyramid ------------------------------------------------------------------------------ */

static void assert_pyramid(const char *path, GpMesh *mesh)
{
    assert_reads(path, mesh);
    if (mesh->vertex_count != 5 || mesh->triangle_count != 4 || mesh->skipped_count != 0)
        fail_msg("%s: %u vertices, %u triangles, %u skipped", path, mesh->vertex_count,
                 mesh->triangle_count, mesh->skipped_count);
    for (size_t i = 0; i < GP_COUNT(pyramid_positions); i++) {
        if (mesh->positions[i] != pyramid_positions[i])
            fail_msg("%s: coordinate %zu is %g", path, i, (double)mesh->positions[i]);
    }
    assert_memory_equal(mesh->indices, pyramid_indices, sizeof pyramid_indices);
}

static void assert_plain_pyramid(const char *path)
{
    GpMesh mesh;
    assert_pyramid(path, &mesh);
    assert_false(mesh.had_normals || mesh.had_colors || mesh.had_texcoords);
    assert_null(mesh.colors);
    assert_null(mesh.texcoords);
    gp_mesh_free(&mesh);
    assert_null(mesh.positions);
}

static void off_in_its_dialects_gives_the_pyramid(void **state)
{
    (void)state;
    static const char *const files[] = {
        "OFF\n5 3 0\n" OFF_VERTICES OFF_FACES,
        "OFF 5 3 0\n" OFF_VERTICES OFF_FACES,
        "OFF\r\n5 3 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n.5 .5 -1.5\r\n4 3 2 1 0\r\n3 0 1 4\r\n"
        "3 1 2 4\r\n",
        "OFF # a comment\n# 9 9 9\n5 3 0 # counts\n\n0 0 0 # 7\n1 0 0\n\n1 1 0\n0 1 0\n.5 .5 -1.5\n"
        "#4 0 0 0 0\n4 3 2 1 0 #\n3 0 1 4\n3 1 2 4 # end",
        "OFF\n5 3 0\n0 0 0 9 9 9\n1 0 0\n1 1 0\n0 1 0 5\n.5 .5 -1.5\n"
        "4 3 2 1 0 0.1 0.2 0.3\n3 0 1 4 255 0 0\n  3\t1  2   4  1\n",
    };
    for (size_t i = 0; i < GP_COUNT(files); i++)
        assert_plain_pyramid(put_text("a.off", files[i]));
}

static void off_prefixes_add_attributes(void **state)
{
    (void)state;
    GpMesh mesh;
    assert_pyramid(put_text("a.off", "STCNOFF\n5 3 0\n"
                                     "0 0 0  0 0 1  255 0 51  0 0.25\n"
                                     "1 0 0\t0 0 2  255 0 51  0 0.25\n"
                                     "1 1 0  0 0 1  255 0 51 0  0 0.25\n"
                                     "0 1 0  0 1 0  0.5 0 1.0 0 0.25\n"
                                     ".5 .5 -1.5  0 0 0  .5 0 1 .75  0.5 0.75\n" OFF_FACES),
                   &mesh);
    assert_true(mesh.had_normals && mesh.had_colors && mesh.had_texcoords);
    static const float colors[20] = { 1,    0, 0.2f, 1, 1, 0, 0.2f, 1, 1, 0,
                                      0.2f, 0, 0.5f, 0, 1, 1, 0.5f, 0, 1, 0.75f };
    for (int i = 0; i < 20; i++)
        assert_true(mesh.colors[i] == colors[i]);
    assert_true(mesh.normals[5] == 2 && mesh.normals[10] == 1);
    assert_true(mesh.texcoords[1] == 0.25f && mesh.texcoords[8] == 0.5f);
    gp_mesh_free(&mesh);
}

static void obj_in_its_dialects_gives_the_pyramid(void **state)
{
    (void)state;
    static const char *const files[] = {
        OBJ_VERTICES "f 4 3 2 1\nf 1 2 5\nf 2 3 5\n",
        OBJ_VERTICES "f -2 -3 -4 -5\nf -5 -4 -1\nf 2 3 -1",
        "# comment\r\no thing\r\nmtllib none.mtl\r\ng part\r\n" OBJ_VERTICES
        "usemtl gold\r\ns 1\r\nf 4 3 2 1\r\n  f  1\t2 5  \r\nf 2 3 5\r\n",
        "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nv 0 0 0 1.0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 -1.5\n",
    };
    for (size_t i = 0; i < GP_COUNT(files); i++)
        assert_plain_pyramid(put_text("a.obj", files[i]));
}

static void ply_in_all_encodings_and_dialects_gives_the_pyramid(void **state)
{
    (void)state;
    for (int encoding = 0; encoding < 3; encoding++) {
        for (int variant = 0; variant < PLY_VARIANTS; variant++) {
            MeshBytes bytes;
            mesh_write_ply(&bytes, encoding, variant);
            assert_plain_pyramid(put_file("a.ply", bytes.data, bytes.size));
        }
    }
}

static void ply_header_white_space_does_not_shift_the_body(void **state)
{
    (void)state;
    static const char body[] = "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0"
                               "\0\0\0\0\0\0\0\x40\0\0\0\0\x3\0\0\0\0\x1\0\0\0\x2\0\0\0";
    static const char *const headers[] = {
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_index\nend_header\n",
        "ply\r\nformat binary_little_endian 1.0\r\nelement vertex 3\r\nproperty float x\r\n"
        "property float y\r\nproperty float z\r\nelement face 1\r\n"
        "property list uchar int vertex_index\r\nend_header\r\n",
        "ply \nformat  binary_little_endian 1.0\n\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1 \n"
        "property list uchar int vertex_index \n\nend_header\n",
        "ply\nformat binary_little_endian 1.0\ncomment\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_index\ncomment last\nend_header\n",
    };
    for (size_t i = 0; i < GP_COUNT(headers); i++) {
        char bytes[512];
        size_t size = strlen(headers[i]);
        memcpy(bytes, headers[i], size);
        memcpy(bytes + size, body, sizeof body - 1);
        GpMesh mesh;
        assert_reads(put_file("a.ply", bytes, size + sizeof body - 1), &mesh);
        assert_true(mesh.positions[3] == 1 && mesh.positions[7] == 2);
        assert_int_equal(mesh.indices[2], 2);
        gp_mesh_free(&mesh);
    }
}

static void ply_attributes_are_read_in_any_order_and_type(void **state)
{
    (void)state;
    static const char *const files[] = {
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "property float s\nproperty float t\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nproperty uchar alpha\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0 3 .25 .75 255 0 51 102\n1 0 0 0 0 3 .25 .75 255 0 51 102\n"
        "0 1 0 0 0 3 .25 .75 255 0 51 102\n3 0 1 2\n",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float red\nproperty float alpha\n"
        "property double nz\nproperty double nx\nproperty double ny\nproperty double texture_v\n"
        "property float texture_u\nproperty float green\nproperty float blue\nproperty int x\n"
        "property char y\nproperty short z\nproperty float quality\nelement face 1\n"
        "property uchar red\nproperty list int uint vertex_index\nend_header\n"
        "1 .4 3 0 0 .75 .25 0 .2 0 0 0 nan\n1 .4 3 0 0 .75 .25 0 .2 1 0 0 1\n"
        "1.5 .4 3 0 0 .75 .25 -1 .2 0 1 0 2\n7 3 0 1 2\n",
    };
    for (size_t i = 0; i < GP_COUNT(files); i++) {
        GpMesh mesh;
        assert_reads(put_text("a.ply", files[i]), &mesh);
        assert_true(mesh.had_normals && mesh.had_colors && mesh.had_texcoords);
        static const float color[4] = { 1, 0, 0.2f, 0.4f };
        for (int v = 0; v < 3; v++) {
            assert_memory_equal(mesh.colors + 4 * v, color, sizeof color);
            assert_true(mesh.normals[3 * v + 2] == 3 && mesh.normals[3 * v] == 0);
            assert_true(mesh.texcoords[2 * v] == 0.25f && mesh.texcoords[2 * v + 1] == 0.75f);
        }
        assert_true(mesh.positions[3] == 1 && mesh.positions[7] == 1);
        gp_mesh_free(&mesh);
    }
}

static void stl_corners_are_welded_and_flat_faces_skipped(void **state)
{
    (void)state;
    static const uint32_t indices[9] = { 0, 1, 2, 1, 3, 2, 0, 1, 2 };
    for (int i = 0; i < 3; i++) {
        MeshBytes bytes;
        GpMesh mesh;
        mesh_write_stl(&bytes, i == 1 ? "made by hand" : "solid but binary");
        assert_reads(i == 0 ? put_text("a.stl", mesh_stl_text)
                            : put_file("a.STL", bytes.data, bytes.size),
                     &mesh);
        assert_int_equal(mesh.vertex_count, 5); /* 0 5 0 is only in the skipped face */
        assert_int_equal(mesh.triangle_count, 3);
        assert_int_equal(mesh.skipped_count, 1);
        assert_memory_equal(mesh.indices, indices, sizeof indices);
        assert_false(mesh.had_normals);
        assert_true(mesh.normals[2] == 1);
        gp_mesh_free(&mesh);
    }
}

static void stl_corners_weld_across_the_sign_of_zero(void **state)
{
    (void)state;
    GpMesh mesh;
    assert_reads(put_text("a.stl", "solid\n"
                                   "facet normal 0 0 1\nouter loop\nvertex 0 0 -0\nvertex 1 0 0\n"
                                   "vertex 0 1 0\nendloop\nendfacet\n"
                                   "facet normal 0 0 1\nouter loop\nvertex 0 1 1e-40\n"
                                   "vertex 1 -0 0\nvertex 1 1 1e-20\nendloop\nendfacet\n"
                                   "endsolid\n"),
                 &mesh);
    static const uint32_t indices[6] = { 0, 1, 2, 2, 1, 3 };
    assert_int_equal(mesh.vertex_count, 4);
    assert_memory_equal(mesh.indices, indices, sizeof indices);
    assert_true(signbit(mesh.positions[2])); /* the first corner's own bits stay */
    gp_mesh_free(&mesh);
}

static void om_of_both_generations_gives_the_pyramid(void **state)
{
    (void)state;
    MeshBytes bytes;
    mesh_write_om1(&bytes);
    assert_plain_pyramid(put_file("a.om", bytes.data, bytes.size));

    GpMesh mesh;
    assert_pyramid(put_file("b.om", mesh_om_bytes, sizeof mesh_om_bytes), &mesh);
    assert_true(mesh.had_normals && mesh.had_colors && mesh.had_texcoords);
    for (int v = 0; v < 5; v++) {
        assert_true(mesh.texcoords[2 * v] == 0.25f * (float)v);
        assert_true(mesh.colors[4 * v + 2] == 3 / 255.0f && mesh.colors[4 * v + 3] == 1);
        assert_true(mesh.normals[3 * v + 2] == 1);
    }
    gp_mesh_free(&mesh);
}

/* --- what a reader could lose ----------------------------------------------------------------- */

static void non_manifold_duplicate_and_flat_faces_are_kept(void **state)
{
    (void)state;
    /* Four faces on one edge, one of them twice, one turned over, one flat; vertex 6 unused. */
    GpMesh mesh;
    assert_reads(put_text("a.off",
                          "OFF\n7 7 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n9 9 9\n"
                          "3 0 1 2\n3 0 1 3\n3 0 1 4\n3 0 1 5\n3 0 1 2\n3 2 1 0\n3 1 1 0\n"),
                 &mesh);
    static const uint32_t indices[21] = { 0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1,
                                          5, 0, 1, 2, 2, 1, 0, 1, 1, 0 };
    assert_int_equal(mesh.vertex_count, 7);
    assert_int_equal(mesh.triangle_count, 7);
    assert_int_equal(mesh.skipped_count, 0);
    assert_memory_equal(mesh.indices, indices, sizeof indices);
    gp_mesh_free(&mesh);
}

static void obj_corners_with_other_attributes_become_copies(void **state)
{
    (void)state;
    GpMesh mesh;
    assert_reads(put_text("a.obj", OBJ_VERTICES
                          "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n"
                          "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/1/1 4/2/1\nf 1/1/2 2/2/1 5//2\n"
                          "f 3/1/1 3/3/1 1/1/2\nf 1 2 2\n"),
                 &mesh);
    /* Third face: 1 with another normal (6). Second face: 3 with another texcoord (5). */
    static const uint32_t indices[9] = { 0, 1, 2, 0, 5, 3, 6, 1, 4 };
    assert_int_equal(mesh.vertex_count, 7);
    assert_memory_equal(mesh.indices, indices, sizeof indices);
    assert_memory_equal(mesh.positions + 15, mesh.positions + 6, 12);
    assert_memory_equal(mesh.positions + 18, mesh.positions, 12);
    assert_true(mesh.texcoords[4] == 1 && mesh.texcoords[5] == 1); /* 3/3 */
    assert_true(mesh.texcoords[10] == 0 && mesh.texcoords[11] == 0);
    assert_true(mesh.normals[2] == 1 && mesh.normals[19] == 1);
    /* Both later faces have fewer than three different vertices: skipped. */
    assert_int_equal(mesh.triangle_count, 3);
    assert_int_equal(mesh.skipped_count, 2);
    gp_mesh_free(&mesh);
}

static void obj_colours_follow_their_vertices(void **state)
{
    (void)state;
    GpMesh mesh;
    assert_reads(put_text("a.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 .5 0\nv 0 1 0 0 0 .25\nf 1 2 3\n"),
                 &mesh);
    static const float colors[12] = { 1, 0, 0, 1, 0, 0.5f, 0, 1, 0, 0, 0.25f, 1 };
    assert_true(mesh.had_colors);
    assert_memory_equal(mesh.colors, colors, sizeof colors);
    gp_mesh_free(&mesh);
}

static void obj_vertices_that_no_face_names_are_white(void **state)
{
    (void)state;
    GpMesh mesh;
    assert_reads(put_text("a.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 .5 0\nv 0 1 0 0 0 .25\n"
                                   "v 9 9 9 0 0 0\nf 1 2 3\n"),
                 &mesh);
    assert_true(mesh.colors[9] == 0 && mesh.colors[12] == 1 && mesh.colors[13] == 1);
    gp_mesh_free(&mesh);
}

static void obj_points_have_colours_and_a_normal_each(void **state)
{
    (void)state;
    static const char *const files[] = { "v 0 0 0 1 .5 0\nv 1 0 0 0 0 0\nvn 1 0 0\nvn 0 1 0\n",
                                         "v 0 0 0 1 .5 0\nv 1 0 0 0 0 0\nvn 1 0 0\n" };
    for (size_t i = 0; i < GP_COUNT(files); i++) {
        GpMesh mesh;
        const char *path = put_text("a.obj", files[i]);
        assert_int_equal(gp_mesh_read(path, GP_MESH_ALLOW_POINTS, &mesh, &error), GP_OK);
        assert_true(mesh.colors[1] == 0.5f && mesh.colors[4] == 0);
        assert_true(mesh.normals[0] == (i == 0) && mesh.normals[4] == (i == 0)); /* else 0 0 1 */
        gp_mesh_free(&mesh);
    }
}

/* Opening a pipe that nobody writes to waits for ever: the alarm would end this program. */
static void obj_material_files_are_not_opened(void **state)
{
    (void)state;
    char text[512];
    assert_int_equal(mkfifo(in_folder("pipe"), 0600), 0);
    snprintf(text, sizeof text, "mtllib %s\n" OBJ_VERTICES "f 4 3 2 1\nf 1 2 5\nf 2 3 5\n",
             in_folder("pipe"));
    alarm(20);
    assert_plain_pyramid(put_text("a.obj", text));
    alarm(0);
}

/* --- normals ---------------------------------------------------------------------------------- */

static void normals_are_the_area_weighted_sum(void **state)
{
    (void)state;
    GpMesh mesh;
    Random random = { .state = 7 };
    MeshBytes bytes = { .encoding = 0 };
    mesh_put_string(&bytes, "OFF\n20 40 0\n");
    for (int i = 0; i < 60; i++)
        mesh_put_number(&bytes, random_float(&random, -1, 1), false),
            mesh_put_string(&bytes, i % 3 == 2 ? "\n" : " ");
    for (int f = 0; f < 40; f++) {
        mesh_put_integer(&bytes, 3, 1);
        for (int i = 0; i < 3; i++)
            mesh_put_integer(&bytes, (uint32_t)random_int(&random, 0, 18), 1);
        mesh_put_string(&bytes, "\n");
    }
    assert_reads(put_file("a.off", bytes.data, bytes.size), &mesh);
    for (uint32_t v = 0; v < 20; v++) {
        long double sum[3] = { 0, 0, 0 };
        for (uint32_t c = 0; c < 3 * mesh.triangle_count; c++) {
            if (mesh.indices[c] != v)
                continue;
            const uint32_t *t = mesh.indices + c - c % 3;
            long double e[2][3];
            for (int k = 0; k < 6; k++)
                e[k / 3][k % 3] = (long double)mesh.positions[3 * t[1 + k / 3] + (uint32_t)k % 3] -
                                  (long double)mesh.positions[3 * t[0] + (uint32_t)k % 3];
            for (int k = 0; k < 3; k++)
                sum[k] +=
                    e[0][(k + 1) % 3] * e[1][(k + 2) % 3] - e[0][(k + 2) % 3] * e[1][(k + 1) % 3];
        }
        long double length = sqrtl(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        for (int k = 0; k < 3; k++) {
            long double expected = length > 0 ? sum[k] / length : k == 2;
            assert_true(fabsl((long double)mesh.normals[3 * v + (uint32_t)k] - expected) < 1e-7L);
        }
    }
    assert_true(mesh.normals[59] == 1); /* vertex 19 has no face */
    gp_mesh_free(&mesh);
}

static void tiny_and_huge_triangles_have_normals(void **state)
{
    (void)state;
    static const char *const scales[] = { "e-44", "e-20", "e0", "e37" };
    for (size_t i = 0; i < GP_COUNT(scales); i++) {
        char text[256];
        GpMesh mesh;
        snprintf(text, sizeof text, "OFF\n3 1 0\n0 0 0\n0 3%s 0\n0 0 3%s\n3 0 1 2\n", scales[i],
                 scales[i]);
        assert_reads(put_text("a.off", text), &mesh);
        for (int v = 0; v < 3; v++)
            assert_true(mesh.normals[3 * v] == 1 && mesh.normals[3 * v + 2] == 0);
        gp_mesh_free(&mesh);
    }
}

static void stored_normals_stay_and_zero_ones_are_computed(void **state)
{
    (void)state;
    GpMesh mesh;
    assert_reads(put_text("a.off", "NOFF\n4 1 0\n0 0 0 .1 .2 .3\n1 0 0 0 0 0\n0 1 0 0 -7 0\n"
                                   "5 5 5 0 0 0\n3 0 1 2\n"),
                 &mesh);
    static const float expected[12] = { 0.1f, 0.2f, 0.3f, 0, 0, 1, 0, -7, 0, 0, 0, 1 };
    assert_true(mesh.had_normals);
    assert_memory_equal(mesh.normals, expected, sizeof expected);
    gp_mesh_free(&mesh);
}

/* --- the shared meshes ------------------------------------------------------------------------ */

static void shared_meshes_keep_every_vertex_and_face(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint32_t vertices, triangles;
        bool has_normals;
    } cases[] = {
        { "meshes/bunny.ply", 35947, 69451, false },
        { "meshes/teapot.ply", 3644, 6320, false },
        { "meshes/cycloidal.ply", 21384, 43368, false },
        { "meshes/dragon_100k.ply", 50000, 100000, true },
        { "meshes/dragon_res2.ply", 100250, 202520, false },
        { "meshes/happy_buddha.ply", 543628, 1087716, true },
        { "meshes/dirty/beast.ply", 32311, 64618, false },
        { "meshes/dirty/boeing.ply", 2741, 2564, false },
        { "meshes/dirty/chair_dup_faces.ply", 3186, 12756, false },
        { "meshes/dirty/conrod.ply", 3223, 6442, false },
        { "meshes/dirty/non_manifold_hole.ply", 432, 755, false },
        { "meshes/dirty/office_chair.ply", 3476, 6893, false },
        { "meshes/dirty/triangle_soup.ply", 300, 100, false },
        { "meshes/dirty/wallhole.ply", 92, 66, false },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        char path[PATH_MAX];
        GpMesh mesh;
        if (gp_data_find(cases[i].name, path, sizeof path, NULL) != GP_OK)
            skip();
        assert_reads(path, &mesh);
        if (mesh.vertex_count != cases[i].vertices || mesh.triangle_count != cases[i].triangles ||
            mesh.had_normals != cases[i].has_normals)
            fail_msg("%s: %u vertices, %u triangles", path, mesh.vertex_count, mesh.triangle_count);
        gp_mesh_free(&mesh);
    }
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(off_in_its_dialects_gives_the_pyramid),
        TEST(off_prefixes_add_attributes),
        TEST(obj_in_its_dialects_gives_the_pyramid),
        TEST(ply_in_all_encodings_and_dialects_gives_the_pyramid),
        TEST(ply_header_white_space_does_not_shift_the_body),
        TEST(ply_attributes_are_read_in_any_order_and_type),
        TEST(stl_corners_are_welded_and_flat_faces_skipped),
        TEST(stl_corners_weld_across_the_sign_of_zero),
        TEST(om_of_both_generations_gives_the_pyramid),
        TEST(non_manifold_duplicate_and_flat_faces_are_kept),
        TEST(obj_corners_with_other_attributes_become_copies),
        TEST(obj_colours_follow_their_vertices),
        TEST(obj_vertices_that_no_face_names_are_white),
        TEST(obj_points_have_colours_and_a_normal_each),
        TEST(obj_material_files_are_not_opened),
        TEST(normals_are_the_area_weighted_sum),
        TEST(tiny_and_huge_triangles_have_normals),
        TEST(stored_normals_stay_and_zero_ones_are_computed),
        TEST(shared_meshes_keep_every_vertex_and_face),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
