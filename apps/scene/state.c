/* The names are those of the tables in pipeline/resources/state.c. */
#include "apps/scene/state.h"

#include <string.h>

enum { FAR = 1000000 }; /* no coordinate of a scene lies beyond */

static void read_byte(Node *object, const char *key, uint8_t *byte)
{
    *byte = (uint8_t)node_integer(node_member(object, key), *byte, 0, 255);
}

/* What stands where the test and the writes are not said depends on what is drawn, and where. */
static void read_depth(Node node, GpDepthState *depth)
{
    node_define(&node, "depth");
    const Node test = node_member(&node, "test"), write = node_member(&node, "write");
    node_enum(&node, "test", gp_compare_names, GP_COMPARES, &depth->test);
    depth->write = node_bool(write, depth->write);
    node_without_default(&test);
    node_without_default(&write);
    depth->ternary = node_bool(node_member(&node, "ternary"), depth->ternary);
    depth->epsilon = node_number(node_member(&node, "epsilon"), depth->epsilon, 0, 1);
    node_close(&node);
}

static void read_stencil_face(Node *object, GpStencilFace *face)
{
    node_enum(object, "test", gp_compare_names, GP_COMPARES, &face->test);
    node_enum(object, "fail", gp_stencil_op_names, GP_STENCIL_OPS, &face->fail);
    node_enum(object, "depth_fail", gp_stencil_op_names, GP_STENCIL_OPS, &face->depth_fail);
    node_enum(object, "pass", gp_stencil_op_names, GP_STENCIL_OPS, &face->pass);
}

/* The members of the object itself serve all triangles, or the clockwise ones where there is a
 * "back". */
static void read_stencil(Node node, GpStencilState *stencil)
{
    node_define(&node, "stencil");
    Node back = node_member(&node, "back");
    node_define(&back, "stencil_back");
    stencil->enable = node_exists(&node);
    stencil->two_sided = node_exists(&back);
    read_stencil_face(&node, &stencil->front);
    read_stencil_face(&back, &stencil->back);
    node_close(&back);
    read_byte(&node, "reference", &stencil->reference);
    read_byte(&node, "ignore", &stencil->ignore);
    read_byte(&node, "keep", &stencil->keep);
    node_close(&node);
}

static void read_alpha_test(Node node, GpAlphaTest *test)
{
    node_define(&node, "alpha_test");
    node_enum(&node, "test", gp_compare_names, GP_COMPARES, &test->test);
    read_byte(&node, "reference", &test->reference);
    node_close(&node);
}

static void read_blend(Node *node, GpBlend *blend)
{
    node_define(node, "blend");
    node_enum(node, "op", gp_blend_op_names, GP_BLEND_OPS, &blend->op);
    node_enum(node, "src", gp_blend_factor_names, GP_BLEND_FACTORS, &blend->src);
    node_enum(node, "dst", gp_blend_factor_names, GP_BLEND_FACTORS, &blend->dst);
    node_enum(node, "alpha_op", gp_blend_op_names, GP_BLEND_OPS, &blend->alpha_op);
    node_enum(node, "alpha_src", gp_blend_factor_names, GP_BLEND_FACTORS, &blend->alpha_src);
    node_enum(node, "alpha_dst", gp_blend_factor_names, GP_BLEND_FACTORS, &blend->alpha_dst);
    /* the letters of the channels that are not written, such as "a" or "rgba" */
    blend->keep |= (uint8_t)node_letters(node_member(node, "keep"), "rgba");
    node_close(node);
}

/* One object for all targets, or an array of one a target. */
static void read_blends(Node node, GpBlend blend[GP_MAX_TARGETS])
{
    if (node_is_not(&node, JSON_ARRAY)) {
        Node all = node;
        read_blend(&all, &blend[0]);
        for (int i = 1; i < GP_MAX_TARGETS; i++)
            blend[i] = blend[0];
    }
    if (!node_is(&node, JSON_ARRAY))
        return;
    size_t count = node_length(node, GP_MAX_TARGETS);
    for (size_t i = 0; i < count; i++) {
        Node element = node_element(&node, i);
        read_blend(&element, &blend[i]);
    }
}

static void read_scissor(Node node, GpRasterState *raster)
{
    long box[4] = { 0 };
    node_integers(node, box, 4, 0, GP_MAX_SIZE);
    node_without_default(&node);
    raster->scissor = node_exists(&node);
    raster->scissor_x0 = (int32_t)box[0];
    raster->scissor_y0 = (int32_t)box[1];
    raster->scissor_x1 = (int32_t)box[2];
    raster->scissor_y1 = (int32_t)box[3];
}

/* A world-space plane p with p . (x, y, z, 1) >= 0 on the side that stays is, in clip space, p
 * times the inverse of the matrix that takes the world there. */
