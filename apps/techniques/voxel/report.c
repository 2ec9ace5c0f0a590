#include "apps/techniques/voxel/report.h"

#include "apps/techniques/voxel/facts.h"
#include "apps/techniques/voxel/models.h"
#include "apps/truth/voxel_nearest.h"

#include <inttypes.h>

/* --- voxels ----------------------------------------------------------------------------------- */

/* The tight range of the bits of a volume. */
static VoxelRange range_of_bits(const uint8_t *bits, uint32_t size)
{
    VoxelRange range = { { size, size, size }, { 0, 0, 0 } };
    const size_t end = (size_t)size * size * size;
    for (size_t i = 0; (i = voxel_next(bits, size, i)) < end; i++) {
        uint32_t at[3];
        voxel_place(i, size, at);
        for (int k = 0; k < 3; k++) {
            range.low[k] = at[k] < range.low[k] ? at[k] : range.low[k];
            range.end[k] = at[k] + 1 > range.end[k] ? at[k] + 1 : range.end[k];
        }
    }
    return range;
}

/* Where a volume lies: voxels = scale * position + offset, in each model's own space. */
static void tell_places(const VoxelPair *pair, const VoxelPairMade *made, json_t *members)
{
    static const char *const names[] = { "transform", "with_transform" };
    for (int i = 0; i < 2 && pair->scenes[i]; i++) {
        const VoxelBox *box = &made->boxes[i];
        const double *offset = box->offset;
        json_object_set_new(members, names[i],
                            json_pack("{s:f, s:[f, f, f]}", "scale", box->scale, "offset",
                                      offset[0], offset[1], offset[2]));
    }
}

/* Where the voxels of two models' touching are: the first and the last along each axis. */
static GpResult tell_range(const Frame *frame, TechniqueReport *report, GpError *error)
{
    GpVolume volume;
    GpResult result = voxel_models_volume(frame, &volume, error);
    if (result)
        return result;
    const VoxelRange range = range_of_bits(volume.data, volume.dims[0]);
    gp_volume_free(&volume);
    json_t *array = json_array();
    text_add(&report->lines, "range");
    for (int k = 0; k < 3; k++) {
        const uint32_t first = range.low[k], last = range.end[k] - 1;
        text_add(&report->lines, " %u..%u", first, last);
        json_array_append_new(array, json_pack("[I, I]", (json_int_t)first, (json_int_t)last));
    }
    text_add(&report->lines, "\n");
    json_object_set_new(report->members, "range", array);
    return GP_OK;
}

static GpResult tell_voxels(const VoxelPair *pair, const Frame *frame, TechniqueReport *report,
                            GpError *error)
{
    const VoxelMade *made = frame->made;
    const bool touching = pair->scenes[1] && pair->combine == VOXEL_TOUCHING;
    const char *name = touching ? "touching" : "voxels";
    const uint64_t voxels = flat_texture_count(&made->pair.result);
    uint64_t triangles = 0;
    for (int i = 0; i < 2 && pair->scenes[i]; i++)
        triangles += pair->scenes[i]->mesh.triangle_count;
    text_add(&report->lines, "%s %" PRIu64 "\n", name, voxels);
    json_object_set_new(report->members, name, json_integer((json_int_t)voxels));
    json_object_set_new(report->members, "triangles", json_integer((json_int_t)triangles));
    tell_places(pair, &made->pair, report->members);
    return touching && voxels ? tell_range(frame, report, error) : GP_OK;
}

/* --- meshes ----------------------------------------------------------------------------------- */

/* Solids are never made of an open mesh without a word. Parity needs an even number of triangles at
 * each edge, the winding number as many that run along it one way as the other. */
static void warn_if_open(const char *name, const MeshReport *mesh, bool winds,
                         TechniqueReport *report)
{
    static const char *const words[2][2] = {
        { "every line crosses an even number of triangles all the same",
          "lines beside these edges may cross an odd number of triangles: the solid is wrong "
          "there" },
        { "every line enters as often as it leaves all the same",
          "lines beside these edges may enter more often than they leave: the solid is wrong "
          "there" },
    };
    char faults[256];
    if (mesh->is_closed)
        return;
    mesh_report_faults(mesh, faults, sizeof faults);
    const bool wrong = winds ? mesh->unbalanced_edges > 0 : mesh->odd_edges > 0;
    text_add(&report->warnings, "%s is not closed: %s\n%s\n", name, faults, words[winds][wrong]);
}

