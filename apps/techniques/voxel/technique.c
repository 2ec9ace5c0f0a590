#include "apps/techniques/voxel/technique.h"

#include "apps/techniques/voxel/experiments.h"
#include "apps/techniques/voxel/models.h"
#include "apps/techniques/voxel/paper_tables.h"
#include "apps/techniques/voxel/report.h"

const Technique voxel_technique = {
    .name = "voxelize",
    .arguments = "MESH",
    .input = "a mesh file",
    .summary = "a mesh as a volume, its surface or its inside",
    .help = "Examples:\n"
            "  glasspipe voxelize builtin:teapot -n 256\n"
            "  glasspipe voxelize builtin:knot --kind solid -o knot.bits\n"
            "  glasspipe voxelize builtin:knot -n 64 --method thin\n"
            "  glasspipe voxelize scenes/models/star.off --kind solid --report\n"
            "  glasspipe voxelize implicit:quartic -n 128 -o quartic.png\n"
            "  glasspipe voxelize 'implicit:x^2 + y^2 = z^2 + 1' --kind solid\n"
            "  glasspipe voxelize builtin:cube --kind solid --with builtin:sphere \\\n"
            "      --fit 1.3 --combine difference -o cut.png\n"
            "  glasspipe voxelize builtin:knot --with builtin:torus \\\n"
            "      --combine collide -o hits.png\n"
            "  glasspipe voxelize builtin:sphere -o ball.nrrd\n"
            "  glasspipe voxelize builtin:knot --scan ball.nrrd -o inside.png\n"
            "  glasspipe voxelize builtin:knot --twist 90 -o twisted.png\n"
            "\n"
            "Turns a model, or two, into a volume, and prints its hash and how many voxels are "
            "set; or draws a picture of the volume.\v"
            "MESH is OFF, OBJ, PLY, STL or OM, whose vertices are points where it has no faces; "
            "builtin:NAME; implicit:quartic, or implicit: and a polynomial in x, y and z that is "
            "below 0 inside; or parametric:NAME, sphere, torus, moebius, klein or teapot. A "
            "solid of a mesh that is not closed comes with a warning, and so does one of parts "
            "that overlap: counting triangles leaves those hollow, --method winding full. With "
            "--json the volume is made a second time, which is the one that is timed.",
    .settings = voxel_settings,
    .defaults = &voxel_option_defaults,
    .setting_bytes = sizeof(VoxelOptions),
    .experiments = voxel_experiments,
    .scaling = &voxel_scaling,
    .tables = voxel_tables,
    .check = voxel_options_check,
    .open = voxel_models_open,
    .close = voxel_models_close,
    .build = voxel_models_build,
    .resolve = voxel_models_resolve,
    .volume = voxel_models_volume,
    .show = voxel_models_show,
    .report = voxel_report,
};