static void read_clip_plane(const Node *node, const SceneView *view, float plane[4])
{
    double world[4] = { 0 }, matrix[4][4], inverse[4][4];
    node_require(node);
    node_doubles(*node, world, 4, -FAR, FAR);
    for (int i = 0; i < 16; i++)
        matrix[i / 4][i % 4] = (double)view->world_to_clip[i / 4][i % 4];
    matrix_identity(inverse);
    matrix_inverse(matrix, inverse);
    for (int j = 0; j < 4; j++)
        plane[j] = (float)(world[0] * inverse[0][j] + world[1] * inverse[1][j] +
                           world[2] * inverse[2][j] + world[3] * inverse[3][j]);
}

void scene_read_state(Node node, const SceneView *view, GpState *state)
{
    GpRasterState *raster = &state->raster;
    node_define(&node, "state");
    node_enum(&node, "cull", gp_cull_names, GP_CULLS, &raster->cull);
    read_scissor(node_member(&node, "scissor"), raster);
    raster->depth_bias = node_number(node_member(&node, "depth_bias"), raster->depth_bias, -1, 1);
    raster->slope_depth_bias =
        node_number(node_member(&node, "slope_depth_bias"), raster->slope_depth_bias, -1000, 1000);

    Node planes = node_member(&node, "clip_planes");
    size_t count = node_length(planes, GP_MAX_CLIP_PLANES);
    for (size_t i = 0; i < count; i++) {
        Node plane = node_element(&planes, i);
        read_clip_plane(&plane, view, raster->clip_plane[i]);
        raster->clip_planes |= (uint8_t)(1u << i);
    }
    read_depth(node_member(&node, "depth"), &state->depth);
    read_stencil(node_member(&node, "stencil"), &state->stencil);
    read_alpha_test(node_member(&node, "alpha_test"), &state->alpha_test);
    read_blends(node_member(&node, "blend"), state->blend);
    node_numbers(node_member(&node, "blend_constant"), state->blend_constant, 4, 0, 1);
    node_close(&node);
}

void scene_read_viewport(Node node, GpViewport *viewport)
{
    if (!node_exists(&node))
        return;
    node_define(&node, "viewport");
    float box[4] = { viewport->x, viewport->y, viewport->width, viewport->height };
    float depth[2] = { 0, 1 };
    Node rectangle = node_member(&node, "box"), range = node_member(&node, "depth");
    node_numbers(rectangle, box, 4, -GP_MAX_SIZE, GP_MAX_SIZE);
    node_without_default(&rectangle);
    if (node_exists(&rectangle) && !(box[2] > 0 && box[3] > 0))
        node_fail(&rectangle, GP_ERROR_FORMAT, "expected x, y, and a width and height above 0");
    node_numbers(range, depth, 2, 0, 1);
    if (depth[1] < depth[0])
        node_fail(&range, GP_ERROR_FORMAT, "expected the smaller depth first");
    *viewport = (GpViewport){ .x = box[0],
                              .y = box[1],
                              .width = box[2],
                              .height = box[3],
                              .min_depth = depth[0],
                              .max_depth = depth[1],
                              .has_depth_range = true,
                              .d3d9_centers = node_bool(node_member(&node, "d3d9_centers"),
                                                        viewport->d3d9_centers) };
    node_close(&node);
}

void scene_read_camera(Node node, Camera *camera)
{
    Camera described = *camera;
    if (!node_exists(&node))
        return;
    if (node_lacks(&node))
        camera = &described; /* fovy and height are both in the description */
    node_define(&node, "camera");
    Node fovy = node_member(&node, "fovy"), height = node_member(&node, "height");
    Node near = node_member(&node, "near"), far = node_member(&node, "far");
    node_doubles(node_member(&node, "eye"), camera->eye, 3, -FAR, FAR);
    node_doubles(node_member(&node, "at"), camera->at, 3, -FAR, FAR);
    node_doubles(node_member(&node, "up"), camera->up, 3, -FAR, FAR);
    camera->fovy = node_double(fovy, camera->fovy, 0.1, 170);
    if (node_exists(&height)) {
        if (node_exists(&fovy))
            node_fail(&height, GP_ERROR_FORMAT, "a camera has fovy or height, not both");
        camera->fovy = 0;
        camera->height = node_double(height, 1, 0.000001, FAR);
        node_without_default(&height);
    }
    camera->near = node_double(near, camera->near, 0.000001, FAR);
    camera->far = node_double(far, camera->far, 0.000001, FAR);
    if (camera->far <= camera->near)
        node_fail(node_exists(&far) ? &far : &near, GP_ERROR_FORMAT, "far is not beyond near");

    double forward[3], square[3];
    vector_subtract(camera->at, camera->eye, forward);
    vector_cross(forward, camera->up, square);
    if (vector_dot(square, square) == 0.0)
        node_fail(&node, GP_ERROR_FORMAT, "eye, at and up give no direction");
    node_close(&node);
}