/* Nor does parity hollow out what overlaps or is nested. */
static GpResult warn_if_doubled(const VoxelModels *models, int which, const VoxelBox *box,
                                const MeshReport *mesh, TechniqueReport *report, GpError *error)
{
    uint64_t doubled;
    GpResult result =
        voxel_facts_count_doubled(models->pair.scenes[which], mesh, box, &doubled, error);
    if (!result && doubled)
        text_add(&report->warnings,
                 "%s overlaps itself or has shells inside others: %" PRIu64
                 " voxel%s inside, by the winding number, that counting triangles leaves hollow\n"
                 "--method winding fills them\n",
                 models->pair.names[which], doubled, doubled == 1 ? " is" : "s are");
    return result;
}

/* Nor is a surface missed outside of the volume, which some methods do not draw, without a word.
 * Those that look along z alone miss none beside it. */
static void warn_if_outside(const char *name, const VoxelScene *scene, const VoxelSetting *setting,
                            const VoxelBox *box, TechniqueReport *report)
{
    const VoxelMethod method = setting->method;
    const bool sheets = method == VOXEL_SHEETS, faces = method == VOXEL_FACES;
    const bool all = faces || (sheets && setting->axes != 1);
    const Bounds bounds = voxel_scene_bounds(scene);
    bool outside = false;
    for (int k = all ? 0 : 2; k < 3; k++)
        outside |= bounds.low[k] * box->scale + box->offset[k] < 0 ||
                   bounds.high[k] * box->scale + box->offset[k] > box->size;
    if (outside && (sheets || faces || method == VOXEL_SLICES || method == VOXEL_LDI))
        text_add(&report->warnings,
                 "%s reaches out of the volume, where this method draws no surface: the solid "
                 "may be wrong\n--method xor and winding draw all\n",
                 name);
}

/* Told of the first model where that is asked for, and to --json of every mesh. */
static GpResult tell_facts(const VoxelOptions *options, const VoxelScene *scene, VoxelFacts *facts,
                           TechniqueReport *report, GpError *error)
{
    if (options->voxels.kind == VOXEL_SOLID) {
        GpResult result = voxel_facts_find_solids(scene, options->voxels.size, facts, error);
        if (result)
            return result;
    }
    voxel_facts_add(facts, &report->lines);
    json_object_set_new(report->members, "report", voxel_facts_json(facts));
    return GP_OK;
}

/* in   which: 0 the first model, which alone is told of; box: its place in the volume */
static GpResult look_at_mesh(const VoxelModels *models, int which, const VoxelOptions *options,
                             const VoxelBox *box, TechniqueReport *report, GpError *error)
{
    const VoxelScene *scene = models->pair.scenes[which];
    const bool asked = which == 0 && options->wants_report;
    const bool told = asked || (which == 0 && report->members);
    const bool solid = options->voxels.kind == VOXEL_SOLID;
    const bool winds = options->voxels.method == VOXEL_WINDING;
    VoxelFacts facts;
    if (scene->input != VOXEL_MESH)
        return asked ? gp_fail(error, GP_ERROR_INVALID, "--report is for meshes") : GP_OK;
    if (!told && !solid)
        return GP_OK;
    GpResult result = voxel_facts_find(scene, &facts, error);
    if (!result && told)
        result = tell_facts(options, scene, &facts, report, error);
    if (!result && solid)
        warn_if_open(models->pair.names[which], &facts.mesh, winds, report);
    if (!result && solid)
        warn_if_outside(models->pair.names[which], scene, &options->voxels, box, report);
    if (!result && solid && !winds)
        result = warn_if_doubled(models, which, box, &facts.mesh, report, error);
    return result;
}

GpResult voxel_report(void *scene, const void *setting, const Frame *frame, GpDevice *device,
                      TechniqueReport *report, GpError *error)
{
    const VoxelModels *models = scene;
    const VoxelMade *made = frame->made;
    (void)device;
    GpResult result = tell_voxels(&models->pair, frame, report, error);
    for (int i = 0; i < 2 && models->pair.scenes[i] && !result; i++)
        result = look_at_mesh(models, i, setting, &made->pair.boxes[i], report, error);
    return result;
}
