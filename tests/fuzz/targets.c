/* All targets. */
#include "tests/fuzz/targets.h"

const FuzzTarget *const fuzz_targets[] = {
    &fuzz_mesh_off,    &fuzz_mesh_obj,    &fuzz_mesh_ply,    &fuzz_mesh_stl,
    &fuzz_mesh_om,     &fuzz_picture_png, &fuzz_picture_pfm, &fuzz_picture_ppm,
    &fuzz_picture_tga, &fuzz_picture_exr, &fuzz_layers,      &fuzz_volume_nrrd,
    &fuzz_volume_raw,  &fuzz_volume_bits, &fuzz_points_ply,  &fuzz_points_text,
    &fuzz_scene,       &fuzz_transfer,    &fuzz_camera,      &fuzz_rgbd,
    &fuzz_chart,       &fuzz_measured,    &fuzz_cache,       &fuzz_pieces,
    &fuzz_polynomial,  &fuzz_options,     &fuzz_list,        NULL,
};
